"""State: two configurations on one domain, their fields side by side and their energies in a table.

The table has one row for each configuration, the best first: singularities at distance 0.85 from
the centre of the disk have a lower energy than at 0.6. The titles show the number of unwanted
singularities of each field.
"""
import math

from paraview.simple import *

domain = PlanarDomainSource(registrationName="Domain", EdgeLength=0.05)


def square(radius):
    """Returns rows of four singularities of quarter index 1 on the diagonals."""
    rows = []
    for side in range(4):
        angle = math.pi / 4 + math.pi / 2 * side
        rows += [radius * math.cos(angle), radius * math.sin(angle), 1, 0.05]
    return rows


layout = CreateLayout("Configurations")
configurations = []
for position, radius in enumerate((0.6, 0.85)):
    name = "At %g" % radius
    singularities = SingularitySource(registrationName=name, Singularities=square(radius))
    configurations.append(singularities)
    field = PerforatedCrossField(
        registrationName="Field of " + name, Method="Unit Norm",
        Input=DrillHoles(registrationName="Mesh of " + name, Input=domain,
                         Singularities=singularities, MeshSize=0.05))
    view = CreateRenderView(UseColorPaletteForBackground=0, Background=[1, 1, 1],
                            OrientationAxesVisibility=0, InteractionMode="2D")
    if position == 0:
        cell = layout.SplitVertical(0, 0.7)
        layout.AssignView(layout.SplitHorizontal(1, 0.5), view)
    else:
        layout.AssignView(4, view)
    surface = Show(field, view)
    SetProperties(surface, ColorArrayName=["POINTS", ""], Ambient=1, Diffuse=0,
                  AmbientColor=[0.85, 0.92, 1])
    lines = Show(CrossGlyphs(registrationName="Crosses of " + name, Input=field, Spacing=0.06), view)
    SetProperties(lines, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0])
    outline = Show(domain, view)
    SetProperties(outline, ColorArrayName=["POINTS", ""], AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0], LineWidth=3)
    title = Show(PythonAnnotation(
        registrationName="Title of " + name, Input=field, ArrayAssociation="Field Data",
        Expression="'%d: at distance %g, %%d unwanted' %% "
                   "input.FieldData['UnwantedSingularities'][0] if 'UnwantedSingularities' in "
                   "input.FieldData.keys() else '%d: no field'" % (position, radius, position)), view)
    SetProperties(title, Color=[0, 0, 0], FontSize=12, WindowLocation="Upper Center")
    ResetCamera(view)

energies = SingularityEnergy(registrationName="Energies", Input=domain,
                             Configurations=configurations)
table = CreateView("SpreadSheetView")
layout.AssignView(2, table)
SetProperties(table, HiddenColumnLabels=[
    "Row ID", "Energy", "EnergyLowerBound", "EnergyUpperBound", "EnergyDegreeOnly", "EnergyDegreeOnlyLowerBound",
    "EnergyDegreeOnlyUpperBound", "LogarithmCoefficient", "HolonomyDefect"])
Show(energies, table)
