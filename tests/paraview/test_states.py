"""Every state of the plugin, loaded in ParaView's client as File > Load State does; started by
run_client.py.

The message window must stay empty and every layout needs a view; pictures are saved for inspection.
"""
import os

import paraview.simple as simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from gui_driver import check, check_equal, drag, gui, log, messages, picture, run, wait

STATES = os.environ["STATES"]
# States that begin with handles to drag.
WITH_HANDLES = "design.py", "place_and_solve.py"


def load(state):
    simple.ResetSession()
    wait(200)
    gui.gui_load_state(os.path.join(STATES, state).encode())
    wait(300)
    for layout in simple.GetLayouts().values():
        check(len(simple.GetViewsInLayout(layout)) > 0, "a layout without views")
    check(len(simple.GetSources()) >= 2, "the state has no pipeline")
    for view in simple.GetRenderViews():
        texts = [str(shown.WindowLocation) for shown in view.Representations
                 if shown.GetXMLName() == "TextSourceRepresentation" and shown.Visibility]
        check_equal(sorted(set(texts)), sorted(texts), "positions of texts, in " + state)
    if state in WITH_HANDLES:
        check(gui.gui_rows() > 0, "the handles of the state are not shown")
    picture(state[:-3] + ".png")
    check_equal(messages(), "", "messages of " + state)


def shares(name):
    """Returns the shares of coloured and of grey pixels in the middle of the view."""
    picture(name, is_whole_window=False)
    reader = vtkPNGReader()
    reader.SetFileName(os.path.join(os.environ["FOLDER"], name))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    pixels = pixels[height // 6:-height // 6, width // 2:-width // 6, :3].astype(int)
    colour = pixels.max(axis=2) - pixels.min(axis=2)
    return (colour > 15).mean(), ((colour < 8) & (pixels.max(axis=2) < 252) & (pixels.min(axis=2) > 100)).mean()


def check_stale_picture(state, path, word, keeps_data):
    """Drags a handle along `path`, whose end admits no result, and back; `word` is of the message
    of the failure, and `keeps_data` is whether the filter keeps its last result itself."""
    load(state)
    view = simple.GetActiveView()
    coloured, grey = shares("fresh_" + state[:-3] + ".png")
    check(coloured > 0.4 and grey < 0.2, "the picture at first: %g %g" % (coloured, grey))
    for steps, isStale in ((path, True), (path[::-1], False)):
        moves = drag(view, steps)
        for _ in range(len(steps) - 1):
            next(moves)
            wait(300)  # a user pauses; the client updates other parts meanwhile
            check_equal(messages(), "", "messages during a drag")
        # The button is still down.
        check_picture(state, isStale)
        for _ in moves:
            pass
        # The text in the view reports the reason, so the window Output Messages stays closed.
        check_equal(messages(), "", "messages after the drag")
        check(not isStale or word in log(), "the log after the drag: " + log())
        check_picture(state, isStale)
    # A picture of another perspective is not kept.
    for _ in drag(view, path):
        pass
    view.CameraParallelScale *= 1.1
    simple.Render()
    wait(300)
    check(keeps_data or shares("zoomed_" + state[:-3] + ".png")[1] < 0.2, "the old picture after zooming")
    messages()


def check_picture(state, isStale):
    coloured, grey = shares("%s_%s.png" % ("stale" if isStale else "fresh", state[:-3]))
    check((coloured < 0.1 and grey > 0.4) if isStale else coloured > 0.4,
          "the picture is %sstale: %g coloured, %g grey" % ("not " if isStale else "", coloured, grey))


def test_stale_pictures():
    """Where singularities admit no result, the last picture stays in grey and a text gives the
    reason."""
    start = 0.4242640687119285
    check_stale_picture("place_and_solve.py", [(start, start), (0, start), (-start, start)], "overlap", False)
    check_stale_picture("design.py", [(0.7, 0.07), (0.9, 0.1), (1.15, 0.1)], "", True)


def test_states():
    wrong = []
    for state in sorted(name for name in os.listdir(STATES) if name.endswith(".py")):
        print(state, flush=True)
        try:
            load(state)
        except AssertionError as error:
            wrong.append("%s: %s" % (state, error))  # the other states are still loaded
    check_equal(wrong, [], "what is wrong with states")


run("test_", globals(), lambda test: test(), (1200, 900, 300))
