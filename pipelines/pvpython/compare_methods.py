"""Compute the cross field of one domain and configuration by several methods, side by side.

The pipeline is that of `crossfield compare`, built from ParaView proxies:

    domain, singularities -> drilled mesh -> cross field -> moved beside the others -> one group

Usage:

    xvfb-run -a -s -noreset pvpython compare_methods.py --plugin CrossFieldPlugin.so
        --output compared.vtm [--picture compared.png] [--singularities four.csv] [--domain disk]
        [--size 0.05] [--epsilon 0.05] [--methods constrained,unit-norm,penalty]

Without a file of singularities, four singularities of quarter index 1 on the diagonals are used,
which suits the disk.

Sample run:

    plugin=$(build/bin/crossfield --paths | sed -n 's/^plugin: //p')
    xvfb-run -a -s -noreset pvpython pipelines/pvpython/compare_methods.py --plugin "$plugin" \
        --output compared.vtm --picture compared.png
"""
import argparse
import sys
import time

from paraview import servermanager
from paraview.simple import *

from drawing import (draw_boundaries, draw_lines, draw_norm, draw_singularities, look_from_above,
                     white_view)

# Mode of the mesh and properties of the solver for each method.
METHODS = {
    "constrained": ("Perforate", {"Method": "Constrained"}),
    "unit-norm": ("Perforate", {"Method": "Unit Norm"}),
    "unit-holes": ("Perforate", {"Method": "Constrained", "UnitHoles": 1}),
    "global-constraint": ("Perforate", {"Method": "Constrained", "GlobalConstraint": 1}),
    "imprint": ("Imprint", {"Method": "Constrained"}),
    "imprint-unit": ("Imprint", {"Method": "Constrained", "UnitHoles": 1}),
    "triangle": ("Triangle", {"Method": "Constrained"}),
    "penalty": ("Perforate", {"Method": "Constrained", "Epsilon": None}),
    "ginzburg-landau": (None, {"Epsilon": None}),
}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
    parser.add_argument("--output", required=True, help="the .vtm file to write")
    parser.add_argument("--picture", default="", help="the .png file to write")
    parser.add_argument("--singularities", default="", help="a .csv file; default: the paper's four")
    parser.add_argument("--domain", default="disk", help="name of a built-in domain")
    parser.add_argument("--size", type=float, default=0.05, help="edge length of the mesh")
    parser.add_argument("--epsilon", type=float, default=0.0,
                        help="length of the penalty; default: the edge length")
    parser.add_argument("--methods", default="constrained,unit-norm,imprint,penalty,ginzburg-landau",
                        help="separated by commas: " + ", ".join(METHODS))
    return parser.parse_args()


def solve(method, domain, singularities):
    """Returns the proxy of the field of one method."""
    mode, properties = METHODS[method]
    values = {name: (arguments.epsilon or arguments.size) if value is None else value
              for name, value in properties.items()}
    if mode is None:
        nothing = SingularitySource(Singularities=[])
        mesh = DrillHoles(Input=domain, Singularities=nothing, MeshSize=arguments.size)
        return GinzburgLandauCrossField(Input=mesh, **values)
    mesh = DrillHoles(Input=domain, Singularities=singularities, MeshSize=arguments.size, Mode=mode)
    return PerforatedCrossField(Input=mesh, **values)


def describe(method, field, seconds):
    """Returns one line of the table. Ends the script if there is no field, because ParaView
    continues after an error."""
    report = servermanager.Fetch(field).GetFieldData()
    if report.GetArray("Converged") is None:
        sys.exit("The method %s gave no cross field; the error above says why." % method)

    def value(name):
        return report.GetArray(name).GetValue(0)

    degrees = report.GetArray("HoleDegree")
    least, largest = field.PointData["CrossNorm"].GetRange()
    return "%-18s %10.4f %8.3f .. %.3f %9s %9d %11d %8.2f%s" % (
        method, value("Energy"), least, largest,
        " ".join("%+d" % degrees.GetValue(i) for i in range(degrees.GetNumberOfValues())) or "-",
        value("UnwantedSingularities"), value("Iterations"), seconds,
        "" if value("Converged") else "  NOT converged")


arguments = parse_arguments()
LoadPlugin(arguments.plugin, ns=globals())
methods = arguments.methods.split(",")
unknown = [method for method in methods if method not in METHODS]
if unknown:
    sys.exit("There is no method '%s'; choose among %s." % (unknown[0], ", ".join(METHODS)))

# 1. Create the domain and the configuration.
domain = PlanarDomainSource(DomainName=arguments.domain, EdgeLength=arguments.size)
singularities = SingularitySource(FileName=arguments.singularities)
domain.UpdatePipeline()
bounds = domain.GetDataInformation().GetBounds()
width = bounds[1] - bounds[0]

# 2. Solve with every method, place the fields side by side and print the table.
print("%-18s %10s %17s %9s %9s %11s %8s" % (
    "method", "energy", "norm at points", "degrees", "unwanted", "iterations", "seconds"))
fields = []
for number, method in enumerate(methods):
    field = solve(method, domain, singularities)
    started = time.perf_counter()
    field.UpdatePipeline()
    print(describe(method, field, time.perf_counter() - started))
    moved = Transform(Input=field)
    moved.Transform.Translate = [1.2 * width * number, 0, 0]
    fields.append(moved)

# 3. Write one file with all fields, in inline binary, because Debian's VTK cannot read appended
#    data.
group = GroupDatasets(Input=fields, BlockNames=methods)
SaveData(arguments.output, proxy=group, DataMode="Binary", CompressorType="ZLib")

# 4. Draw norm, crosses, holes and singularities of every field.
if arguments.picture:
    view = white_view(500 * len(fields), 560)
    for field in fields:
        draw_norm(field, view, 0, 1.4, show_bar=False)
        crosses = CrossGlyphs(Input=field, Spacing=width / 25, Scale=0.7)
        draw_lines(crosses, view, [0, 0, 0], 1)
        draw_boundaries(field, view)
        draw_singularities(CrossFieldSingularities(Input=field), view, 0.012 * width)
    end = bounds[1] + 1.2 * width * (len(fields) - 1)
    look_from_above(view, [bounds[0], end] + list(bounds[2:4]), room_below=0)
    SaveScreenshot(arguments.picture, view, ImageResolution=view.ViewSize, CompressionLevel="9")
