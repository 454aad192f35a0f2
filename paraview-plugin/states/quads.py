"""State: an all-quad mesh of a disk with six irregular nodes, and its blocks.

Change the rows of the singularities and press *Apply*. Without singularities the mesher chooses
them. Blocks have pale colours and thick outlines; nodes of valence 3 are red, nodes of valence 5
blue. The text reports the quality.
"""
from paraview.simple import *

domain = PlanarDomainSource(registrationName="Domain", EdgeLength=0.05)
singularities = SingularitySource(
    registrationName="Singularities",
    Singularities=[0.7, 0.07, 1, 0.05, 0.15, 0.68, 1, 0.05, -0.6, 0.35, 1, 0.05,
                   -0.53, -0.46, 1, 0.05, 0.28, -0.64, 1, 0.05, 0.0, 0.0, -1, 0.05])
quads = QuadMesher(registrationName="Quads", Input=domain, Singularities=singularities, QuadCount=600)

view = CreateRenderView(UseColorPaletteForBackground=0, Background=[1, 1, 1],
                        OrientationAxesVisibility=0, InteractionMode="2D")
AssignViewToLayout(view)
shown = Show(quads, view)
ColorBy(shown, ("CELLS", "BlockId"))
SetProperties(
    GetColorTransferFunction("BlockId"), AutomaticRescaleRangeMode="Never", Discretize=0,
    RGBPoints=[value for block in range(200) for value in (
        block, *[(0.98, 0.85, 0.8), (0.82, 0.9, 0.98), (0.85, 0.96, 0.84), (0.97, 0.94, 0.76),
                 (0.91, 0.85, 0.96)][block * 7 % 5])])
shown.SetScalarBarVisibility(view, False)
SetProperties(shown, Representation="Surface With Edges", EdgeColor=[0.4, 0.4, 0.4], Ambient=1, Diffuse=0)
layout = Show(OutputPort(quads, 2), view)
SetProperties(layout, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0],
              LineWidth=3)
for name, low, high, colour in (("Valence 3", 1, 9, [0.85, 0.1, 0.1]), ("Valence 5", -9, -1, [0.1, 0.2, 0.85])):
    nodes = Threshold(registrationName=name, Input=OutputPort(quads, 6), Scalars=["POINTS", "QuarterIndex"],
                      LowerThreshold=low, UpperThreshold=high)
    discs = Glyph(registrationName=name + " as discs", Input=nodes, GlyphType="Sphere",
                  ScaleArray=["POINTS", "No scale array"], ScaleFactor=0.05, GlyphMode="All Points")
    SetProperties(Show(discs, view), ColorArrayName=[None, ""], AmbientColor=colour, DiffuseColor=colour,
                  Ambient=1, Diffuse=0)
SetProperties(Show(OutputPort(quads, 8), view), Color=[0, 0, 0], FontSize=14, WindowLocation="Lower Center")
Hide(singularities, view)
ResetCamera(view)
