"""State: the size field H, the quad sizes that follow from it, and its crosses.

The disk has five singularities of both signs. Colours are the size map; lines are contours of the
size field H, which meet straight boundaries at right angles.
"""
from paraview.simple import *

domain = PlanarDomainSource(registrationName="Domain", EdgeLength=0.04)
singularities = SingularitySource(
    registrationName="Singularities",
    Singularities=[0.5, 0.2, 1, 0.05, -0.45, 0.4, 1, 0.05, -0.3, -0.5, 1, 0.05,
                   0.35, -0.45, 2, 0.05, 0.05, 0.05, -1, 0.05])
field = HField(registrationName="H field", Input=domain, Singularities=singularities, MeshSize=0.04)
crosses = CrossGlyphs(registrationName="Crosses", Input=field, Spacing=0.06)

view = CreateRenderView(UseColorPaletteForBackground=0, Background=[1, 1, 1],
                        OrientationAxesVisibility=0, InteractionMode="2D")
AssignViewToLayout(view)
surface = Show(field, view)
ColorBy(surface, ("POINTS", "SizeMap"))
surface.SetScalarBarVisibility(view, True)
SetProperties(GetScalarBar(GetColorTransferFunction("SizeMap"), view),
              Title="Size, 1 on average", ComponentTitle="", TitleColor=[0, 0, 0], LabelColor=[0, 0, 0])
field.UpdatePipeline()
smallest, largest = field.PointData["H"].GetRange()
levels = [smallest + (largest - smallest) * (i + 0.5) / 16 for i in range(16)]
contours = Show(Contour(registrationName="Contours of H", Input=field, ContourBy=["POINTS", "H"],
                        Isosurfaces=levels), view)
SetProperties(contours, ColorArrayName=["POINTS", ""], AmbientColor=[0.5, 0, 0.5], DiffuseColor=[0.5, 0, 0.5])
lines = Show(crosses, view)
SetProperties(lines, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0])
outline = Show(domain, view)
SetProperties(outline, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0], LineWidth=3)
spheres = Glyph(registrationName="Spheres", Input=singularities, GlyphType="Sphere",
                ScaleArray=["POINTS", "No scale array"], ScaleFactor=0.05, GlyphMode="All Points")
shown = Show(spheres, view)
ColorBy(shown, ("POINTS", "QuarterIndex"))
colours = GetColorTransferFunction("QuarterIndex")
SetProperties(colours, ColorSpace="RGB", RGBPoints=[-2, 0.1, 0.2, 0.85, -0.1, 0.1, 0.2, 0.85, 0.1, 0.85, 0.1, 0.1,
                                                    2, 0.85, 0.1, 0.1])
SetProperties(shown, Ambient=1, Diffuse=0)
title = Show(Text(registrationName="Title", Text="Sizes of quads, and contours of the size field H"), view)
SetProperties(title, Color=[0, 0, 0], FontSize=16, WindowLocation="Upper Center")
ResetCamera(view)
