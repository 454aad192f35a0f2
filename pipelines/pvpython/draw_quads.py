"""Draw meshes of quads that `crossfield quads` has written, with their layouts.

    xvfb-run -a -s -noreset pvpython draw_quads.py --plugin CrossFieldPlugin.so --width 600
        FOLDER NAME...

Reads NAME.vtu and NAME.vtp of the folder and writes NAME.png there.
"""
import argparse
import os

from paraview.simple import *

from drawing_quads import draw_quads

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
parser.add_argument("--width", type=int, default=600, help="of the pictures, in pixels")
parser.add_argument("folder")
parser.add_argument("names", nargs="+")
arguments = parser.parse_args()
LoadPlugin(arguments.plugin, ns=globals())
for name in arguments.names:
    path = os.path.join(arguments.folder, name)
    view = draw_quads(OpenDataFile(path + ".vtu"), OpenDataFile(path + ".vtp"), arguments.width, 0.011)
    SaveScreenshot(path + ".png", view, CompressionLevel="9")
    print("wrote", path + ".png")
