"""Aborts long runs in ParaView's client with its button and with Esc; started by run_client.py."""
import os

from paraview.simple import *

from gui_driver import check, check_equal, gui, messages, picture, run, wait

DATA = os.path.join(os.environ["STATES"], "..", "..", "tests", "data")


def long_run():
    """Creates a Quad Mesher that takes many seconds."""
    loops = []
    # A plate with 81 holes, none of which lies on a line with others.
    for i in range(9):
        for j in range(9):
            x, y = i + 0.13 * ((3 * i + 5 * j) % 7 - 3), j + 0.13 * ((5 * i + 2 * j) % 7 - 3)
            loops.append(PolyLineSource(Closed=1, Points=[
                number for a, b in ((0.2, 0), (0.14, 0.14), (0, 0.2), (-0.14, 0.14), (-0.2, 0), (-0.14, -0.14), (0, -0.2), (0.14, -0.14))
                for number in (x + a, y + b, 0)]))
    loops.append(PolyLineSource(Closed=1, Points=[-1, -1, 0, 9, -1, 0, 9, 9, 0, -1, 9, 0]))
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


def check_aborted(mesher, progress):
    # An aborted run also ends with progress 1.
    last = progress[progress.index(1) - 1]
    print("the run ended at progress %.2f" % last)
    check(last < 0.5, "the run was aborted late or not at all: at progress %.2f" % last)
    check_equal(cells(mesher), 0, "quads of an aborted run")
    check_equal(messages(), "", "messages of an aborted run")


def apply_and(mesher, action):
    """Clicks Apply while `action` is sent after a second of the run; returns the values of progress
    of the run, then those of its repetitions by the pipeline, which end at once."""
    progress = []
    algorithm = mesher.GetClientSideObject()
    observer = algorithm.AddObserver("ProgressEvent", lambda *_: progress.append(algorithm.GetProgress()))
    check(not gui.gui_abort_enabled(), "the abort button is enabled before the run")
    gui.gui_during_run(action, 1000)
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(400)
    algorithm.RemoveObserver(observer)
    check(not gui.gui_abort_enabled(), "the abort button is enabled after the run")
    return progress


def test_button_and_escape():
    mesher = long_run()
    check_aborted(mesher, apply_and(mesher, b"button"))
    picture("aborted.png")
    # Apply is enabled and runs the filter again.
    check_aborted(mesher, apply_and(mesher, b"escape"))
    # A change of the input ends the state as well.
    SetProperties(mesher, Input=PlanarDomainSource(registrationName="Disk"))
    Render()
    wait(400)
    check(cells(mesher) > 400, "no quads after aborted runs")
    check_equal(messages(), "", "messages")


def test_other_input_is_discarded():
    ResetSession()
    wait(300)
    mesher = long_run()
    mesher.QuadCount = 500
    before = len(GetSources())
    # A click on Delete during the run would delete the filter; then the run is aborted.
    gui.gui_during_run(b"delete", 500)
    check_aborted(mesher, apply_and(mesher, b"escape"))
    check_equal(len(GetSources()), before, "sources after a click on Delete during a run")


run("test_", globals(), lambda test: test(), (1000, 800, 370))
