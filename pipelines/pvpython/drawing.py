"""Draws cross fields for the scripts of this folder: norm in bands, crosses, boundary,
singularities.

Load the plugin before calling these functions. Sources and filters are proxies of paraview.simple.
"""
import argparse
import os

import paraview.simple as pv


def draw_each(description, view_of):
    """Runs a script that draws files: loads the plugin, and writes NAME.png from view_of(path,
    width) for every name."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
    parser.add_argument("--width", type=int, default=600, help="of the pictures, in pixels")
    parser.add_argument("folder")
    parser.add_argument("names", nargs="+")
    arguments = parser.parse_args()
    pv.LoadPlugin(arguments.plugin, ns=vars(pv))
    for name in arguments.names:
        path = os.path.join(arguments.folder, name)
        view = view_of(path, arguments.width)
        pv.SaveScreenshot(path + ".png", view, CompressionLevel="9")
        pv.Delete(view)
        print("wrote", path + ".png")


def draw_norm(field, view, least=None, largest=None, show_bar=True):
    """Colours the domain by the norm of the representation, in bands, white where it is 1."""
    surface = pv.Show(field, view)
    pv.ColorBy(surface, ("POINTS", "CrossNorm"))
    pv.SetProperties(surface, Ambient=1, Diffuse=0)
    found = field.PointData["CrossNorm"].GetRange()
    least = found[0] if least is None else least
    largest = found[1] if largest is None else largest
    colours = pv.GetColorTransferFunction("CrossNorm")
    pv.SetProperties(colours, ColorSpace="RGB", NumberOfTableValues=20,
                     RGBPoints=[min(least, 0.9), 0.42, 0.68, 0.86,
                                1, 1, 1, 1,
                                max(largest, 1.1), 0.96, 0.65, 0.35])
    bar = pv.GetScalarBar(colours, view)
    pv.SetProperties(bar, Title="Norm of the cross field", ComponentTitle="",
                     Visibility=int(show_bar), Orientation="Horizontal",
                     WindowLocation="Any Location", Position=[0.25, 0.02], ScalarBarLength=0.5,
                     AutomaticLabelFormat=0, LabelFormat="%.1f", RangeLabelFormat="%.1f",
                     TitleColor=[0, 0, 0], LabelColor=[0, 0, 0])


def boundary(field, first_kind, last_kind):
    """Returns the lines of the mesh whose BoundaryKind is in a range."""
    return pv.Threshold(Input=field, Scalars=["CELLS", "BoundaryKind"],
                        LowerThreshold=first_kind, UpperThreshold=last_kind)


def draw_lines(source, view, colour, width):
    lines = pv.Show(source, view)
    pv.SetProperties(lines, ColorArrayName=[None, ""], AmbientColor=colour, DiffuseColor=colour,
                     LineWidth=width)


def draw_boundaries(field, view):
    """Draws outer and inner loops in grey, holes and imprinted circles in red."""
    draw_lines(boundary(field, 1, 2), view, [0.2, 0.2, 0.2], 2)
    draw_lines(boundary(field, 3, 4), view, [0.85, 0.1, 0.1], 4)


def draw_singularities(points, view, size, array="QuarterIndex"):
    """Draws positive singularities in red and negative ones in blue, as discs of this radius."""
    for sign, colour in ((1, [0.85, 0.1, 0.1]), (-1, [0.1, 0.2, 0.85])):
        kept = pv.Threshold(Input=points, Scalars=["POINTS", array],
                            LowerThreshold=min(sign, 10 * sign),
                            UpperThreshold=max(sign, 10 * sign))
        kept.UpdatePipeline()
        if kept.GetDataInformation().GetNumberOfPoints() == 0:
            continue
        discs = pv.Glyph(Input=kept, GlyphType="Sphere", ScaleArray=["POINTS", "No scale array"],
                         ScaleFactor=2 * size, GlyphMode="All Points")
        shown = pv.Show(discs, view)
        pv.SetProperties(shown, ColorArrayName=[None, ""], AmbientColor=colour,
                         DiffuseColor=colour, Ambient=1, Diffuse=0)


def white_view(width, height):
    return pv.CreateRenderView(ViewSize=[width, height], OrientationAxesVisibility=0,
                               UseColorPaletteForBackground=0, Background=[1, 1, 1])


def look_from_above(view, bounds, room_below=0.05):
    """Centres the bounds in the view, with a fraction of their height left free below for the
    colour bar."""
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    middle = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2 - room_below * height]
    across = width * view.ViewSize[1] / view.ViewSize[0]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = middle + [0]
    view.CameraPosition = middle + [max(width, height)]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = 0.58 * max(across, height)
