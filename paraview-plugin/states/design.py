"""State: the layout of eight singularities on a disk, to be dragged.

Drag the handles in the view, edit the rows in the panel, or use its buttons. To design a domain of
your own, change the input of the designer.

Patches have pale colours, which they keep while they change. Separatrices are red if they start at
a singularity of quarter index 1, blue at -1. Everything is grey if the layout is that of earlier
positions. Thin lines are quads, drafts while a handle is dragged. The text summarises the quality
of the layout, or reports why there is none.
"""
import paraview

paraview.compatibility.major, paraview.compatibility.minor = 5, 11  # Position, which ParaView 5.13 renames
from paraview.simple import *

domain = PlanarDomainSource(registrationName="Domain", EdgeLength=0.05)
designer = LayoutDesigner(
    registrationName="Designer", Input=domain, QuadCount=600,
    Singularities=[0.7, 0.07, 1, 0.05, 0.29, 0.64, 1, 0.05, -0.41, 0.57, 1, 0.05, -0.7, -0.07, 1, 0.05,
                   -0.29, -0.64, 1, 0.05, 0.41, -0.57, 1, 0.05, 0.2, 0.02, -1, 0.05, -0.2, -0.02, -1, 0.05])

view = CreateRenderView(UseColorPaletteForBackground=0, Background=[1, 1, 1],
                        OrientationAxesVisibility=0, InteractionMode="2D")
AssignViewToLayout(view)
faces = Show(OutputPort(designer, 1), view)
ColorBy(faces, ("CELLS", "Colour"))
SetProperties(
    GetColorTransferFunction("Colour"), AutomaticRescaleRangeMode="Never", ColorSpace="RGB", Discretize=0,
    RGBPoints=[-1, 0.95, 0.95, 0.95, 0, 0.98, 0.85, 0.8, 1, 0.82, 0.9, 0.98, 2, 0.85, 0.96, 0.84,
               3, 0.97, 0.94, 0.76, 4, 0.91, 0.85, 0.96])
faces.SetScalarBarVisibility(view, False)
SetProperties(faces, Ambient=1, Diffuse=0)
SetProperties(Show(OutputPort(designer, 3), view), Representation="Wireframe", ColorArrayName=["POINTS", ""],
              AmbientColor=[0.6, 0.6, 0.6], DiffuseColor=[0.6, 0.6, 0.6], Position=[0, 0, 0.001],
              Ambient=1, Diffuse=0)
lines = Show(designer, view)
ColorBy(lines, ("CELLS", "Shade"))
lines.SetScalarBarVisibility(view, False)
SetProperties(lines, LineWidth=3, Position=[0, 0, 0.002], Ambient=1, Diffuse=0)
shown = Show(OutputPort(designer, 2), view)
ColorBy(shown, ("POINTS", "QuarterIndex"))
SetProperties(GetColorTransferFunction("Shade"), AutomaticRescaleRangeMode="Never", ColorSpace="RGB",
              RGBPoints=[-1, 0.1, 0.2, 0.85, 0, 0.75, 0.75, 0.75, 1, 0.85, 0.1, 0.1])
SetProperties(GetColorTransferFunction("QuarterIndex"), AutomaticRescaleRangeMode="Never", ColorSpace="RGB",
              RGBPoints=[-1, 0.1, 0.2, 0.85, 0, 0.3, 0.3, 0.3, 1, 0.85, 0.1, 0.1])
shown.SetScalarBarVisibility(view, False)
SetProperties(shown, Representation="Points", PointSize=12, RenderPointsAsSpheres=1, Position=[0, 0, 0.003],
              Ambient=1, Diffuse=0)
SetProperties(Show(OutputPort(designer, 4), view), Color=[0, 0, 0], FontSize=16, WindowLocation="Lower Center")
ResetCamera(view)
view.CameraParallelScale *= 0.82
SetActiveSource(designer)  # shows its handles
