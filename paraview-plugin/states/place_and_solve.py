"""State: place singularities with the mouse and see the field.

Load the plugin, then this file with *File, Load State*. Select *Singularities* and drag its handles
in the view: the field follows. With *Live* switched off in its panel, the field follows when a
handle is released. Spheres are red for positive quarter indices and blue for negative ones. The
text reports whether the field has the prescribed singularities and no others. Where the
singularities admit no field, it gives the reason, and the last picture stays in grey.
"""
from paraview.simple import *

domain = PlanarDomainSource(registrationName="Domain", EdgeLength=0.05)
singularities = SingularitySource(registrationName="Singularities")
drilled = DrillHoles(registrationName="Drilled mesh", Input=domain, Singularities=singularities,
                     MeshSize=0.05)
field = PerforatedCrossField(registrationName="Cross field", Input=drilled)
crosses = CrossGlyphs(registrationName="Crosses", Input=field, Spacing=0.07)
check = PoincareHopfCheck(registrationName="Check", Input=field)

view = CreateRenderView(UseColorPaletteForBackground=0, Background=[1, 1, 1],
                        OrientationAxesVisibility=0, InteractionMode="2D")
AssignViewToLayout(view)
surface = Show(field, view)
SetProperties(surface, ColorArrayName=["POINTS", ""], Ambient=1, Diffuse=0, AmbientColor=[0.85, 0.92, 1])
outline = Show(domain, view)
SetProperties(outline, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0], LineWidth=3)
lines = Show(crosses, view)
SetProperties(lines, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0])
summary = Show(OutputPort(check, 3), view)
SetProperties(summary, Color=[0, 0, 0], FontSize=14, WindowLocation="Lower Center")
# Red: three quads meet at the singularity; blue: five.
spheres = Glyph(registrationName="Spheres", Input=singularities, GlyphType="Sphere",
                ScaleArray=["POINTS", "No scale array"], ScaleFactor=0.06, GlyphMode="All Points")
shown = Show(spheres, view)
ColorBy(shown, ("POINTS", "QuarterIndex"))
colours = GetColorTransferFunction("QuarterIndex")
SetProperties(colours, ColorSpace="RGB", RGBPoints=[-2, 0.1, 0.2, 0.85, -0.1, 0.1, 0.2, 0.85, 0.1, 0.85, 0.1, 0.1,
                                                    2, 0.85, 0.1, 0.1])
SetProperties(shown, Ambient=1, Diffuse=0)
ResetCamera(view)
SetActiveSource(singularities)
