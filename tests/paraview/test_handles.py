"""Handles of singularities in ParaView's client; started by run_client.py.

The library of GuiDriver.cxx sends mouse events, clicks buttons and types into the table. Pictures
of the window are saved for visual inspection.
"""
import os
import statistics

import numpy as np
from paraview import servermanager, smtrace
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

from gui_driver import check, check_equal, drag, gui, picture, pixel, run, wait

MOVES = 60
ROWS = [0.4242640687119285, 0.4242640687119285, 1, 0.1, -0.4242640687119285, 0.4242640687119285, 1, 0.1,
        -0.4242640687119285, -0.4242640687119285, 1, 0.1, 0.4242640687119285, -0.4242640687119285, 1, 0.1]


class Scene:
    """The disk with its default singularities and their separatrices in the active view."""

    def __init__(self):
        self.view = GetActiveViewOrCreate("RenderView")
        SetProperties(self.view, UseColorPaletteForBackground=0, Background=[1, 1, 1],
                      OrientationAxesVisibility=0)
        self.domain = PlanarDomainSource(registrationName="Domain")
        self.source = SingularitySource(registrationName="Singularities")
        flat = CrossFieldMap(registrationName="Map", Input=self.domain, Singularities=self.source)
        self.lines = Separatrices(registrationName="Separatrices", Input=flat)
        for drawn, colour, width in ((self.domain, [0, 0, 0], 3), (self.lines, [0.1, 0.5, 0.3], 2)):
            shown = Show(drawn, self.view)
            SetProperties(shown, ColorArrayName=["POINTS", ""], AmbientColor=colour, DiffuseColor=colour, LineWidth=width)
        self.view.ResetCamera()
        Render()
        self.choose()
        self.runs = 0
        self.lines.GetClientSideObject().AddObserver("EndEvent", self.count)

    def count(self, *_):
        self.runs += 1

    def choose(self, proxy=None):
        SetActiveSource(proxy or self.source)
        wait()

    def rows(self):
        return list(self.source.Singularities)

    def row(self, i):
        return self.rows()[4 * i:4 * i + 4]

    def pixel(self, x, y):
        return pixel(self.view, x, y)

    def drawn(self):
        """Returns the points of the separatrices now in the pipeline, without an update."""
        data = self.lines.GetClientSideObject().GetOutputDataObject(0)
        return vtk_to_numpy(data.GetPoints().GetData()).copy()

    def handles(self):
        """Returns the number of handles in the view."""
        actors = self.view.GetClientSideObject().GetNonCompositedRenderer().GetActors2D()
        coloured = 0
        for i in range(actors.GetNumberOfItems()):
            mapper = actors.GetItemAsObject(i).GetMapper()
            drawing = mapper.GetInput() if mapper and mapper.IsA("vtkPolyDataMapper2D") else None
            # Only handles are drawn with transparent colours.
            coloured += bool(drawing and drawing.GetPointData().GetScalars()
                             and drawing.GetPointData().GetScalars().GetNumberOfComponents() == 4)
        return coloured

    def drag(self, start, end, moves=3):
        """Drags along a straight line."""
        start, end = np.array(start), np.array(end)
        return drag(self.view, [start + (end - start) * i / moves for i in range(moves + 1)] if moves else [start])


def test_drag(scene):
    check_equal(scene.rows(), ROWS, "the rows at first")
    check_equal(gui.gui_rows(), 4, "the rows of the table")
    picture("start.png")
    times, seen = [], [scene.drawn()]
    shown = scene.view.GetClientSideObject()
    gui.gui_count_updates(b"Separatrices")
    end = -0.05, 0.15  # each move is longer than a pixel
    for seconds in scene.drag(ROWS[:2], end, MOVES):
        times.append(seconds)
        check(not np.array_equal(scene.drawn(), seen[-1]), "the separatrices did not follow a move")
        seen.append(scene.drawn())
        check_equal(gui.gui_number(0, 0), scene.row(0)[0], "the table while dragging")
        # Slow updates of the client wait until the handle is released.
        check_equal((gui.gui_updates(), shown.GetUseFXAA()), (0, False), "panel updates and anti-aliasing while dragging")
        if len(times) == MOVES // 2:
            picture("dragging.png")
    check_equal((gui.gui_updates(), shown.GetUseFXAA()), (1, True), "panel updates and anti-aliasing after a drag")
    check_equal(scene.runs, MOVES + 1, "runs of the pipeline, one for each move and for the end")
    check(abs(scene.pixel(*scene.row(0)[:2]) - scene.pixel(*end)).max() <= 1, "the final position")
    check_equal(scene.rows()[2:4] + scene.rows()[4:], ROWS[2:4] + ROWS[4:], "the rest of the rows")
    check_equal(gui.gui_chosen(), 0, "the row chosen by the drag")
    picture("dragged.png")
    print("frames of a drag: median %.0f ms, from %.0f to %.0f ms" % tuple(
        1e3 * t for t in (statistics.median(times), min(times), max(times))))


def test_undo(scene):
    moved = scene.rows()
    check_equal(gui.gui_undo_label(), b"Move Singularity", "what would be undone")
    gui.gui_undo()
    wait()
    check_equal(scene.rows(), ROWS, "the rows after undo")
    check_equal(gui.gui_number(0, 0), ROWS[0], "the table after undo")
    gui.gui_redo()
    wait()
    check_equal(scene.rows(), moved, "the rows after redo")
    gui.gui_undo()
    wait()


def test_other_item_chosen(scene):
    check_equal(scene.handles(), 4, "handles")
    scene.choose(scene.domain)
    check_equal(scene.handles(), 0, "handles of an item that is not chosen")
    camera = list(scene.view.CameraPosition)
    for _ in scene.drag(ROWS[:2], (0.2, 0.5)):
        pass
    check_equal(scene.rows(), ROWS, "the rows after a drag without handles")
    check(list(scene.view.CameraPosition) != camera, "the mouse did not turn the camera")
    ResetCamera(scene.view)
    scene.choose()
    check_equal(scene.handles(), 4, "handles of the item chosen again")
    # From an oblique camera, the handle stays in the plane and under the mouse.
    for _ in scene.drag(ROWS[4:6], (-0.2, 0.3)):
        pass
    check(abs(scene.pixel(*scene.row(1)[:2]) - scene.pixel(-0.2, 0.3)).max() <= 1, "the final position")
    picture("aside.png")
    gui.gui_undo()
    SetProperties(scene.view, CameraPosition=[0, 0, 6], CameraFocalPoint=[0, 0, 0], CameraViewUp=[0, 1, 0])
    ResetCamera(scene.view)
    wait()


def test_click_moves_nothing(scene):
    runs = scene.runs
    for _ in scene.drag(ROWS[8:10], ROWS[8:10], 0):
        pass
    check_equal((scene.rows(), scene.runs), (ROWS, runs), "rows and runs after a click")
    check_equal(gui.gui_chosen(), 2, "the row chosen by a click")


def test_pending_moves_are_merged(scene):
    Render()
    runs = scene.runs
    x, y = map(int, np.rint(scene.pixel(*ROWS[:2])))
    gui.gui_press(x, y)
    for i in range(1, 11):
        gui.gui_move(x + 2 * i, y, True)
    wait()
    check_equal(scene.runs, runs + 1, "runs of ten moves that arrived together")
    check(abs(scene.pixel(*scene.row(0)[:2]) - [x + 20, y]).max() <= 1, "the place of the last move")
    gui.gui_release(x + 20, y)
    wait()
    gui.gui_undo()
    wait()
    check_equal(scene.rows(), ROWS, "the rows after undo")


def test_live_off(scene):
    check(gui.gui_click(b"Live"), "no box")
    for _ in scene.drag(ROWS[:2], (0.3, 0.3)):
        check_equal(scene.rows(), ROWS, "the rows while dragging with Live off")
    check(abs(scene.pixel(*scene.row(0)[:2]) - scene.pixel(0.3, 0.3)).max() <= 1, "the final position")
    gui.gui_click(b"Live")
    gui.gui_undo()
    wait()
    check_equal(scene.rows(), ROWS, "the rows after undo")


def test_buttons(scene):
    gui.gui_choose(0)
    check(gui.gui_click(b"Add pair"), "no button")
    rows = np.array(scene.rows()).reshape(-1, 4)
    check_equal(list(rows[:, 2]), [1, 1, 1, 1, 1, -1], "the quarter indices with a pair")
    apart = [abs(a - b).max() for i, a in enumerate(rows[:, :2]) for b in rows[:i, :2]]
    check(min(apart) > 0.05, "a new singularity coincides with another")
    check_equal(scene.handles(), 6, "handles with a pair")
    picture("pair.png")
    check(gui.gui_click(b"Add"), "no button")
    check_equal(scene.row(6)[2:], [1, 0.1], "what Add adds")
    gui.gui_undo()
    gui.gui_undo()
    wait()
    check_equal(scene.rows(), ROWS, "the rows after undo of both")
    check_equal(scene.handles(), 4, "handles after undo of both")


def test_remove(scene):
    scene.source.Singularities = [-0.5, 0, 1, 0.1, 0, 0, -1, 0.1, 0.5, 0, 1, 0.1]
    wait()
    check_equal((gui.gui_rows(), scene.handles()), (3, 3), "what Python has set in table and view")
    gui.gui_choose(1)
    check(gui.gui_click(b"Remove"), "no button")
    check_equal(scene.rows(), [-0.5, 0, 1, 0.1, 0.5, 0, 1, 0.1], "the rows after the middle one is removed")
    for _ in range(2):
        check(gui.gui_click(b"Remove"), "no button")
    check_equal((scene.rows(), scene.handles()), ([], 0), "rows and handles without any")
    check(not gui.gui_click(b"Remove"), "nothing is left to remove")
    gui.gui_click(b"Add")
    check_equal(scene.row(0)[2:], [1, 0.1], "the first row")
    check(np.hypot(*scene.row(0)[:2]) < 0.05, "the first row is not in the middle of the view")
    scene.source.Singularities = ROWS
    wait()


def test_typed_numbers(scene):
    gui.gui_type(1, 2, -1)
    gui.gui_type(0, 0, 0.25)
    expected = list(ROWS)
    expected[6], expected[0] = -1, 0.25
    check_equal(scene.rows(), expected, "the rows with numbers typed, the others with all digits")
    gui.gui_undo()
    gui.gui_undo()
    wait()
    check_equal(scene.rows(), ROWS, "the rows after undo")


def test_trace(scene):
    smtrace.start_trace()
    try:
        for _ in scene.drag(ROWS[:2], (0.2, 0.5)):
            pass
    finally:
        trace = smtrace.stop_trace()
    lines = [line for line in trace.splitlines() if "Singularities = [" in line]
    check_equal(len(lines), 1, "the lines of the trace about a drag:\n" + trace)
    check("%r" % scene.row(0)[0] in lines[0], "the trace has another place: " + lines[0])
    gui.gui_undo()
    wait()


def test_rows_that_are_ignored(scene):
    for name, value, usual in ("FileName", "/none.csv", ""), ("UseHandles", 1, 0):
        setattr(scene.source, name, value)
        wait()
        check_equal(scene.handles(), 0, "handles with " + name)
        check(not gui.gui_click(b"Add"), "a button can be clicked with " + name)
        setattr(scene.source, name, usual)
        wait()
        check_equal(scene.handles(), 4, "handles without " + name)


def test_other_view(scene):
    layout = GetLayout()
    table = CreateView("SpreadSheetView")
    AssignViewToLayout(view=table, layout=layout, hint=0)
    SetActiveView(table)
    wait()
    check_equal(scene.handles(), 0, "handles in a view that is not active")
    check(gui.gui_click(b"Add"), "no button beside a table")
    check_equal(len(scene.rows()), 20, "numbers after Add beside a table")
    gui.gui_undo()
    SetActiveView(scene.view)
    Delete(table)
    wait()
    check_equal((scene.rows(), scene.handles()), (ROWS, 4), "rows and handles in the view again")


def test_deleted(scene):
    other = SingularitySource(registrationName="Other")
    Show(other, scene.view)
    scene.choose(other)
    check_equal(scene.handles(), 4, "handles of another source")
    times = list(scene.drag(ROWS[:2], (-0.05, 0.15), MOVES))
    check(other.Singularities[0] < 0.1, "the handle of another source is not dragged")
    print("frames of a drag with no pipeline downstream: median %.0f ms" % (1e3 * statistics.median(times)))
    Delete(other)
    wait()
    check_equal(scene.handles(), 0, "handles of a source that is deleted")


def test_designer(scene):
    designer = LayoutDesigner(registrationName="Designer", Input=scene.domain)
    HideAll(scene.view)
    shown = Show(designer, scene.view)
    SetProperties(shown, LineWidth=3)
    Render()
    scene.choose(designer)
    scene.source = designer
    check_equal(scene.rows(), [], "the rows of a designer that chooses")
    chosen = np.reshape(designer.GetProperty("Rows"), (-1, 4))
    check_equal((gui.gui_rows(), scene.handles()), (len(chosen), len(chosen)), "chosen rows in table and view")
    # After a drag the rows belong to the user.
    end = chosen[0, :2] + [0.05, 0.02]
    times = list(scene.drag(chosen[0, :2], end, MOVES // 4))
    check(abs(scene.pixel(*scene.row(0)[:2]) - scene.pixel(*end)).max() <= 1, "the final position")
    check_equal(scene.rows()[4:], list(chosen[1:].ravel()), "the other rows")
    print("frames of a drag of the designer: median %.0f ms" % (1e3 * statistics.median(times)))
    # A command moves the rows; they become the value of the property.
    moved = scene.rows()
    check(gui.gui_click(b"Optimise"), "no button of the designer")
    wait(300)
    found = np.reshape(designer.GetProperty("Rows"), (-1, 4))
    check(abs(found - np.reshape(moved, (-1, 4))).max() > 0.01, "Optimise has moved nothing")
    check_equal(scene.rows(), list(found.ravel()), "the property after a command")
    check_equal(gui.gui_number(0, 0), found[0, 0], "the table after a command")
    gui.gui_undo()
    wait()
    check_equal(scene.rows(), moved, "the rows after undo of a command")


def test_state_of_the_designer(scene):
    SetActiveView(None)
    CreateLayout("Design")
    names = dict(globals())
    with open(os.path.join(os.environ["STATES"], "design.py"), encoding="utf-8") as state:
        exec(state.read(), names)
    scene.view, scene.source = names["view"], names["designer"]
    SetActiveView(scene.view)
    Render()
    scene.choose(OutputPort(scene.source, 0))
    check_equal(scene.handles(), 8, "handles of the state")
    start = scene.row(6)[:2]
    times = []
    for seconds in scene.drag(start, (start[0] - 0.1, start[1] + 0.4), MOVES // 2):
        times.append(seconds)
        if len(times) == MOVES // 4:
            picture("design.png")
    print("frames of a drag in the designer's state: median %.0f ms" % (1e3 * statistics.median(times)))


scenes = []


def run_in_scene(test):
    if not scenes:
        scenes.append(Scene())
    test(scenes[0])


run("test_", globals(), run_in_scene)
