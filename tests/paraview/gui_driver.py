"""Drives ParaView's client through the library of GuiDriver.cxx, with helpers for tests in the
client."""
import ctypes
import os
import sys
import traceback

import numpy as np
from paraview import simple

gui = ctypes.PyDLL(os.environ["GUI_DRIVER"])
gui.gui_time_of_move.restype = gui.gui_number.restype = ctypes.c_double
gui.gui_type.argtypes = [ctypes.c_int, ctypes.c_int, ctypes.c_double]
for function in gui.gui_help, gui.gui_undo_label, gui.gui_messages, gui.gui_label, gui.gui_log:
    function.restype = ctypes.c_char_p
for function in gui.gui_click, gui.gui_picture, gui.gui_open, gui.gui_save, gui.gui_select, gui.gui_trigger, gui.gui_select_choice, gui.gui_abort_enabled, gui.gui_log_is_open, gui.gui_type_side, gui.gui_type_text, gui.gui_set_box:
    function.restype = ctypes.c_bool
gui.gui_listen()


def check(condition, message):
    if not condition:
        raise AssertionError(message)


def check_equal(found, expected, what):
    check(found == expected, "%s: %r, not %r" % (what, found, expected))


def wait(milliseconds=100):
    gui.gui_wait(milliseconds)


def picture(name, is_whole_window=True):
    wait(300)
    check(gui.gui_picture(os.path.join(os.environ["FOLDER"], name).encode(), is_whole_window), "no picture")


def messages():
    """Returns the warnings and errors for which the client has opened the window Output Messages since
    the last call; those that a text in the view reports are not among them."""
    return gui.gui_messages().decode()


def log():
    """Returns all messages in the window Output Messages, shown or not."""
    return gui.gui_log().decode()


def pixel(view, x, y, z=0):
    renderer = view.GetRenderer()
    renderer.SetWorldPoint(x, y, z, 1)
    renderer.WorldToDisplay()
    return np.array(renderer.GetDisplayPoint()[:2])


def drag(view, path):
    """Drags along points of space, z = 0 by default; yields the seconds of each move, button
    down."""
    path = [tuple(map(int, np.rint(pixel(view, *place)))) for place in path]
    gui.gui_press(*path[0])
    wait()
    for place in path[1:]:
        yield gui.gui_time_of_move(*place)
    gui.gui_release(*path[-1])
    wait()


def apply():
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(400)


def make(name, **inputs):
    """Creates a source, or a filter of the active source, from the menu, and applies it."""
    wait()  # until the menu is updated for the active source
    check(gui.gui_trigger(name.encode()), name + " is not in the menu")
    wait()
    for label, choice in inputs.items():
        check(gui.gui_select_choice(label.encode(), choice.encode()), "no %s for %s" % (choice, name))
    apply()
    return simple.GetActiveSource()


def new_view(**properties):
    """Begins a session with a white view, and returns the view."""
    simple.ResetSession()
    wait(300)
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.SetProperties(view, UseColorPaletteForBackground=0, Background=[1, 1, 1], OrientationAxesVisibility=0, **properties)
    wait(200)
    return view


def run(prefix, names, each, window=None):
    """Calls `each` with every function of `names` whose name starts with `prefix`, then ends the
    client.

    `window` is width, height and panel width of the window. An exception is printed, and a picture
    saved; run_client.py looks for "all well".
    """
    try:
        if window:
            gui.gui_window(*window)
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
    gui.gui_quit()
