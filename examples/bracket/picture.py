"""Draws the von Mises stress on the deformed bracket: xvfb-run pvpython picture.py FOLDER PICTURE.png

FOLDER has the files that bracket.py --keep leaves.
"""
import pathlib
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_HEXAHEDRON, vtkUnstructuredGrid

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from calculix import equivalent, read_mesh, read_results

MAGNIFICATION = 200.0

folder, picture = map(pathlib.Path, sys.argv[1:3])
places, elements = read_mesh((folder / "bracket.inp").read_text())
_, displacements, stresses = read_results(folder / "bracket.frd")

grid, points, stress = vtkUnstructuredGrid(), vtkPoints(), vtkDoubleArray()
points.SetDataTypeToDouble()
stress.SetName("stress")
rows = {node: points.InsertNextPoint(*(x + MAGNIFICATION * u for x, u in zip(place, displacements[node])))
        for node, place in places.items()}
for node in places:
    stress.InsertNextValue(equivalent(stresses[node]))
grid.SetPoints(points)
grid.GetPointData().SetScalars(stress)
for nodes in elements:  # C3D20 and VTK have the same order of nodes
    grid.InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, 20, [rows[node] for node in nodes])

source = TrivialProducer()
source.GetClientSideObject().SetOutput(grid)
view = CreateRenderView(ViewSize=[1100, 900], Background=[1, 1, 1], UseColorPaletteForBackground=0,
                        OrientationAxesVisibility=0)
display = Show(source, view)
display.Representation, display.NonlinearSubdivisionLevel, display.EdgeColor = "Surface With Edges", 1, [0.2, 0.2, 0.2]
ColorBy(display, ("POINTS", "stress"))
colours = GetColorTransferFunction("stress")
colours.ApplyPreset("Rainbow Uniform", True)
colours.RescaleTransferFunction(0.0, 51.0)
bar = GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle, bar.TitleColor, bar.LabelColor = "MPa", "", [0, 0, 0], [0, 0, 0]
bar.RangeLabelFormat, bar.LabelFormat = "%.0f", "%.0f"
bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.75, 0.5], 0.35
display.SetScalarBarVisibility(view, True)
view.CameraViewUp = [0, 1, 0]
view.CameraFocalPoint, view.CameraPosition = [42, 35, 20], [130, 110, 220]
SaveScreenshot(str(picture), view)
