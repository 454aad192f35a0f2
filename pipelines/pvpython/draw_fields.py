"""Draw cross fields that are in files, side by side: norm, crosses, holes and singularities.

Usage:

    xvfb-run -a -s -noreset pvpython draw_fields.py --plugin CrossFieldPlugin.so
        --picture fields.png [--columns 2] [--width 420] [--crosses 25] one.vtu two.vtu

Positive singularities are red, negative ones blue; blue areas have a norm below one, orange ones
above. Sample run: scripts/variants.sh, which draws the pictures of docs/variants.md.
"""
import argparse
import sys

from paraview.simple import *

from drawing import (draw_boundaries, draw_lines, draw_norm, draw_singularities, look_from_above,
                     white_view)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
    parser.add_argument("--picture", required=True, help="the .png file to write")
    parser.add_argument("--columns", type=int, default=0, help="default: all in one row")
    parser.add_argument("--width", type=int, default=420, help="of each field, in pixels")
    parser.add_argument("--crosses", type=int, default=25, help="crosses across a field")
    parser.add_argument("files", nargs="+", help=".vtu files with fields")
    return parser.parse_args()


arguments = parse_arguments()
LoadPlugin(arguments.plugin, ns=globals())
columns = arguments.columns or len(arguments.files)
rows = -(-len(arguments.files) // columns)

# 1. Read the fields and move each to its cell of a grid, whose cells have the size of the first
#    field.
fields = []
bounds = None
for number, name in enumerate(arguments.files):
    field = XMLUnstructuredGridReader(FileName=[name])
    field.UpdatePipeline()
    if "CrossNorm" not in field.PointData.keys():
        sys.exit("The file '%s' has no array CrossNorm; give one written by `crossfield solve --arrays all`." % name)
    bounds = bounds or field.GetDataInformation().GetBounds()
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    row, column = divmod(number, columns)
    moved = Transform(Input=field)
    moved.Transform.Translate = [1.1 * width * column, -1.1 * height * row, 0]
    fields.append(moved)

# 2. The picture.
across, down = width * (1.1 * columns - 0.1), height * (1.1 * rows - 0.1)
pixels = arguments.width * columns
view = white_view(pixels, int(pixels * (down + 0.1 * width) / (across + 0.1 * width)))
for field in fields:
    draw_norm(field, view, 0, 1.4, show_bar=False)
    draw_lines(CrossGlyphs(Input=field, Spacing=width / arguments.crosses, Scale=0.7), view,
               [0, 0, 0], 1)
    draw_boundaries(field, view)
    draw_singularities(CrossFieldSingularities(Input=field), view, 0.012 * (width + height) / 2)
look_from_above(view, [bounds[0], bounds[0] + across, bounds[3] - down, bounds[3]], room_below=0)
view.CameraParallelScale = 0.5 * (down + 0.1 * width)
SaveScreenshot(arguments.picture, view, ImageResolution=view.ViewSize, CompressionLevel="9")
