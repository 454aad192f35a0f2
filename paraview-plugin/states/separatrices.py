"""State: the separatrices of eight singularities in a ring, and the patches between them.

There are four singularities of each sign. Separatrices are red if they start at quarter index 1,
blue at -1; patches have pale colours; thin black lines are streamlines of the field from one seed.
"""
import paraview

paraview.compatibility.major, paraview.compatibility.minor = 5, 11  # Position, which ParaView 5.13 renames
from paraview.simple import *

domain = PlanarDomainSource(registrationName="Domain", DomainName="ring", EdgeLength=0.04)
singularities = SingularitySource(
    registrationName="Singularities",
    Singularities=[0.796, 0.08, 1, 0.05, -0.08, 0.796, 1, 0.05, -0.796, -0.08, 1, 0.05,
                   0.08, -0.796, 1, 0.05, 0.547, 0.055, -1, 0.05, -0.055, 0.547, -1, 0.05,
                   -0.547, -0.055, -1, 0.05, 0.055, -0.547, -1, 0.05])
flat = CrossFieldMap(registrationName="Seamless map", Input=domain, Singularities=singularities,
                     MeshSize=0.04, RepairHolonomy=1)
seed = SingularitySource(registrationName="Seed", Singularities=[0.6, 0.35, 1, 0.05])
lines = Separatrices(registrationName="Separatrices", Input=flat, Seeds=seed)

view = CreateRenderView(UseColorPaletteForBackground=0, Background=[1, 1, 1],
                        OrientationAxesVisibility=0, InteractionMode="2D")
AssignViewToLayout(view)
faces = Show(OutputPort(lines, 1), view)
ColorBy(faces, ("CELLS", "FaceId"))
SetProperties(
    GetColorTransferFunction("FaceId"), AutomaticRescaleRangeMode="Never", Discretize=0,
    RGBPoints=[value for face in range(24) for value in (
        face, *[(0.98, 0.85, 0.8), (0.82, 0.9, 0.98), (0.85, 0.96, 0.84), (0.97, 0.94, 0.76),
                (0.91, 0.85, 0.96)][face * 7 % 5])])
faces.SetScalarBarVisibility(view, False)
SetProperties(faces, Ambient=1, Diffuse=0)
# A threshold of 0 would be replaced by the minimum of the array, -1.
separatrices = Threshold(registrationName="Separatrices only", Input=lines,
                         Scalars=["CELLS", "Line"], LowerThreshold=-0.5, UpperThreshold=1e9)
shown = Show(separatrices, view)
ColorBy(shown, ("CELLS", "Singularity"))
# The first four singularities have quarter index 1.
SetProperties(GetColorTransferFunction("Singularity"), AutomaticRescaleRangeMode="Never", ColorSpace="RGB",
              RGBPoints=[0, 0.85, 0.1, 0.1, 3.4, 0.85, 0.1, 0.1, 3.6, 0.1, 0.2, 0.85, 7, 0.1, 0.2, 0.85])
shown.SetScalarBarVisibility(view, False)
SetProperties(shown, LineWidth=3, Ambient=1, Diffuse=0, Position=[0, 0, 0.001])
streamlines = Threshold(registrationName="Streamlines", Input=lines, Scalars=["CELLS", "Seed"],
                        LowerThreshold=-0.5, UpperThreshold=1e9)
thin = Show(streamlines, view)
SetProperties(thin, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0], LineWidth=2,
              Position=[0, 0, 0.002])
Hide(lines, view)
ResetCamera(view)
