"""Draws the stress along the tension: xvfb-run pvpython picture.py FOLDER PICTURE.png

FOLDER has the files that plate.py --keep leaves.
"""
import pathlib
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_QUAD, vtkUnstructuredGrid

sys.path[:0] = map(str, pathlib.Path(__file__).resolve().parents[:2])
from calculix import read_mesh, read_results
from plate import LENGTH

folder, picture = map(pathlib.Path, sys.argv[1:3])
places, elements = read_mesh((folder / "plate.inp").read_text())
_, _, stresses = read_results(folder / "plate.frd")

grid, points, stress = vtkUnstructuredGrid(), vtkPoints(), vtkDoubleArray()
points.SetDataTypeToDouble()
stress.SetName("stress over tension")
rows = {node: points.InsertNextPoint(*place) for node, place in places.items()}
for node in places:
    stress.InsertNextValue(stresses[node][1])
grid.SetPoints(points)
grid.GetPointData().SetScalars(stress)
for nodes in elements:  # CPS8 and VTK have the same order of nodes
    grid.InsertNextCell(VTK_QUADRATIC_QUAD, 8, [rows[node] for node in nodes])

source = TrivialProducer()
source.GetClientSideObject().SetOutput(grid)
view = CreateRenderView(ViewSize=[600, 1400], Background=[1, 1, 1], UseColorPaletteForBackground=0,
                        OrientationAxesVisibility=0)
display = Show(source, view)
display.NonlinearSubdivisionLevel = 4
raised = Transform(Input=source)  # in front of the surface
raised.Transform.Translate = [0, 0, 0.01]
edges = Show(raised, view)
edges.Representation, edges.LineWidth, edges.NonlinearSubdivisionLevel = "Wireframe", 1.5, 4
ColorBy(edges, None)
edges.AmbientColor = edges.DiffuseColor = [0, 0, 0]
ColorBy(display, ("POINTS", "stress over tension"))
colours = GetColorTransferFunction("stress over tension")
colours.ApplyPreset("Rainbow Uniform", True)
colours.RescaleTransferFunction(0.0, 4.4)
bar = GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle, bar.TitleColor, bar.LabelColor = "stress", "", [0, 0, 0], [0, 0, 0]
bar.TitleFontSize = bar.LabelFontSize = 20
bar.ScalarBarThickness, bar.RangeLabelFormat, bar.LabelFormat = 25, "%.1f", "%.1f"
bar.WindowLocation = "Any Location"
bar.Position, bar.ScalarBarLength = [0.8, 0.4], 0.25
display.SetScalarBarVisibility(view, True)
view.CameraParallelProjection = 1
view.CameraFocalPoint, view.CameraPosition = [0.65, LENGTH / 2, 0], [0.65, LENGTH / 2, 10]
view.CameraParallelScale = 0.52 * LENGTH
SaveScreenshot(str(picture), view)
