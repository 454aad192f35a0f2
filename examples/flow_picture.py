"""Draws cells and speed of a flow: xvfb-run pvpython flow_picture.py CASE PICTURE.png X Y HEIGHT [TOP]

CASE is the folder of a case of OpenFOAM that was solved. The picture is HEIGHT high around (X, Y); TOP is the upper end of
the colours of speed, by default the largest speed.
"""
import pathlib
import sys

from paraview.simple import *

case, picture = map(pathlib.Path, sys.argv[1:3])
x, y, height = map(float, sys.argv[3:6])
reader = OpenFOAMReader(FileName=str(next(case.glob("*.foam"))))
reader.MeshRegions = ["internalMesh"]
reader.CellArrays = ["U"]
reader.Createcelltopointfiltereddata = 0
reader.UpdatePipeline()
reader.UpdatePipeline(reader.TimestepValues[-1])
sheet = MergeBlocks(Input=reader)  # cells of one layer
speed = Calculator(Input=sheet, AttributeType="Cell Data", ResultArrayName="speed", Function="mag(U)")
smooth = CellDatatoPointData(Input=speed)

layout = CreateLayout()
views = []
for place in range(2):
    view = CreateRenderView(Background=[1, 1, 1], UseColorPaletteForBackground=0, OrientationAxesVisibility=0)
    view.CameraParallelProjection = 1
    view.CameraFocalPoint, view.CameraPosition = [x, y, 0], [x, y, 100]
    view.CameraParallelScale = height / 2
    views.append(view)
AssignViewToLayout(view=views[0], layout=layout, hint=0)
layout.SplitHorizontal(0, 0.5)
AssignViewToLayout(view=views[1], layout=layout, hint=2)

cells = Show(sheet, views[0])
cells.Representation, cells.LineWidth = "Surface With Edges", 1.0
ColorBy(cells, ("CELLS", ""))
cells.DiffuseColor, cells.EdgeColor, cells.Ambient, cells.Diffuse = [1, 1, 1], [0.1, 0.2, 0.5], 1.0, 0.0

flow = Show(smooth, views[1])
ColorBy(flow, ("POINTS", "speed"))
flow.Ambient, flow.Diffuse = 1.0, 0.0
colours = GetColorTransferFunction("speed")
colours.ApplyPreset("Viridis (matplotlib)", True)
low, high = smooth.PointData["speed"].GetRange()
colours.RescaleTransferFunction(0.0, float(sys.argv[6]) if len(sys.argv) > 6 else high)
bar = GetScalarBar(colours, views[1])
bar.Title, bar.ComponentTitle, bar.TitleColor, bar.LabelColor = "speed", "", [1, 1, 1], [1, 1, 1]
bar.TitleFontSize = bar.LabelFontSize = 18
bar.WindowLocation, bar.ScalarBarLength = "Lower Right Corner", 0.3
flow.SetScalarBarVisibility(views[1], True)
SaveScreenshot(str(picture), layout, ImageResolution=[1120, 480])
