"""Layout Designer in ParaView's client: nodes that moved away from the handles, colours of patches,
and merged blocks; started by run_client.py."""
import math

import numpy as np
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

from gui_driver import check, check_equal, drag, gui, messages, new_view, picture, run, wait

HOLES = (0.9, 0.9, 0.25), (2.9, 0.8, 0.3), (2.0, 2.1, 0.2)
# Quads with nodes at these places, which were drawn at random, would be inverted.
RANDOM = [1.1, 0.18, 1.26, 1.98, 3.5, 1.93, 1.79, 2.56, 0.88, 1.31, 3.13, 2.62, 3.41, 1.19, 2.31, 1.0, 0.65, 1.49,
          3.25, 2.44, 2.78, 2.72, 1.17, 0.61]


def plate():
    loops = [PolyLineSource(Closed=1, Points=[0, 0, 0, 4, 0, 0, 4, 3, 0, 0, 3, 0])]
    for x, y, radius in HOLES:
        loops.append(PolyLineSource(Closed=1, Points=[
            value for i in range(24) for value in (x + radius * math.cos(i * math.pi / 12), y + radius * math.sin(i * math.pi / 12), 0)]))
    return AppendGeometry(registrationName="Plate", Input=loops)


def make(domain):
    """Creates a designer of a domain from the menu."""
    Show(domain)
    Render()
    ResetCamera()
    SetActiveSource(domain)
    wait()
    check(gui.gui_trigger(b"Layout Designer"), "no Layout Designer in the menu")
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(500)
    Hide(domain)
    return GetActiveSource()


def output(designer, port):
    return designer.GetClientSideObject().GetOutputDataObject(port)


def text(designer):
    """Returns the text in the view."""
    found = [shown for shown in GetActiveView().Representations
             if shown.GetXMLName() == "TextSourceRepresentation" and shown.Visibility]
    check_equal(len(found), 1, "texts in the view")
    return " ".join(found[0].GetClientSideObject().GetTextWidgetRepresentation().GetRepresentation().GetText().split())


def nodes(designer):
    return vtk_to_numpy(output(designer, 2).GetPoints().GetData())[:, :2].copy()


def handles(designer):
    designer.UpdatePropertyInformation()
    return np.reshape(designer.GetProperty("Rows"), (-1, 4))[:, :2]


def colours(designer):
    """Returns centre, number of triangles and colour of each patch."""
    patches = output(designer, 1)
    colour, face = (vtk_to_numpy(patches.GetCellData().GetArray(name)) for name in ("Colour", "FaceId"))
    points = vtk_to_numpy(patches.GetPoints().GetData())[:, :2]
    triangles = points[vtk_to_numpy(patches.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    sides = triangles[:, 1:] - triangles[:, :1]
    areas = abs(np.linalg.det(sides)) / 2
    centres = triangles.mean(axis=1)
    found = {}
    for number in np.unique(face):
        own = face == number
        check(areas[own].sum() >= 0 and len(set(colour[own])) == 1, "several colours on a patch")
        found[number] = (np.average(centres[own], axis=0, weights=areas[own] + 1e-30), areas[own].sum(), colour[own][0])
    return found


def test_nodes_that_moved(view):
    designer = make(plate())
    SetProperties(designer, QuadCount=500, Singularities=[value for i in range(12) for value in (*RANDOM[2 * i:2 * i + 2], -1, 0.1)])
    Render()
    wait(500)
    moves = np.linalg.norm(nodes(designer) - handles(designer), axis=1)
    check(moves.max() > 0.3, "no node has moved: %g" % moves.max())
    check("nodes moved by up to %.2g from their handles" % moves.max() in text(designer), "the text: " + text(designer))
    check_equal(np.reshape(RANDOM, (-1, 2)).tolist(), handles(designer).tolist(), "the handles")
    # The nodes are irregular points of the quads.
    quads = output(designer, 3)
    irregular = vtk_to_numpy(quads.GetPoints().GetData())[vtk_to_numpy(quads.GetPointData().GetArray("Irregular")) != 0][:, :2]
    check(max(abs(irregular - node).sum(axis=1).min() for node in nodes(designer)) < 1e-9, "points are not at the nodes")
    picture("moved_nodes.png", is_whole_window=False)
    # Drafts have their nodes at the handles.
    start = handles(designer)[7]
    for i, _ in enumerate(drag(view, [start + [0.02 * step, 0] for step in range(4)])):
        if i == 2:
            rows = np.reshape(list(designer.Singularities), (-1, 4))
            check(abs(nodes(designer) - rows[:, :2]).max() < 1e-9, "drafts are not at the handles")
    gui.gui_undo()
    wait(500)
    check("nodes moved by" in text(designer), "the text after undo: " + text(designer))


def test_colours(view):
    designer = make(PlanarDomainSource())
    SetProperties(designer, Singularities=[0.7, 0.07, 1, 0.05, 0.29, 0.64, 1, 0.05, -0.41, 0.57, 1, 0.05, -0.7, -0.07, 1, 0.05,
                                           -0.29, -0.64, 1, 0.05, 0.41, -0.57, 1, 0.05, 0.2, 0.02, -1, 0.05, -0.2, -0.02, -1, 0.05])
    Render()
    wait(500)
    before = colours(designer)
    check(len(set(colour for _, _, colour in before.values())) >= 3, "few colours")
    picture("colours_0.png", is_whole_window=False)
    kept = total = 0
    for i, _ in enumerate(drag(view, [(0.7 - 0.01 * step, 0.07 + 0.01 * step) for step in range(11)])):
        after = colours(designer)
        for centre, area, colour in before.values():
            nearest = min(after.values(), key=lambda patch: np.linalg.norm(patch[0] - centre))
            kept += area * (nearest[2] == colour)
            total += area
        before = after
        if i in (4, 9):
            picture("colours_%d.png" % (i + 1), is_whole_window=False)
    check(kept > 0.97 * total, "only %g of the area keeps its colour from move to move" % (kept / total))
    gui.gui_type(0, 0, 3)
    wait(500)
    check_equal({colour for _, _, colour in colours(designer).values()}, {-1}, "colours with a singularity outside")
    picture("outside.png", is_whole_window=False)


def test_merged_blocks(view):
    designer = make(PlanarDomainSource())
    rows = [0.5, 0.35, 1, 0.1]
    for i in (1, 2, 3):
        rows += [0.6 * math.cos(math.pi * (2 * i + 1) / 4), 0.6 * math.sin(math.pi * (2 * i + 1) / 4), 1, 0.1]
    SetProperties(designer, Singularities=rows, QuadSize=0.03)
    Render()
    wait(500)
    blocks = []
    for choice in b"None", b"Clean", b"Coarse":
        if choice != b"None":
            check(gui.gui_select_choice(b"Merge", choice), "no choice of merging in the panel")
            check(gui.gui_click(b"Apply"), "no Apply")
            wait(500)
        blocks.append(int(output(designer, 4).GetFieldData().GetArray("Blocks").GetValue(0)))
        check("in %d blocks" % blocks[-1] in text(designer), "the text: " + text(designer))
        picture("merge_%s.png" % choice.decode().lower(), is_whole_window=False)
    check(blocks[1] < blocks[0] and blocks[2] < blocks[0], "blocks without and with merging: %s" % blocks)
    check_equal(list(designer.Singularities), rows, "the rows")


def check_undo_of(command, designer):
    """Checks that a command, a button, is one step of undo and redo while rows are computed."""
    start = handles(designer).copy()
    check_equal((list(designer.Singularities), gui.gui_rows()), ([], len(start)), "rows of the property and the table")
    check(gui.gui_click(command), "no button")
    wait(800)
    moved = handles(designer).copy()
    check(abs(moved - start).max() > 1e-3, "%s has moved nothing" % command)
    check_equal(gui.gui_undo_label(), command, "what would be undone")
    check(abs(np.reshape(list(designer.Singularities), (-1, 4))[:, :2] - moved).max() < 1e-9, "the property after %s" % command)
    gui.gui_undo()
    wait(800)
    check_equal((list(designer.Singularities), gui.gui_rows()), ([], len(start)), "rows after undo of %s" % command)
    check(abs(handles(designer) - start).max() < 1e-9, "the handles after undo of %s" % command)
    gui.gui_redo()
    wait(800)
    check(abs(handles(designer) - moved).max() < 1e-9, "the handles after redo of %s" % command)
    gui.gui_undo()
    wait(800)


def test_undo_of_commands(view):
    """Each command is one undo step, also while the rows are those that were chosen."""
    domain = plate()
    designer = make(domain)
    # A command that changes nothing is no step.
    before = gui.gui_undo_label()
    check(gui.gui_click(b"Propose"), "no button Propose")
    wait(500)
    check_equal((list(designer.Singularities), gui.gui_undo_label()), ([], before), "rows and undo step after Propose")
    designer.SnapTolerance = 0.3
    designer.UpdateVTKObjects()
    check_undo_of(b"Snap", designer)
    # The rows still follow the domain.
    count = gui.gui_rows()
    domain.Input = domain.Input[:-1]
    Render()
    wait(800)
    check_equal(list(designer.Singularities), [], "the property after a change of the domain")
    check(0 < gui.gui_rows() < count, "%d rows after a hole is removed, %d before" % (gui.gui_rows(), count))


def test_undo_with_a_start(view):
    designer = make(PlanarDomainSource())
    designer.StartFrom = SingularitySource(Singularities=[0.5, 0.35, 1, 0.1, -0.4, 0.4, 1, 0.1, -0.4, -0.4, 1, 0.1, 0.4, -0.4, 1, 0.1])
    SetActiveSource(designer)
    Render()
    wait(500)
    for command in b"Snap", b"Optimise":
        designer.SnapTolerance = 0.2
        check_undo_of(command, designer)
    # Two commands are two steps.
    start = handles(designer).copy()
    for command in b"Optimise", b"Propose", b"Snap":
        check(gui.gui_click(command), "no button")
        wait(800)
        if command == b"Optimise":
            optimised = handles(designer).copy()
    while gui.gui_undo_label() != b"Optimise":
        gui.gui_undo()
        wait(800)
    check(abs(handles(designer) - optimised).max() < 1e-9, "the handles after undo of all but Optimise")
    gui.gui_undo()
    wait(800)
    check(abs(handles(designer) - start).max() < 1e-9, "the handles after undo of all")


def in_new_session(test):
    test(new_view(InteractionMode="2D"))
    check_equal(messages(), "", "messages of " + test.__name__)


run("test_", globals(), in_new_session, (1000, 800, 300))
