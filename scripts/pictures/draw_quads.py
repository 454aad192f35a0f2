"""Draw meshes of quads that `crossfield quads` has written, with their layouts.

    xvfb-run -a -s -noreset pvpython draw_quads.py --plugin CrossFieldPlugin.so --width 600
        FOLDER NAME...

Reads NAME.vtu and NAME.vtp of the folder and writes NAME.png there.
"""
import pathlib
import sys
from paraview.simple import OpenDataFile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "pipelines" / "pvpython"))
from drawing import draw_each
from drawing_quads import draw_quads

draw_each(__doc__, lambda path, width: draw_quads(
    OpenDataFile(path + ".vtu"), OpenDataFile(path + ".vtp"), width, 0.011))
