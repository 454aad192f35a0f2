"""State: let four scattered singularities move to where the field is smoothest.

The green points are where they start, the red ones where they end, and the grey lines are their ways when the state is
loaded; the curve is the renormalised energy over the iterations. The field is that of the moved singularities.
"""
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
# Where the first steps, of which there are few, lead. That they do not arrive is no news for the window of messages.
ways = [[] for _ in range(4)]
vtkObject.GlobalWarningDisplayOff()
try:
    for iterations in (0, 1, 2, 3, 4, 6, 8, 12, 200):
        way = SingularityOptimizer(Input=domain, Singularities=start, MeshSize=0.05, MaximumIterations=iterations)
        places = servermanager.Fetch(way)
        for i in range(4):
            ways[i] += places.GetPoint(i)
        Delete(way)
finally:
    vtkObject.GlobalWarningDisplayOn()
for number, way in enumerate(ways):
    drawn = Show(PolyLineSource(registrationName="Way %d" % (number + 1), Points=way), view)
    SetProperties(drawn, ColorArrayName=["POINTS", ""], AmbientColor=[0.4, 0.4, 0.4], DiffuseColor=[0.4, 0.4, 0.4],
                  LineWidth=2, Position=[0, 0, 0.01])
legend = Show(Text(registrationName="Legend", Text="green: start, red: where the energy is least"), view)
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
