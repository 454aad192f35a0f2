"""Choose where the singularities of a cross field on the unit disk are, and draw the field.

The pipeline is that of `crossfield solve builtin:disk`, built from ParaView proxies:

    domain, singularities -> drilled mesh -> cross field -> crosses

Usage:

    xvfb-run -a -s -noreset pvpython place_singularities.py --plugin CrossFieldPlugin.so
        --output field.vtu --picture field.png [--singularities four.csv]

The file of singularities has the header `x,y,quarter_index,radius`; without one, four
singularities of quarter index 1 on the diagonals are used. `crossfield --paths` prints where the
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

from drawing import draw_boundaries, draw_lines, draw_norm, look_from_above, white_view


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
    parser.add_argument("--output", required=True, help="the .vtu file to write")
    parser.add_argument("--picture", required=True, help="the .png file to write")
    parser.add_argument("--singularities", default="", help="a .csv file; default: the paper's four")
    return parser.parse_args()


def check(field):
    """Ends the script if the field is missing or not converged, because ParaView continues after an
    error."""
    field.UpdatePipeline()
    report = servermanager.Fetch(field).GetFieldData()
    converged = report.GetArray("Converged")
    if converged is None:
        sys.exit("There is no cross field; the error above says why.")
    if not converged.GetValue(0):
        sys.exit("The iteration did not converge; make the holes larger or move them.")
    print("energy %.4f" % report.GetArray("Energy").GetValue(0))


arguments = parse_arguments()
LoadPlugin(arguments.plugin, ns=globals())

# 1. Create the domain and its singularities. The circle has segments as long as the edges of
#    the mesh: a finer mesh would resolve the corners of a coarse polygon instead of a circle.
edge_length = 0.02
domain = PlanarDomainSource(DomainName="disk", EdgeLength=edge_length)
singularities = SingularitySource(FileName=arguments.singularities)

# 2. Make a mesh with a hole at every singularity, and compute the cross field on it.
drilled = DrillHoles(Input=domain, Singularities=singularities, MeshSize=edge_length)
field = PerforatedCrossField(Input=drilled, Method="Constrained")  # the paper's figure
check(field)

# 3. Write the file in inline binary, because Debian's VTK cannot read appended data.
SaveData(arguments.output, proxy=field, DataMode="Binary", CompressorType="ZLib")

# 4. Draw about forty crosses across the domain, and holes in red.
bounds = field.GetDataInformation().GetBounds()
spacing = max(bounds[1] - bounds[0], bounds[3] - bounds[2]) / 40
crosses = CrossGlyphs(Input=field, Spacing=spacing, Scale=0.7)

view = white_view(1200, 1200)
draw_norm(field, view)
draw_lines(crosses, view, [0, 0, 0], 1.5)
draw_boundaries(field, view)
look_from_above(view, bounds)
SaveScreenshot(arguments.picture, view, ImageResolution=[1200, 1200], CompressionLevel="9")
