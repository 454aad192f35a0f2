"""Functions of docs_pictures.py: panels side by side, numbers at points, scalars."""
import pathlib
import sys
import math

from paraview import servermanager
from paraview.simple import *

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "pipelines" / "pvpython"))
from drawing import boundary, draw_lines, look_from_above, white_view

BLACK, GREEN = [0, 0, 0], [0.05, 0.5, 0.15]
PANEL = 400  # pixels


def on_circle(count, distance, quarters=1, first=45):
    angles = [math.radians(first + 360 * i / count) for i in range(count)]
    return [(distance * math.cos(a), distance * math.sin(a), quarters) for a in angles]


def polygon(sides):
    """Returns a regular polygon whose lowest side is horizontal."""
    first = -90 - 180 / sides
    points = [(x, y, 0) for x, y, _ in on_circle(sides, 1, first=first)]
    return PolyLineSource(Points=[value for point in points for value in point], Closed=1)


def bounds_of(source):
    source.UpdatePipeline()
    return source.GetDataInformation().GetBounds()


def panel(source, title="", room_below=0.08):
    """Creates a view of the extent of this source, with a title below."""
    view = white_view(PANEL, PANEL)
    bounds = bounds_of(source)
    look_from_above(view, bounds, room_below)
    view.CameraParallelScale *= 1.12
    if title:
        shown = Show(Text(Text=title), view)
        SetProperties(shown, WindowLocation="Lower Center", Color=BLACK, FontSize=16)
    return view


def figure(path, *views):
    """Combines views side by side into one picture."""
    if len(views) == 1:
        SaveScreenshot(path, views[0], ImageResolution=[PANEL, PANEL], CompressionLevel="9")
        return
    layout = CreateLayout(path)
    cell = 0
    for number, view in enumerate(views):
        if number < len(views) - 1:
            layout.SplitHorizontal(cell, 1 / (len(views) - number))
            layout.AssignView(2 * cell + 1, view)
            cell = 2 * cell + 2
        else:
            layout.AssignView(cell, view)
    layout.SetSize(PANEL * len(views), PANEL)
    SaveScreenshot(path, layout, ImageResolution=[PANEL * len(views), PANEL],
                   SeparatorWidth=0, CompressionLevel="9")


def draw_scalar(field, view, name, preset):
    surface = Show(field, view)
    ColorBy(surface, ("POINTS", name), separate=True)
    SetProperties(surface, Ambient=1, Diffuse=0)
    surface.SetScalarBarVisibility(view, False)
    colours = GetColorTransferFunction(name, surface, separate=True)
    colours.ApplyPreset(preset, True)
    array = servermanager.Fetch(field).GetPointData().GetArray(name)
    values = sorted(array.GetValue(i) for i in range(array.GetNumberOfTuples()))
    # Values are infinite at singularities; leaving out the extremes keeps the colours of the
    # others.
    colours.RescaleTransferFunction(values[len(values) // 25], values[-len(values) // 25])
    draw_lines(boundary(field, 1, 2), view, [0.2, 0.2, 0.2], 2)


def draw_labels(points, array, view):
    """Writes the value of a point array beside every point."""
    data = servermanager.Fetch(points)
    values = data.GetPointData().GetArray(array)
    bounds = data.GetBounds()
    size = 0.075 * max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    # Slightly beside the centre, where a corner may be.
    middle = [(bounds[0] + bounds[1] - 0.1 * size) / 2, (bounds[2] + bounds[3] - 0.1 * size) / 2]
    for i in range(data.GetNumberOfPoints()):
        x, y, _ = data.GetPoint(i)
        text = a3DText(Text="%d" % values.GetValue(i))
        side = 1 if values.GetValue(i) >= 0 else -1  # outside at a convex corner, inside at a re-entrant one
        away = 1 + side * (0.9 if side > 0 else 0.6) * size / math.hypot(x - middle[0], y - middle[1])
        placed = Transform(Input=text)
        placed.Transform.Translate = [middle[0] + away * (x - middle[0]) - size / 4,
                                      middle[1] + away * (y - middle[1]) - size / 3, 0]
        placed.Transform.Scale = [size, size, size]
        draw_lines(placed, view, GREEN, 1)
