"""State: place singularities with the mouse and see the field.

Load the plugin, then this file with *File, Load State*. Select the singularity source: its handles
can be dragged in the view (tick the box of *Places in the 3D View* if they are hidden), and *Apply*
solves again. The text says whether the quarter indices fit the domain.
"""
from paraview.simple import *

domain = PlanarDomainSource(registrationName="Domain", EdgeLength=0.05)
singularities = SingularitySource(registrationName="Singularities", UseHandles=1)
drilled = DrillHoles(registrationName="Drilled mesh", Input=domain, Singularities=singularities,
                     MeshSize=0.05)
field = PerforatedCrossField(registrationName="Cross field", Input=drilled)
crosses = CrossGlyphs(registrationName="Crosses", Input=field)
check = PoincareHopfCheck(registrationName="Check", Input=domain, Singularities=singularities)

view = CreateRenderView(UseColorPaletteForBackground=0, Background=[1, 1, 1],
                        OrientationAxesVisibility=0, InteractionMode="2D")
AssignViewToLayout(view)
surface = Show(field, view)
ColorBy(surface, ("POINTS", "CrossNorm"))
surface.SetScalarBarVisibility(view, True)
SetProperties(GetScalarBar(GetColorTransferFunction("CrossNorm"), view),
              Title="Norm of the cross field", ComponentTitle="", TitleColor=[0, 0, 0], LabelColor=[0, 0, 0])
lines = Show(crosses, view)
SetProperties(lines, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0])
verdict = Show(OutputPort(check, 3), view)
SetProperties(verdict, Color=[0, 0, 0], FontSize=14)
points = Show(singularities, view)
SetProperties(points, PointSize=8, AmbientColor=[0.8, 0, 0], DiffuseColor=[0.8, 0, 0])
ResetCamera(view)
SetActiveSource(singularities)
