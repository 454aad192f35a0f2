"""Draws meshes of several materials that `crossfield quads` has written.

    xvfb-run -a -s -noreset pvpython draw_regions.py --plugin CrossFieldPlugin.so --width 600
        FOLDER NAME...

Reads NAME.vtu of the folder and writes NAME.png there.
"""
import pathlib
import sys
import paraview.simple as pv

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "pipelines" / "pvpython"))
from drawing import boundary, draw_each, draw_lines, look_from_above, white_view
from drawing_quads import PALE, draw_nodes


def draw_regions(quads, width):
    """Returns a view of this width: quads coloured by material, interfaces, the boundary and irregular nodes."""
    quads.UpdatePipeline()
    bounds = quads.GetDataInformation().GetBounds()
    across, high = bounds[1] - bounds[0], bounds[3] - bounds[2]
    view = white_view(width, int(width * min(1.0, 1.06 * high / across)))
    faces = pv.Threshold(Input=quads, Scalars=["CELLS", "BlockId"], LowerThreshold=-0.5, UpperThreshold=1e9)
    shown = pv.Show(faces, view)
    shown.Representation = "Surface With Edges"
    pv.ColorBy(shown, ("CELLS", "Region"), separate=True)
    shown.SetScalarBarVisibility(view, False)
    points = [value for region, colour in enumerate(PALE) for value in (region, *colour)]
    pv.SetProperties(pv.GetColorTransferFunction("Region", shown, separate=True), ColorSpace="RGB", RGBPoints=points)
    pv.SetProperties(shown, Ambient=1, Diffuse=0, EdgeColor=[0.45, 0.45, 0.45], LineWidth=0.9 * width / 900, NonlinearSubdivisionLevel=1)
    draw_lines(boundary(quads, 1, 4), view, [0.15, 0.15, 0.15], 1.5 * width / 900)
    draw_lines(boundary(quads, 5, 5), view, [0.15, 0.15, 0.15], 3 * width / 900)
    draw_nodes(quads, view, 0.009 * max(across, high))
    look_from_above(view, bounds, 0)
    view.CameraParallelScale = 0.52 * max(high, across * view.ViewSize[1] / view.ViewSize[0])
    return view


# Wider than other galleries, because layers and interfaces are thin.
draw_each(__doc__, lambda path, width: draw_regions(pv.OpenDataFile(path + ".vtu"), width * 3 // 2))
