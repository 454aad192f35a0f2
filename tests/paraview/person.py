"""A person who uses ParaView's client: the library of Hands.cxx, and what tests in the client need around it."""
import ctypes
import os
import sys
import traceback

import numpy as np
from paraview import simple

hands = ctypes.PyDLL(os.environ["HANDS"])
hands.hands_time_of_move.restype = hands.hands_number.restype = ctypes.c_double
hands.hands_type.argtypes = [ctypes.c_int, ctypes.c_int, ctypes.c_double]
for function in hands.hands_undo_label, hands.hands_messages:
    function.restype = ctypes.c_char_p
for function in hands.hands_click, hands.hands_picture, hands.hands_open, hands.hands_save, hands.hands_select, hands.hands_trigger, hands.hands_take:
    function.restype = ctypes.c_bool
hands.hands_listen()


def check(condition, message):
    if not condition:
        raise AssertionError(message)


def check_equal(found, wanted, what):
    check(found == wanted, "%s: %r, not %r" % (what, found, wanted))


def wait(milliseconds=100):
    hands.hands_wait(milliseconds)


def picture(name, is_whole=True):
    wait(300)
    check(hands.hands_picture(os.path.join(os.environ["FOLDER"], name).encode(), is_whole), "no picture")


def messages():
    """What the client has shown as warnings and errors since the last call."""
    return hands.hands_messages().decode()


def pixel(view, x, y, z=0):
    renderer = view.GetRenderer()
    renderer.SetWorldPoint(x, y, z, 1)
    renderer.WorldToDisplay()
    return np.array(renderer.GetDisplayPoint()[:2])


def drag(view, path):
    """Along places of space, without z in z = 0; yields the seconds of each move, with the button down."""
    path = [tuple(map(int, np.rint(pixel(view, *place)))) for place in path]
    hands.hands_press(*path[0])
    wait()
    for place in path[1:]:
        yield hands.hands_time_of_move(*place)
    hands.hands_release(*path[-1])
    wait()


def run(prefix, names, each, window=None):
    """Calls `each` with every function of `names` whose name begins so, in order, and ends the client.

    `window` is its size: width, height, width of the panel. An exception is told, with a picture; run_client.py looks
    for "all well".
    """
    try:
        if window:
            hands.hands_window(*window)
        wait(500)
        simple.LoadPlugin(os.environ["PLUGIN"], remote=False, ns=names)
        for name, function in [item for item in names.items() if item[0].startswith(prefix)]:
            print(name, flush=True)
            each(function)
        print("all well")
    except BaseException:
        traceback.print_exc()
        picture("failed.png")
    sys.stdout.flush()
    hands.hands_quit()
