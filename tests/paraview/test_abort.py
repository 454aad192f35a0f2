"""Aborts long runs in ParaView's client with its button and with Esc; started by run_client.py."""
import os
import time

from paraview.simple import *

from gui_driver import check, check_equal, gui, messages, picture, run, wait

DATA = os.path.join(os.environ["STATES"], "..", "..", "tests", "data")


def long_run():
    """Creates a Quad Mesher that takes many seconds."""
    loops = []
    # A plate with 36 holes, none of which lies on a line with others.
    for i in range(6):
        for j in range(6):
            x, y = i + 0.13 * ((3 * i + 5 * j) % 7 - 3), j + 0.13 * ((5 * i + 2 * j) % 7 - 3)
            loops.append(PolyLineSource(Closed=1, Points=[
                number for a, b in ((0.2, 0), (0.14, 0.14), (0, 0.2), (-0.14, 0.14), (-0.2, 0), (-0.14, -0.14), (0, -0.2), (0.14, -0.14))
                for number in (x + a, y + b, 0)]))
    loops.append(PolyLineSource(Closed=1, Points=[-1, -1, 0, 6, -1, 0, 6, 6, 0, -1, 6, 0]))
    domain = AppendGeometry(registrationName="Plate", Input=loops)
    Show(domain)
    Render()
    SetActiveSource(domain)
    wait()
    check(gui.gui_trigger(b"Quad Mesher"), "no Quad Mesher in the menu")
    wait()
    return GetActiveSource()


def cells(mesher):
    return mesher.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()


def check_aborted(mesher, seconds):
    print("the run ended after %.1f s" % seconds)
    check(seconds < 6, "the run was not aborted but took %.1f s" % seconds)
    check_equal(cells(mesher), 0, "quads of an aborted run")
    check_equal(messages(), "", "messages of an aborted run")


def apply_and(action):
    """Clicks Apply while `action` is sent after a second of the run; returns the seconds."""
    check(not gui.gui_abort_enabled(), "the abort button is enabled before the run")
    gui.gui_during_run(action, 1000)
    start = time.monotonic()
    check(gui.gui_click(b"Apply"), "no Apply")
    seconds = time.monotonic() - start
    wait(400)
    check(not gui.gui_abort_enabled(), "the abort button is enabled after the run")
    return seconds


def test_button_and_escape():
    mesher = long_run()
    check_aborted(mesher, apply_and(b"button"))
    picture("aborted.png")
    # Apply is enabled and runs the filter again.
    check_aborted(mesher, apply_and(b"escape"))
    # Other input is discarded during a run and does not abort it.
    mesher.QuadCount = 600
    mesher.Singularities = None
    SetProperties(mesher, Input=PlanarDomainSource(registrationName="Disk"))
    wait()
    check(gui.gui_click(b"Apply") or cells(mesher) > 0, "no Apply after aborted runs")
    Render()
    wait(400)
    check(cells(mesher) > 400, "no quads after aborted runs")
    check_equal(messages(), "", "messages")


run("test_", globals(), lambda test: test(), (1000, 800, 370))
