"""Draw sizes that `crossfield hfield` has written, with the singularities of their fields.

    xvfb-run -a -s -noreset pvpython draw_chosen.py --plugin CrossFieldPlugin.so --width 600
        FOLDER NAME...

Reads NAME.vtu and NAME.csv of the folder and writes NAME.png there.
"""
import pathlib
import sys
import paraview.simple as pv

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "pipelines" / "pvpython"))
from docs_drawing import draw_scalar
from drawing import draw_each, draw_singularities, look_from_above, white_view


def view_of(path, width):
    field = pv.OpenDataFile(path + ".vtu")
    field.UpdatePipeline()
    if "SizeMap" not in field.PointData.keys():
        raise SystemExit("The file '%s.vtu' has no array SizeMap; give one written by `crossfield hfield`." % path)
    bounds = field.GetDataInformation().GetBounds()
    across, high = bounds[1] - bounds[0], bounds[3] - bounds[2]
    view = white_view(width, max(60, round(width * high / across)))
    draw_scalar(field, view, "SizeMap", "Grayscale")
    least, largest = field.PointData["SizeMap"].GetRange()
    if largest < 1.01 * least:  # all the same
        surface = pv.GetDisplayProperties(field, view)
        pv.ColorBy(surface, None)
        pv.SetProperties(surface, AmbientColor=[0.6] * 3, DiffuseColor=[0.6] * 3)
    with open(path + ".csv", encoding="utf-8") as file:
        if len(file.readlines()) > 1:
            points = pv.SingularitySource(FileName=path + ".csv")
            draw_singularities(points, view, 0.009 * max(across, high))
    look_from_above(view, bounds, 0)
    return view


draw_each(__doc__, view_of)
