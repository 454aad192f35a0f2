"""The panels of Quad Mesher and Layout Designer in ParaView's client, with the actions of a user counted; started by
run_client.py."""
import math
import os

from paraview.simple import *
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter

from gui_driver import check, check_equal, gui, messages, new_view, picture, run, wait

ACTIONS = []


def action(is_done, what):
    ACTIONS.append(what)
    check(is_done, "this failed: " + what)
    wait(300)


def show(source):
    Show(source)
    Render()
    ResetCamera()
    SetActiveSource(source)
    wait()


def ring():
    loops = [PolyLineSource(Closed=1, Points=[value for i in range(48) for value in (
        radius * math.cos(i * math.pi / 24), radius * math.sin(i * math.pi / 24), 0)]) for radius in (2, 1)]
    return AppendGeometry(registrationName="Ring", Input=loops)


def edges_of(mesher, side):
    boundary = mesher.GetClientSideObject().GetOutputDataObject(5)
    names = boundary.GetCellData().GetAbstractArray("Side")
    return sum(names.GetValue(i) == side for i in range(names.GetNumberOfValues()))


def test_slice_of_an_stl(view):
    ball = vtkSphereSource()
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(24)
    writer = vtkSTLWriter()
    file = os.path.join(os.environ["FOLDER"], "ball.stl")
    writer.SetFileName(file)
    writer.SetInputConnection(ball.GetOutputPort())
    writer.Write()
    action(gui.gui_open(file.encode(), None), "open the file")
    action(gui.gui_click(b"Apply"), "Apply")
    action(gui.gui_trigger(b"Slice"), "Slice")
    action(gui.gui_click(b"Apply"), "Apply")
    action(gui.gui_trigger(b"Quad Mesher"), "Quad Mesher")
    action(gui.gui_click(b"Apply"), "Apply")
    quads = GetActiveSource().GetClientSideObject().GetOutputDataObject(0)
    check(900 < quads.GetNumberOfCells() < 1100, "%d quads" % quads.GetNumberOfCells())
    check(len(ACTIONS) <= 8, "actions: %s" % ACTIONS)


def make_mesher():
    show(ring())
    check(gui.gui_trigger(b"Quad Mesher"), "no Quad Mesher in the menu")
    wait()
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(500)
    return GetActiveSource()


def test_edges_of_a_side(view):
    mesher = make_mesher()
    check(edges_of(mesher, "hole0") != 24, "there are 24 edges already")
    picture("sides.png")
    ACTIONS.clear()
    action(gui.gui_click(b"Add side"), "Add side")
    action(gui.gui_type_side(0, 0, b"hole0"), "choose the side")
    action(gui.gui_type_side(0, 1, b"24"), "type the number")
    action(gui.gui_click(b"Apply"), "Apply")
    wait(500)
    check_equal((edges_of(mesher, "hole0"), len(ACTIONS)), (24, 4), "edges, and actions")
    check_equal(list(mesher.Sides), ["hole0", "24", "", ""], "the property")
    check(gui.gui_set_box(b"Names in the view", True), "no box for names")
    picture("names.png")
    # The table follows the property, and rows can be removed.
    mesher.Sides = ["outer0", "40", "", "", "hole0", "40", "", ""]
    wait(300)
    check_equal(gui.gui_side_rows(), 2, "rows of the table")
    gui.gui_set_box(b"Names in the view", False)
    check(gui.gui_click(b"Remove"), "no button Remove")
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(500)
    check_equal((len(mesher.Sides), gui.gui_side_rows()), (4, 1), "rows after Remove")


def test_layer(view):
    mesher = make_mesher()
    ACTIONS.clear()
    action(gui.gui_type_text(b"Layers", b"hole0:0.01"), "type the layer")
    action(gui.gui_click(b"Apply"), "Apply")
    wait(500)
    report = mesher.GetClientSideObject().GetOutputDataObject(8).GetFieldData()
    check(report.GetAbstractArray("LayerRows") is not None, "there is no layer")
    check(len(ACTIONS) <= 3, "actions: %s" % ACTIONS)
    picture("layer.png")


def make_designer(domain):
    show(domain)
    check(gui.gui_trigger(b"Layout Designer"), "no Layout Designer in the menu")
    wait()
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(800)
    Hide(domain)
    return GetActiveSource()


def test_sum_and_reasons(view):
    designer = make_designer(PlanarDomainSource())
    check_equal(gui.gui_label(b"Sum").decode(), "Sum of quarter indices k: 4, as needed", "the sum")
    gui.gui_choose(1)
    wait()
    check_equal(gui.gui_label(b"Note").decode(), "Row 2: Chosen for this domain.", "why row 2 is there")
    check(gui.gui_click(b"Remove"), "no button Remove")
    wait(500)
    check_equal(gui.gui_label(b"Sum").decode(), "Sum of quarter indices k: 3, needed: <b>4</b>", "the sum of three")
    check(gui.gui_click(b"Add"), "no button Add")
    wait(500)
    check_equal(gui.gui_label(b"Sum").decode(), "Sum of quarter indices k: 4, as needed", "the sum after Add")
    gui.gui_type(0, 2, 2)
    wait(500)
    check(gui.gui_click(b"Add"), "no button Add")
    wait(500)
    check_equal((gui.gui_number(4, 2), gui.gui_label(b"Sum").decode()), (-1, "Sum of quarter indices k: 4, as needed"), "what Add adds if the sum is 5")
    picture("reasons.png")


def test_buttons_with_twelve_rows(view):
    holes = [PolyLineSource(Closed=1, Points=[0, 0, 0, 4, 0, 0, 4, 3, 0, 0, 3, 0])]
    for x, y in (0.8, 1.5), (2, 1.5), (3.2, 1.5):
        holes.append(PolyLineSource(Closed=1, Points=[
            value for i in range(24) for value in (x + 0.3 * math.cos(i * math.pi / 12), y + 0.3 * math.sin(i * math.pi / 12), 0)]))
    make_designer(AppendGeometry(Input=holes))
    check_equal(gui.gui_rows(), 12, "rows")
    for button in b"Propose", b"Optimise", b"Snap", b"Add", b"Add pair", b"Remove":
        check(gui.gui_room_below(button) > 0, "%s is below the panel by %d pixels" % (button.decode(), -gui.gui_room_below(button)))
    picture("buttons.png")


def test_lists_of_colours(view):
    """Field data about a drawing are not among the arrays that can colour it; the names of its sides are."""
    file = os.path.join(os.environ["FOLDER"], "ring.svg")
    with open(file, "w", encoding="utf-8") as drawing:
        drawing.write('<svg xmlns="http://www.w3.org/2000/svg" width="6mm" viewBox="-3 -3 6 6"><circle id="rim" r="2"/><circle id="hole" r="1"/></svg>')
    ring = OpenDataFile(file)
    shown = Show(ring)
    domain = shown.SMProxy.GetProperty("ColorArrayName").FindDomain("vtkSMRepresentedArrayListDomain")
    names = {domain.GetString(i) for i in range(domain.GetNumberOfStrings())}
    check({"Curve", "Side"} <= names, "arrays: %s" % names)
    fields = ring.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    present = {fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())}
    check({"CurveKind", "CurveOffset", "DrawingUnit"} <= present, "field data: %s" % present)
    check(not names & {"CurveKind", "CurveOffset", "CurveValues", "DrawingUnit", "LargestGap"}, "arrays: %s" % names)


def in_new_session(test):
    test(new_view())
    check_equal(messages(), "", "messages of " + test.__name__)


run("test_", globals(), in_new_session, (1400, 1000, 420))
