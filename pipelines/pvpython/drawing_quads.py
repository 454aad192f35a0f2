"""Draws quads for the scripts of this folder: blocks in pale colours, irregular nodes in red and
blue.

Load the plugin before calling these functions. Sources and filters are proxies of paraview.simple.
"""
import paraview.simple as pv

from drawing import draw_lines, draw_singularities, look_from_above, white_view

# Pale colours of different tones, which distinguish adjacent blocks.
PALE = [(0.98, 0.87, 0.72), (0.80, 0.88, 0.96), (0.85, 0.94, 0.80), (0.95, 0.82, 0.88), (0.99, 0.96, 0.75),
        (0.86, 0.83, 0.94), (0.80, 0.94, 0.93)]


def draw_quads(quads, layout, width, node=0.008):
    """Returns a view of this width of the complete mesh; `node` is the radius of nodes relative to
    its extent."""
    quads.UpdatePipeline()
    bounds = quads.GetDataInformation().GetBounds()
    across, high = bounds[1] - bounds[0], bounds[3] - bounds[2]
    view = white_view(width, int(width * min(1.0, 1.06 * high / across)))
    draw_blocks(quads, view)
    draw_lines(layout, view, [0.15, 0.15, 0.15], 2.5 * width / 1500)
    draw_nodes(quads, view, node * max(across, high))
    look_from_above(view, bounds, 0)
    view.CameraParallelScale = 0.52 * max(high, across * view.ViewSize[1] / view.ViewSize[0])
    return view


def draw_blocks(quads, view):
    """Draws the quads with thin edges, coloured by their block."""
    faces = pv.Threshold(Input=quads, Scalars=["CELLS", "BlockId"], LowerThreshold=-0.5,
                         UpperThreshold=1e9)
    count = len(PALE)
    coloured = pv.Calculator(Input=faces, AttributeType="Cell Data", ResultArrayName="Tone",
                             Function="BlockId - %d*floor(BlockId/%d)" % (count, count))
    shown = pv.Show(coloured, view)
    shown.Representation = "Surface With Edges"
    pv.ColorBy(shown, ("CELLS", "Tone"), separate=True)
    shown.SetScalarBarVisibility(view, False)
    colours = pv.GetColorTransferFunction("Tone", shown, separate=True)
    points = [value for tone, colour in enumerate(PALE) for value in (tone, *colour)]
    pv.SetProperties(colours, ColorSpace="RGB", RGBPoints=points)
    pv.SetProperties(shown, Ambient=1, Diffuse=0, EdgeColor=[0.45, 0.45, 0.45], LineWidth=1)


def draw_nodes(quads, view, size):
    """Draws the irregular nodes inside: valence 3 or less in red, 5 or more in blue."""
    nodes = pv.MaskPoints(Input=quads, OnRatio=1, MaximumNumberofPoints=10**7, GenerateVertices=1,
                          SingleVertexPerCell=1)
    inside = pv.Threshold(Input=nodes, Scalars=["POINTS", "BoundarySide"], LowerThreshold=-1,
                          UpperThreshold=-1)
    draw_singularities(inside, view, size, "Irregular")
