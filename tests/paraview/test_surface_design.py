"""From an .stl to quads in ParaView's client, as docs/stl_to_quads.md has it: open, Layout Designer, drag a singularity on the
surface, save for CalculiX; started by run_client.py.

Every action of the user is counted, and pictures of the window are saved for inspection.
"""
import os
import statistics

import numpy as np
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter

from gui_driver import check, check_equal, drag, gui, messages, picture, pixel, run, wait

MOVES = 40
ACTIONS = []


def action(is_done, what):
    ACTIONS.append(what)
    check(is_done, "this failed: " + what)


def write_pebble(file):
    """Writes a smooth closed surface of 20,480 triangles."""
    solid = vtkPlatonicSolidSource()
    solid.SetSolidTypeToIcosahedron()
    divide = vtkLinearSubdivisionFilter()
    divide.SetNumberOfSubdivisions(5)
    divide.SetInputConnection(solid.GetOutputPort())
    divide.Update()
    points = divide.GetOutput().GetPoints()
    places = vtk_to_numpy(points.GetData()).astype(float)
    places /= np.linalg.norm(places, axis=1)[:, None]
    places *= 1 + 0.15 * np.sin(2 * places[:, :1] + 1) * np.cos(3 * places[:, 1:2])
    points.SetData(numpy_to_vtk(places * [1.5, 1, 0.8], deep=True))
    writer = vtkSTLWriter()
    writer.SetFileTypeToBinary()
    writer.SetFileName(file)
    writer.SetInputData(divide.GetOutput())
    writer.Write()


def rows_of(designer):
    """Returns places in space and quarter indices."""
    designer.UpdatePropertyInformation()
    rows = np.reshape(designer.GetProperty("Rows"), (-1, 4))
    return rows[:, [0, 1, 3]], rows[:, 2]


def field(designer, name, port=0):
    return designer.GetClientSideObject().GetOutputDataObject(port).GetFieldData().GetAbstractArray(name).GetValue(0)


def cells(designer, port):
    return designer.GetClientSideObject().GetOutputDataObject(port).GetNumberOfCells()


def step_open(view):
    file = os.path.join(os.environ["FOLDER"], "pebble.stl")
    write_pebble(file)
    action(gui.gui_open(file.encode(), None), "open the file")
    action(gui.gui_click(b"Apply"), "Apply")
    wait()


def step_design(view):
    action(gui.gui_trigger(b"Layout Designer"), "Layout Designer in the menu")
    action(gui.gui_click(b"Apply"), "Apply")
    wait(500)
    designer = GetActiveSource()
    places, quarters = rows_of(designer)
    check_equal((quarters.sum(), field(designer, "Stale"), gui.gui_rows()), (8, 0, len(places)), "the proposal")
    check(cells(designer, 3) > 800, "%d quads" % cells(designer, 3))


def towards_eye(view, places):
    """Returns how much places are on the side of the eye, from −1 to 1."""
    sight = np.array(view.CameraPosition) - view.CameraFocalPoint
    return (places - view.CameraFocalPoint) @ sight / np.linalg.norm(sight)


def step_drag(view):
    designer = GetActiveSource()
    places, _ = rows_of(designer)
    height = towards_eye(view, places)
    chosen, hidden = int(height.argmax()), int(height.argmin())
    # One on the far side has no handle.
    camera = list(view.CameraPosition)
    far = [places[hidden], places[hidden]]
    for _ in drag(view, far):
        pass
    check_equal((list(view.CameraPosition), gui.gui_chosen()), (camera, -1), "what a click beside the handles does")
    # On a circle around the middle of the view.
    middle = np.array(view.CameraFocalPoint)
    axis = np.array(view.CameraPosition) - middle
    axis /= np.linalg.norm(axis)
    path = []
    for i in range(MOVES + 1):
        angle = 0.35 * i / MOVES
        from_axis = places[chosen] - middle
        along = axis * (from_axis @ axis)
        path.append(middle + along + np.cos(angle) * (from_axis - along) + np.sin(angle) * np.cross(axis, from_axis))
    times, seen = [], None
    for seconds in drag(view, path):
        times.append(seconds)
        check_equal((designer.Dragging, field(designer, "Stale")), (1, 0), "Dragging and stale during a drag")
        lines = vtk_to_numpy(designer.GetClientSideObject().GetOutputDataObject(0).GetPoints().GetData()).copy()
        check(not np.array_equal(lines, seen), "the separatrices did not follow a move")
        seen = lines
        if len(times) == MOVES:
            picture("dragging.png")
    ACTIONS.append("drag a singularity")
    wait(500)
    moved, _ = rows_of(designer)
    check_equal((designer.Dragging, field(designer, "Stale")), (0, 0), "Dragging and stale after a drag")
    check(np.abs(pixel(view, *moved[chosen]) - pixel(view, *path[-1])).max() <= 2, "it is where the mouse is")
    shape = moved[chosen] / [1.5, 1, 0.8]
    direction = shape / np.linalg.norm(shape)
    radius = 1 + 0.15 * np.sin(2 * direction[0] + 1) * np.cos(3 * direction[1])
    check(abs(np.linalg.norm(shape) - radius) < 0.02, "it is on the surface")
    check_equal(np.delete(moved, chosen, 0).tolist(), np.delete(places, chosen, 0).tolist(), "the others")
    check(cells(designer, 3) > 800, "quads after the drag")
    print("frames while dragging: median %.0f ms, from %.0f to %.0f ms" % tuple(
        1e3 * t for t in (statistics.median(times), min(times), max(times))))


def step_add(view):
    """Rows of a new pair are on the surface, and undo removes them."""
    designer = GetActiveSource()
    before, _ = rows_of(designer)
    check(gui.gui_click(b"Add pair"), "no button Add pair")
    wait(500)
    places, quarters = rows_of(designer)
    check_equal((len(places), quarters.sum(), list(quarters[-2:])), (len(before) + 2, 8, [1, -1]), "the pair")
    shapes = places[-2:] / [1.5, 1, 0.8]
    directions = shapes / np.linalg.norm(shapes, axis=1)[:, None]
    radii = 1 + 0.15 * np.sin(2 * directions[:, 0] + 1) * np.cos(3 * directions[:, 1])
    check(abs(np.linalg.norm(shapes, axis=1) - radii).max() < 0.02, "the pair is on the surface")
    gui.gui_undo()
    wait(500)
    check_equal(len(rows_of(designer)[0]), len(before), "rows after undo")


def step_save(view):
    file = os.path.join(os.environ["FOLDER"], "pebble.inp")
    action(gui.gui_select(b"Quads"), "select Quads in the Pipeline Browser")
    wait()
    action(gui.gui_save(file.encode(), None, None), "save the quads")
    with open(file, encoding="utf-8") as made:
        text = made.read()
    check("TYPE=S4" in text.upper().replace(" ", ""), "no shells in the file")
    check(len(ACTIONS) <= 12, "actions: %s" % ACTIONS)
    print("%d actions" % len(ACTIONS))


def step_state(view):
    """A state with the part has the same rows and layout."""
    designer = GetActiveSource()
    places, _ = rows_of(designer)
    faces = field(designer, "Faces")
    file = os.path.join(os.environ["FOLDER"], "pebble.pvsm")
    SaveState(file)
    ResetSession()
    wait(300)
    LoadState(file)
    wait(500)
    designer = [source for source in GetSources().values() if source.GetXMLName() == "LayoutDesigner"][0]
    designer.UpdatePipeline()
    again, _ = rows_of(designer)
    check(np.abs(again - places).max() < 1e-12, "the rows of the state")
    check_equal(field(designer, "Faces"), faces, "the patches of the state")


def run_step(step):
    view = GetActiveViewOrCreate("RenderView")
    SetProperties(view, UseColorPaletteForBackground=0, Background=[1, 1, 1], OrientationAxesVisibility=0)
    step(view)
    picture(step.__name__[5:] + ".png")
    check_equal(messages(), "", "messages of " + step.__name__)


run("step_", globals(), run_step, (1400, 900, 370))
