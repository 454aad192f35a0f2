"""Choose where the singularities of a cross field on the unit disk are, and draw the field.

The pipeline is that of `crossfield solve builtin:disk`, built from ParaView proxies:

    domain, singularities -> drilled mesh -> cross field -> crosses

Usage:

    xvfb-run -a -s -noreset pvpython place_singularities.py --plugin CrossFieldPlugin.so
        --output field.vtu --picture field.png [--singularities four.csv]

The file of singularities has the header `x,y,quarter_index,radius`; without one, four
singularities of quarter index 1 lie on the diagonals. `crossfield --paths` prints where the
plugin is. On a desktop pvpython needs no xvfb-run.

Sample run:

    plugin=$(build/bin/crossfield --paths | sed -n 's/^plugin: //p')
    xvfb-run -a -s -noreset pvpython pipelines/pvpython/place_singularities.py --plugin "$plugin" \
        --output field.vtu --picture field.png
"""
import argparse
import sys

from paraview import servermanager
from paraview.simple import *


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
    parser.add_argument("--output", required=True, help="the .vtu file to write")
    parser.add_argument("--picture", required=True, help="the .png file to write")
    parser.add_argument("--singularities", default="", help="a .csv file; default: the paper's four")
    return parser.parse_args()


def check(field):
    """Ends the script when the field is missing or not a solution: ParaView itself goes on."""
    field.UpdatePipeline()
    report = servermanager.Fetch(field).GetFieldData()
    converged = report.GetArray("Converged")
    if converged is None:
        sys.exit("There is no cross field; the error above says why.")
    if not converged.GetValue(0):
        sys.exit("The iteration did not converge; make the holes larger or move them.")
    print("energy %.4f" % report.GetArray("Energy").GetValue(0))


def draw_norm(field, view):
    """Colours the domain by the norm of the representation, in bands, white where it is 1."""
    surface = Show(field, view)
    ColorBy(surface, ("POINTS", "CrossNorm"))
    SetProperties(surface, Ambient=1, Diffuse=0)
    least, largest = field.PointData["CrossNorm"].GetRange()
    colours = GetColorTransferFunction("CrossNorm")
    SetProperties(colours, ColorSpace="RGB", NumberOfTableValues=20,
                  RGBPoints=[min(least, 0.9), 0.42, 0.68, 0.86,
                             1, 1, 1, 1,
                             max(largest, 1.1), 0.96, 0.65, 0.35])
    bar = GetScalarBar(colours, view)
    SetProperties(bar, Title="Norm of the cross field", ComponentTitle="", Visibility=1,
                  Orientation="Horizontal", WindowLocation="Any Location", Position=[0.25, 0.02],
                  ScalarBarLength=0.5, AutomaticLabelFormat=0, LabelFormat="%.1f",
                  RangeLabelFormat="%.1f", TitleColor=[0, 0, 0], LabelColor=[0, 0, 0])


def boundary(field, first_kind, last_kind):
    return Threshold(Input=field, Scalars=["CELLS", "BoundaryKind"],
                     LowerThreshold=first_kind, UpperThreshold=last_kind)


def draw_lines(source, view, colour, width):
    lines = Show(source, view)
    ColorBy(lines, None)
    SetProperties(lines, AmbientColor=colour, DiffuseColor=colour, LineWidth=width)


def look_from_above(view, bounds):
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    middle = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2 - 0.05 * height]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = middle + [0]
    view.CameraPosition = middle + [max(width, height)]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = 0.58 * max(width, height)


arguments = parse_arguments()
LoadPlugin(arguments.plugin, ns=globals())

# 1. The domain, and the singularities wanted in it. The circle has segments as long as the edges of
#    the mesh: a finer mesh would see the corners of a coarse polygon instead of a circle.
edge_length = 0.02
domain = PlanarDomainSource(DomainName="disk", EdgeLength=edge_length)
singularities = SingularitySource(FileName=arguments.singularities)

# 2. A mesh with a hole at every singularity, and the cross field on it.
drilled = DrillHoles(Input=domain, Singularities=singularities, MeshSize=edge_length)
field = PerforatedCrossField(Input=drilled)
check(field)

# 3. The file: inline binary, because Debian's VTK cannot read appended data back.
SaveData(arguments.output, proxy=field, DataMode="Binary", CompressorType="ZLib")

# 4. The picture: about forty crosses across the domain, holes in red.
bounds = field.GetDataInformation().GetBounds()
spacing = max(bounds[1] - bounds[0], bounds[3] - bounds[2]) / 40
crosses = CrossGlyphs(Input=field, Spacing=spacing, Scale=0.7)

view = CreateRenderView(ViewSize=[1200, 1200], OrientationAxesVisibility=0,
                        UseColorPaletteForBackground=0, Background=[1, 1, 1])
draw_norm(field, view)
draw_lines(crosses, view, [0, 0, 0], 1.5)
draw_lines(boundary(field, 1, 2), view, [0.2, 0.2, 0.2], 2)
draw_lines(boundary(field, 3, 3), view, [0.85, 0.1, 0.1], 4)
look_from_above(view, bounds)
SaveScreenshot(arguments.picture, view, ImageResolution=[1200, 1200], CompressionLevel="9")
