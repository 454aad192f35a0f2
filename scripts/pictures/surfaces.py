"""Meshes and draws the pictures of docs/surfaces.md.

    xvfb-run -a -s -noreset pvpython scripts/pictures/surfaces.py PROGRAM FOLDER
"""
import math
import os
import subprocess
import sys
import tempfile

import vtk

SIDE = 420  # of a panel, in pixels


def isosurface():
    """Returns a level of a sum of potentials, through which a hole leads."""
    def field(x, y, z):
        return sum(0.2 / ((x - math.cos(a)) ** 2 + (y - math.sin(a)) ** 2 + z * z + 0.02)
                   for a in (2 * math.pi * k / 5 for k in range(5)))
    count, step = 40, 4.0 / 39
    image = vtk.vtkImageData()
    image.SetDimensions(count, count, count)
    image.SetSpacing(step, step, step)
    image.SetOrigin(-2, -2, -2)
    image.AllocateScalars(vtk.VTK_DOUBLE, 1)
    for point in range(image.GetNumberOfPoints()):
        image.GetPointData().GetScalars().SetValue(point, field(*image.GetPoint(point)))
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 1.0)
    contour.ComputeNormalsOff()
    smooth = vtk.vtkWindowedSincPolyDataFilter()  # triangles of a grid are slivers
    smooth.SetInputConnection(contour.GetOutputPort())
    smooth.SetNumberOfIterations(30)
    smooth.SetPassBand(0.02)
    smooth.NormalizeCoordinatesOn()
    smooth.Update()
    return smooth.GetOutput()


def panel():
    """Returns a bent plate with three holes, without its corners."""
    holes = [(0.3, 0.3, 0.1), (0.7, 0.35, 0.14), (0.45, 0.72, 0.12)]
    points = vtk.vtkPoints()
    for i in range(51):
        for j in range(51):
            x, y = i / 50, j / 50
            if all(math.hypot(x - a, y - b) > r + 0.012 for a, b, r in holes):
                points.InsertNextPoint(x, y, 0)
    for a, b, r in holes:
        steps = int(320 * r)
        for k in range(steps):
            angle = 2 * math.pi * k / steps
            points.InsertNextPoint(a + r * math.cos(angle), b + r * math.sin(angle), 0)
    flat = vtk.vtkPolyData()
    flat.SetPoints(points)
    delaunay = vtk.vtkDelaunay2D()
    delaunay.SetInputData(flat)
    delaunay.Update()
    places = delaunay.GetOutput().GetPoints()
    cells = vtk.vtkCellArray()
    for cell in range(delaunay.GetOutput().GetNumberOfCells()):
        ids = [delaunay.GetOutput().GetCell(cell).GetPointId(i) for i in range(3)]
        x, y = (sum(places.GetPoint(v)[axis] for v in ids) / 3 for axis in (0, 1))
        if all(math.hypot(x - a, y - b) > r for a, b, r in holes):
            cells.InsertNextCell(3, ids)
    for v in range(places.GetNumberOfPoints()):
        x, y, _ = places.GetPoint(v)
        places.SetPoint(v, x, y, 0.35 * math.sin(2.2 * x) * math.cos(1.8 * y))
    bent = vtk.vtkPolyData()
    bent.SetPoints(places)
    bent.SetPolys(cells)
    return bent


def write(surface, path):
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(surface)
    writer.Write()


def add_quads(path, window, column, columns, direction, zoom):
    """Draws quads, with irregular nodes in red and blue, in a column of the window."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(column / columns, 0, (column + 1) / columns, 1)
    renderer.SetBackground(1, 1, 1)
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputData(grid)
    mapper.ScalarVisibilityOff()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    quads = vtk.vtkActor()
    quads.SetMapper(mapper)
    quads.GetProperty().SetColor(0.86, 0.88, 0.92)
    renderer.AddActor(quads)
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(grid)
    lines = vtk.vtkPolyDataMapper()
    lines.SetInputConnection(edges.GetOutputPort())
    lines.ScalarVisibilityOff()
    drawn = vtk.vtkActor()
    drawn.SetMapper(lines)
    drawn.GetProperty().SetColor(0.25, 0.3, 0.4)
    drawn.GetProperty().LightingOff()
    renderer.AddActor(drawn)
    size = max(b - a for a, b in zip(grid.GetBounds()[::2], grid.GetBounds()[1::2]))
    indices, sides = (grid.GetPointData().GetArray(name) for name in ("Irregular", "BoundarySide"))
    for point in range(grid.GetNumberOfPoints()):
        if indices.GetValue(point) != 0 and sides.GetValue(point) < 0:
            ball = vtk.vtkSphereSource()
            ball.SetCenter(grid.GetPoint(point))
            ball.SetRadius(0.014 * size)
            balls = vtk.vtkPolyDataMapper()
            balls.SetInputConnection(ball.GetOutputPort())
            actor = vtk.vtkActor()
            actor.SetMapper(balls)
            actor.GetProperty().SetColor(*((0.85, 0.2, 0.15) if indices.GetValue(point) > 0 else (0.15, 0.35, 0.85)))
            renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetPosition(*direction)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()
    window.AddRenderer(renderer)


def draw(program, inputs, zoom, path):
    """Meshes surfaces, given with a number of quads and a direction of view, and draws them beside each other."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(SIDE * len(inputs), SIDE)
    with tempfile.TemporaryDirectory() as work:
        for column, (surface, count, direction) in enumerate(inputs):
            quads = os.path.join(work, "quads.vtu")
            subprocess.run([program, "quads", surface, "--quads", str(count), "-o", quads], check=True)
            add_quads(quads, window, column, len(inputs), direction, zoom)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main(program, folder):
    docs = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../docs/surfaces/")
    with tempfile.TemporaryDirectory() as work:
        ring, plate = os.path.join(work, "ring.vtp"), os.path.join(work, "panel.vtp")
        write(isosurface(), ring)
        write(panel(), plate)
        draw(program, ((docs + "ellipsoid.off", 1200, (2, -3, 1.6)), (ring, 2500, (0.5, -2, 3)),
                       (plate, 1200, (0.4, -1.4, 3))), 1.2, os.path.join(folder, "chosen.png"))
    draw(program, ((docs + "bracket.off", 1500, (2, -3, 3)), (docs + "bracket.off", 1500, (-2, 3, -3))), 0.95,
         os.path.join(folder, "bracket.png"))


main(*sys.argv[1:])
