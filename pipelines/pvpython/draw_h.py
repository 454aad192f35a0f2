"""Draw the scalar H of chosen singularities, its isolines, and the crosses that follow from it.

The picture is that of the paper's "Further thoughts": red points have quarter index 1 (or more),
green ones −1. Left: H with its isolines, which meet straight sides at right angles; right: the size
map and the crosses, with quads that are small where the map is dark.

    domain, singularities -> H -> isolines, crosses

Usage:

    xvfb-run -a -s -noreset pvpython draw_h.py --plugin CrossFieldPlugin.so --picture h.png
        [--domain disk] [--singularities four.csv] [--size 0.02] [--width 1600]

Sample run:

    plugin=$(build/bin/crossfield --paths | sed -n 's/^plugin: //p')
    xvfb-run -a -s -noreset pvpython pipelines/pvpython/draw_h.py --plugin "$plugin" --picture h.png
"""
import argparse
import sys

from paraview import servermanager
from paraview.simple import *

RED, GREEN, BLACK = [0.85, 0.1, 0.1], [0.1, 0.6, 0.15], [0, 0, 0]

# Singularities in an L-shape: red and green points inside, and a green one on the boundary.
ROWS = [(0.15, 0.2, 1), (0.9, 0.15, 1), (0.7, 0.38, 1), (0.2, 0.8, 1),
        (0.55, 0.15, -1), (0.2, 0.55, -1), (0.4, 0.36, -1), (0.85, 0.5, -1)]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
    parser.add_argument("--picture", required=True, help="the .png file to write")
    parser.add_argument("--domain", default="l-shape", help="name of a built-in domain")
    parser.add_argument("--singularities", default="", help="a .csv file; default: four and four")
    parser.add_argument("--size", type=float, default=0.01, help="edge length of the mesh")
    parser.add_argument("--width", type=int, default=1600, help="of the picture, in pixels")
    return parser.parse_args()


def draw(source, view, colour, width=1):
    shown = Show(source, view)
    shown.ColorArrayName = [None, ""]
    SetProperties(shown, AmbientColor=colour, DiffuseColor=colour, LineWidth=width)
    return shown


def draw_coloured(field, view, name, preset, title):
    surface = Show(field, view)
    ColorBy(surface, ("POINTS", name))
    SetProperties(surface, Ambient=1, Diffuse=0)
    colours = GetColorTransferFunction(name)
    colours.ApplyPreset(preset, True)
    array = servermanager.Fetch(field).GetPointData().GetArray(name)
    values = sorted(array.GetValue(i) for i in range(array.GetNumberOfTuples()))
    # H is infinite at singularities; leaving out the extremes keeps the colours of the others.
    colours.AutomaticRescaleRangeMode = "Never"
    colours.RescaleTransferFunction(values[len(values) // 25], values[-len(values) // 25])
    bar = GetScalarBar(colours, view)
    SetProperties(bar, Title=title, ComponentTitle="", Visibility=1, Orientation="Horizontal",
                  WindowLocation="Any Location", Position=[0.25, 0.02], ScalarBarLength=0.5,
                  AutomaticLabelFormat=0, LabelFormat="%.1f", RangeLabelFormat="%.1f",
                  TitleColor=BLACK, LabelColor=BLACK)
    return values


def draw_points(singularities, view):
    for sign, colour in ((1, RED), (-1, GREEN)):
        rows = Threshold(Input=singularities, Scalars=["POINTS", "QuarterIndex"],
                         LowerThreshold=1 if sign > 0 else -99,
                         UpperThreshold=99 if sign > 0 else -1)
        SetProperties(draw(rows, view, colour), PointSize=14, RenderPointsAsSpheres=1)


def new_view(bounds):
    view = CreateView("RenderView")
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    centre = [0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]) - 0.06 * height]
    SetProperties(view, ViewSize=[800, 860], Background=[1, 1, 1], UseColorPaletteForBackground=0,
                  OrientationAxesVisibility=0, CameraParallelProjection=1,
                  CameraPosition=[*centre, 10], CameraFocalPoint=[*centre, 0],
                  CameraViewUp=[0, 1, 0], CameraParallelScale=0.6 * max(width, height))
    return view


def main():
    arguments = parse_arguments()
    LoadPlugin(arguments.plugin, ns=globals())
    domain = PlanarDomainSource(DomainName=arguments.domain, EdgeLength=arguments.size)
    if arguments.domain == "l-shape":
        domain.Width = 1
    singularities = SingularitySource(
        Singularities=[value for x, y, quarters in ROWS for value in (x, y, quarters, 0.02)])
    if arguments.singularities:
        singularities.FileName = arguments.singularities
    field = HField(Input=domain, Singularities=singularities, MeshSize=arguments.size)
    field.UpdatePipeline()
    report = servermanager.Fetch(field).GetFieldData()
    if report.GetArray("RenormalizedEnergy") is None:
        sys.exit("There is no H; the error above says why.")
    print("renormalised energy %.4f" % report.GetArray("RenormalizedEnergy").GetValue(0))

    bounds = field.GetDataInformation().GetBounds()
    boundary = Threshold(Input=field, Scalars=["CELLS", "BoundaryKind"],
                         LowerThreshold=1, UpperThreshold=2)
    left = new_view(bounds)
    values = draw_coloured(field, left, "H", "Cool to Warm", "H")
    low, high = values[len(values) // 100], values[-len(values) // 100]
    isolines = Contour(Input=field, ContourBy=["POINTS", "H"],
                       Isosurfaces=[low + (high - low) * i / 24 for i in range(25)])
    draw(isolines, left, [0.15, 0.15, 0.15], 1)
    right = new_view(bounds)
    draw_coloured(field, right, "SizeMap", "Grayscale", "size of quads")
    crosses = CrossGlyphs(Input=field, Spacing=2.5 * arguments.size)
    draw(crosses, right, [0.1, 0.3, 0.8], 1.5)
    for view in (left, right):
        draw(boundary, view, BLACK, 2)
        draw_points(singularities, view)
    layout = CreateLayout("H")
    layout.SplitHorizontal(0, 0.5)
    layout.AssignView(1, left)
    layout.AssignView(2, right)
    layout.SetSize(1600, 860)
    SaveScreenshot(arguments.picture, layout, CompressionLevel="9",
                   ImageResolution=[arguments.width, arguments.width * 860 // 1600])


main()
