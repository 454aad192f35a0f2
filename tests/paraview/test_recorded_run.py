"""Step 7 of docs/tutorial_paraview.md in ParaView's client: open a file, propose, drag, snap, mesh,
save.

Started by run_client.py. Saves pictures of the window after each step, for the page and for
inspection.
"""
import os
import statistics

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_QUAD

from gui_driver import check, check_equal, drag, gui, messages, picture, run, wait
from tutorial_texts import tutorial_picture

MOVES = 60
# The polygon is read from the page.
PAGE = os.path.join(os.environ["STATES"], "..", "..", "docs", "tutorial_paraview.md")


def text(designer, name):
    return servermanager.Fetch(designer).GetFieldData().GetAbstractArray(name).GetValue(0)


def rows_of(designer):
    designer.UpdatePropertyInformation()
    return np.reshape(designer.GetProperty("Rows"), (-1, 4))


def check_summary(view, designer):
    """Checks that the view shows the summary of the layout, black on white."""
    found = [shown for shown in view.Representations if shown.GetXMLName() == "TextSourceRepresentation"]
    check_equal(len(found), 1, "texts in the view")
    drawn = found[0].GetClientSideObject().GetTextWidgetRepresentation().GetRepresentation().GetText()
    check_equal(" ".join(drawn.splitlines()), text(designer, "Summary"), "the text in the view")
    check("quads in" in drawn and "minimum angle" in drawn, "the text has no quality: " + drawn)
    check_equal((list(found[0].Color), found[0].WindowLocation), ([0, 0, 0], "Lower Center"), "how it is drawn")


def step_open(view):
    with open(PAGE, encoding="utf-8") as page:
        polygon = page.read().split("```csv polygon.csv\n")[1].split("```")[0]
    file = os.path.join(os.environ["FOLDER"], "polygon.csv")
    with open(file, "w", encoding="utf-8") as domain:
        domain.write(polygon)
    check(gui.gui_open(file.encode(), b"Planar Domain Reader"), "the domain cannot be opened")
    check(gui.gui_click(b"Apply"), "no Apply for the reader")
    wait()


def step_propose(view):
    check(gui.gui_trigger(b"Layout Designer"), "no Layout Designer in the menu")
    check(gui.gui_click(b"Apply"), "no Apply for the designer")
    wait()
    designer = GetActiveSource()
    check_equal(len(rows_of(designer)), 4, "singularities proposed")
    check_equal((text(designer, "Stale"), gui.gui_rows()), (0, 4), "the layout proposed and the rows of the table")
    check_summary(view, designer)


def step_drag(view):
    designer = GetActiveSource()
    chosen = int(rows_of(designer)[:, 0].argmin())
    start, end = rows_of(designer)[chosen, :2], np.array([-0.9, 0.02])
    # A half circle from the end of the domain, up and inwards.
    angles = np.pi * np.arange(MOVES + 1) / MOVES
    path = [(start + end) / 2 + np.cos(a) * (start - end) / 2 + [0, 0.25 * np.sin(a)] for a in angles]
    times, seen = [], None
    for seconds in drag(view, path):
        times.append(seconds)
        check_equal(designer.Dragging, 1, "Dragging during a drag")
        lines = vtk_to_numpy(designer.GetClientSideObject().GetOutputDataObject(0).GetPoints().GetData()).copy()
        check(not np.array_equal(lines, seen), "the separatrices did not follow a move")
        seen = lines
    check_equal(designer.Dragging, 0, "Dragging after a drag")
    right = int(rows_of(designer)[:, 0].argmax())
    for _ in drag(view, [rows_of(designer)[right, :2], (1.1, 0), (0.9, 0)]):
        pass
    pixel = 2 * view.CameraParallelScale / view.ViewSize[1]
    found = rows_of(designer)
    check(abs(found[chosen, :2] - end).max() <= pixel, "the position of the first: %s" % found[chosen])
    check(abs(found[right, :2] - [0.9, 0]).max() <= pixel, "the position of the second: %s" % found[right])
    check_equal(text(designer, "Stale"), 0, "whether the layout is stale")
    check_summary(view, designer)
    print("frames of the recorded run: median %.0f ms, from %.0f to %.0f ms" % tuple(
        1e3 * t for t in (statistics.median(times), min(times), max(times))))


def step_snap(view):
    designer = GetActiveSource()
    faces = text(designer, "Faces")
    check(gui.gui_click(b"Snap"), "no button of the designer")
    wait(300)
    check_equal((faces, text(designer, "Faces"), text(designer, "Stale")), (9, 5, 0), "faces before and after, and stale")
    # Joined separatrices leave no thin patches.
    check(text(designer, "ShortestArc") > 4, "a short arc is left: %g" % text(designer, "ShortestArc"))
    check_summary(view, designer)


def step_quads(view):
    designer = GetActiveSource()
    for choice, there_are in (b"None", False), (b"Smooth", True):
        check(gui.gui_select_choice(b"Quads", choice), "no choice of quads in the panel")
        check(gui.gui_click(b"Apply"), "no Apply for quads")
        wait()
        quads = designer.GetClientSideObject().GetOutputDataObject(3)
        check_equal(quads.GetNumberOfCells() > 0, there_are, "whether there are quads")
    check_summary(view, designer)


def step_save(view):
    designer = GetActiveSource()
    file = os.path.join(os.environ["FOLDER"], "quads.vtu")
    check(gui.gui_select(b"Quads"), "no output Quads in the Pipeline Browser")
    wait()
    check(gui.gui_save(file.encode(), b"DataMode", b"Binary"), "the quads cannot be saved")
    quads = servermanager.Fetch(OpenDataFile(file))
    types = [quads.GetCellType(i) for i in range(quads.GetNumberOfCells())]
    check_equal(set(types), {VTK_QUAD}, "the types of cells")
    check(900 < len(types) < 1100, "%d quads" % len(types))
    report = designer.GetClientSideObject().GetOutputDataObject(4).GetFieldData()
    obtained, requested, valence = (vtk_to_numpy(report.GetArray(name)).tolist()
                           for name in ("IrregularObtained", "IrregularRequested", "IrregularValence"))
    check_equal(obtained, requested, "irregular nodes")
    check_equal(dict(zip(valence, obtained)).get(3), 4, "nodes of valence 3")
    check_equal(report.GetArray("Inverted").GetValue(0), 0, "inverted quads")


def run_step(step):
    view = GetActiveViewOrCreate("RenderView")
    SetProperties(view, UseColorPaletteForBackground=0, Background=[1, 1, 1], OrientationAxesVisibility=0)
    step(view)
    name = step.__name__[5:]
    if name in ("propose", "drag", "quads"):
        tutorial_picture(name)
    else:
        picture(name + ".png", is_whole_window=False)
    check_equal(messages(), "", "messages of " + step.__name__)


run("step_", globals(), run_step, (960, 800, 370))
