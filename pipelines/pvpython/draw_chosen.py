"""Draw sizes that `crossfield hfield` has written, with the singularities of their fields.

    xvfb-run -a -s -noreset pvpython draw_chosen.py --plugin CrossFieldPlugin.so --width 600
        FOLDER NAME...

Reads NAME.vtu and NAME.csv of the folder and writes NAME.png there.
"""
import argparse
import os

from paraview.simple import *

from docs_drawing import draw_scalar
from drawing import draw_singularities, look_from_above, white_view

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
parser.add_argument("--width", type=int, default=600, help="of the pictures, in pixels")
parser.add_argument("folder")
parser.add_argument("names", nargs="+")
arguments = parser.parse_args()
LoadPlugin(arguments.plugin, ns=globals())
for name in arguments.names:
    path = os.path.join(arguments.folder, name)
    field = OpenDataFile(path + ".vtu")
    field.UpdatePipeline()
    bounds = field.GetDataInformation().GetBounds()
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    view = white_view(arguments.width, max(60, round(arguments.width * height / width)))
    draw_scalar(field, view, "SizeMap", "Grayscale")
    least, largest = field.PointData["SizeMap"].GetRange()
    if largest < 1.01 * least:  # all the same
        surface = GetDisplayProperties(field, view)
        ColorBy(surface, None)
        SetProperties(surface, AmbientColor=[0.6] * 3, DiffuseColor=[0.6] * 3)
    with open(path + ".csv", encoding="utf-8") as file:
        if len(file.readlines()) > 1:
            points = SingularitySource(FileName=path + ".csv")
            draw_singularities(points, view, 0.009 * max(width, height))
    look_from_above(view, bounds, 0)
    SaveScreenshot(path + ".png", view, CompressionLevel="9")
    Delete(view)
    print("wrote", path + ".png")
