"""Draws meshes of surfaces that `crossfield quads` has written.

    xvfb-run -a -s -noreset pvpython draw_surfaces.py --plugin CrossFieldPlugin.so --width 600
        FOLDER NAME...

Reads NAME.vtu of the folder and writes NAME.png there. The directions of view are those of the gallery. The plugin is not used.
"""
import argparse
import os
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from surface_view import add_quads, extent, new_window, read_quads, save
from surfaces_gallery import CASES

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--plugin")
parser.add_argument("--width", type=int, default=600, help="of the pictures, in pixels")
parser.add_argument("folder")
parser.add_argument("names", nargs="+")
arguments = parser.parse_args()
directions = {name: direction for name, _, _, direction, _ in CASES}
for one in arguments.names:
    path = os.path.join(arguments.folder, one)
    _, (across, high, _) = extent(read_quads(path + ".vtu"), directions[one])
    width = arguments.width * 3 // 2
    view = new_window(width, int(width * min(1.05 * high / across, 0.9)))
    add_quads(path + ".vtu", view, (0, 0, 1, 1), directions[one])
    save(view, path + ".png")
    print("wrote", path + ".png")
