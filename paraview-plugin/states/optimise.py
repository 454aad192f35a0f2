"""State: four scattered singularities move to the lowest energy.

Green points are the start, red points the result, and grey lines the paths between them, computed
when the state is loaded. The curve is the renormalised energy W over the iterations (lower is
better). The field is that of the moved singularities.
"""
import paraview

paraview.compatibility.major, paraview.compatibility.minor = 5, 11  # Position, which ParaView 5.13 renames
from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkObject

domain = PlanarDomainSource(registrationName="Domain", EdgeLength=0.05)
start = SingularitySource(
    registrationName="Start",
    Singularities=[0.5, 0.1, 1, 0.05, 0.0, 0.4, 1, 0.05, -0.6, -0.1, 1, 0.05, 0.2, -0.5, 1, 0.05])
moved = SingularityOptimizer(registrationName="Moved", Input=domain, Singularities=start,
                             MeshSize=0.05)
field = PerforatedCrossField(
    registrationName="Cross field", Method="Unit Norm",
    Input=DrillHoles(registrationName="Drilled mesh", Input=domain, Singularities=moved,
                     MeshSize=0.05))
crosses = CrossGlyphs(registrationName="Crosses", Input=field, Spacing=0.06)

layout = CreateLayout("Optimisation")
layout.SplitHorizontal(0, 0.6)
view = CreateRenderView(UseColorPaletteForBackground=0, Background=[1, 1, 1],
                        OrientationAxesVisibility=0, InteractionMode="2D")
layout.AssignView(1, view)
surface = Show(field, view)
SetProperties(surface, ColorArrayName=["POINTS", ""], Ambient=1, Diffuse=0,
              AmbientColor=[0.85, 0.92, 1])
lines = Show(crosses, view)
SetProperties(lines, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0])
# Paths from runs with few iterations; their warnings about convergence are switched off.
paths = [[] for _ in range(4)]
vtkObject.GlobalWarningDisplayOff()
try:
    for iterations in (0, 1, 2, 3, 4, 6, 8, 12, 200):
        partial = SingularityOptimizer(Input=domain, Singularities=start, MeshSize=0.05, MaximumIterations=iterations)
        places = servermanager.Fetch(partial)
        for i in range(4):
            paths[i] += places.GetPoint(i)
        Delete(partial)
finally:
    vtkObject.GlobalWarningDisplayOn()
for number, path in enumerate(paths):
    drawn = Show(PolyLineSource(registrationName="Path %d" % (number + 1), Points=path), view)
    SetProperties(drawn, ColorArrayName=["POINTS", ""], AmbientColor=[0.4, 0.4, 0.4], DiffuseColor=[0.4, 0.4, 0.4],
                  LineWidth=2, Position=[0, 0, 0.01])
legend = Show(Text(registrationName="Legend", Text="green: start, red: lowest energy"), view)
SetProperties(legend, Color=[0, 0, 0], FontSize=14, WindowLocation="Upper Center")
for points, colour in ((start, [0, 0.6, 0]), (moved, [0.8, 0, 0])):
    shown = Show(points, view)
    SetProperties(shown, PointSize=12, RenderPointsAsSpheres=1, ColorArrayName=["POINTS", ""],
                  AmbientColor=colour, DiffuseColor=colour, Position=[0, 0, 0.02])
ResetCamera(view)

chart = CreateView("XYChartView")
layout.AssignView(2, chart)
curve = Show(OutputPort(moved, 1), chart)
SetProperties(curve, UseIndexForXAxis=1, SeriesVisibility=["RenormalizedEnergy"])
chart.ChartTitle = "Renormalised energy"
