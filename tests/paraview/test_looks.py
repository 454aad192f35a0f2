"""Default display of sources and filters created from the menu; started by run_client.py."""
import os

from paraview import smtrace
from paraview.modules.vtkRemotingViews import vtkSMPVRepresentationProxy
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from gui_driver import check, check_equal, gui, messages, picture, run, wait

BLACK, RED, BLUE = [0, 0, 0], [0.85, 0.1, 0.1], [0.1, 0.2, 0.85]


def make(name, **inputs):
    """Creates and applies a filter of the active source from the menu; returns the display of
    output 0."""
    check(gui.gui_trigger(name.encode()), name + " is not in the menu")
    return applied(name, **inputs)


def applied(name, **inputs):
    wait()
    for label, choice in inputs.items():
        check(gui.gui_select_choice(label.encode(), choice.encode()), "no %s for %s" % (choice, name))
    check(gui.gui_click(b"Apply"), "no Apply for " + name)
    wait(400)
    check_equal(messages(), "", "messages of " + name)
    picture(name.replace(" ", "_").lower() + ".png", is_whole_window=False)
    return GetRepresentation(GetActiveSource(), GetActiveView())


def is_coloured(shown, array):
    check_equal(shown.ColorArrayName[1], array, "the array that colours")


def colours(array):
    """Returns the colour of each value in the colour map of an array."""
    points = list(GetColorTransferFunction(array).RGBPoints)
    return {points[i]: [round(c, 3) for c in points[i + 1:i + 4]] for i in range(0, len(points), 4)}


def has_legend(shown):
    """Reports whether a legend is visible; GetScalarBar would create one."""
    return bool(vtkSMPVRepresentationProxy.IsScalarBarVisible(shown.SMProxy, GetActiveView().SMProxy))


def legends():
    return sum(shown.GetXMLName() == "ScalarBarWidgetRepresentation" and bool(shown.Visibility)
               for shown in GetActiveView().Representations)


def test_domain():
    shown = make("Planar Domain Source")
    RenameSource("Domain", GetActiveSource())
    is_coloured(shown, "")
    check_equal((list(shown.AmbientColor), shown.LineWidth), (BLACK, 3), "the line of the boundary")


def test_singularities():
    shown = make("Singularity Source")
    RenameSource("Points", GetActiveSource())
    is_coloured(shown, "QuarterIndex")
    check_equal((shown.Representation, shown.PointSize, shown.RenderPointsAsSpheres), ("Points", 12, 1), "spheres")
    check_equal((colours("QuarterIndex")[-1], colours("QuarterIndex")[1]), (BLUE, RED), "colours of the signs")
    check_equal(has_legend(shown), False, "a legend of signs")


def test_mesh():
    SetActiveSource(FindSource("Domain"))
    gui.gui_filter(b"DrillHoles", b"Singularities", b"Points")
    shown = applied("Drill Holes")
    is_coloured(shown, "")
    check_equal(shown.Representation, "Surface With Edges", "a mesh")
    check_equal(legends(), 0, "legends of a mesh")


def test_field():
    shown = make("Perforated Cross Field")
    is_coloured(shown, "CrossNorm")
    check_equal(sorted(colours("CrossNorm")), [0, 0.5, 1], "the fixed colour map of the norm")
    check(min(colours("CrossNorm")[1]) > 0.9 and max(colours("CrossNorm")[0]) < 0.4, "norm 1 is not pale or 0 not dark")
    check_equal(has_legend(shown), True, "a legend of the norm")
    shown = make("Cross Glyphs")
    is_coloured(shown, "")
    check_equal(list(shown.AmbientColor), BLACK, "crosses")
    check_equal(legends(), 1, "the legend of the norm beside crosses")


def test_sizes():
    SetActiveSource(FindSource("Domain"))
    shown = make("H Field", Singularities="Points")
    is_coloured(shown, "SizeMap")
    # A sequential map: from dark to light.
    light = [sum(colour) for _, colour in sorted(colours("SizeMap").items())]
    check_equal(light, sorted(light), "how light sizes are")
    check_equal(has_legend(shown), True, "a legend of sizes")


def test_quads():
    SetActiveSource(FindSource("Domain"))
    shown = make("Quad Mesher", Singularities="Points")
    is_coloured(shown, "BlockId")
    check_equal(shown.Representation, "Surface With Edges", "quads")
    mesher, view = GetActiveSource(), GetActiveView()
    _, blocks, layout, singularities, _, boundary, nodes, separatrices, summary = (
        GetRepresentation(OutputPort(mesher, port), view) for port in range(9))
    # Blocks would cover the quads, and singularities the irregular nodes.
    check_equal([part.Visibility for part in (shown, blocks, layout, singularities, boundary, nodes, separatrices, summary)],
                [1, 0, 1, 0, 0, 1, 0, 1], "visibility of the outputs")
    check_equal(layout.LineWidth, 3, "sides of blocks")
    is_coloured(nodes, "QuarterIndex")
    check_equal(legends(), 0, "legends of blocks")
    check(all(min(colour) > 0.7 for colour in colours("BlockId").values()), "colours of blocks are not pale")
    # The blocks, shown instead of the quads, look like them.
    blocks.Visibility, shown.Visibility = 1, 0
    Render()
    wait(400)
    is_coloured(blocks, "BlockId")
    check_equal(blocks.Representation, "Surface With Edges", "blocks")
    check_equal(legends(), 0, "legends of blocks")
    picture("blocks.png", is_whole_window=False)


def test_scripts_keep_their_settings():
    shown = Show(PlanarDomainSource(registrationName="Scripted"))
    SetProperties(shown, LineWidth=7)
    wait(400)
    check_equal(shown.LineWidth, 7, "the width that the script has set")


def drawn(name):
    """Returns the pixels of the view."""
    picture(name, is_whole_window=False)
    reader = vtkPNGReader()
    reader.SetFileName(os.path.join(os.environ["FOLDER"], name))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels[:, width * 2 // 5:-10].astype(int)


def test_traces_replay_the_picture():
    ResetSession()
    wait(300)
    smtrace.start_trace()
    try:
        make("Planar Domain Source")
        make("Quad Mesher")
        make("Layout Designer")
    finally:
        trace = smtrace.stop_trace()
    check_equal(legends(), 0, "legends of the designer of coloured quads")
    texts = [str(shown.WindowLocation).strip("'") for shown in GetActiveView().Representations
             if shown.GetXMLName() == "TextSourceRepresentation" and shown.Visibility]
    check_equal(sorted(texts), ["Lower Center", "Upper Center"], "the positions of the texts")
    seen = drawn("traced.png")
    ResetSession()
    wait(300)
    exec(trace, dict(globals()))
    Render()
    wait(400)
    replayed = drawn("replayed.png")
    check_equal(messages(), "", "messages of the trace")
    different = (abs(replayed - seen).max(axis=2) > 8).mean()
    check(different < 0.005, "%g of the pixels of the replayed trace differ" % different)


def run_in_empty_view(test):
    view = GetActiveViewOrCreate("RenderView")
    HideAll(view)
    test()


run("test_", globals(), run_in_empty_view, (1000, 800, 370))
