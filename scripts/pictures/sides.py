"""Meshes and draws the pictures of docs/sides.md, coloured by side.

    xvfb-run -a pvpython scripts/pictures/sides.py PROGRAM FOLDER
"""
import math
import os
import subprocess
import sys
import tempfile

import vtk

COLOURS = ((214, 39, 40), (31, 119, 180), (44, 160, 44), (148, 103, 189), (255, 127, 14), (23, 190, 207))
RECTANGLE = [(0, 0, "inlet"), (0, 2, "top"), (4, 2, "outlet"), (4, 0, "bottom")]


def circle(count, radius, centre, names):
    return [(centre[0] + radius * math.cos(2 * math.pi * i / count),
             centre[1] + radius * math.sin(2 * math.pi * i / count), names(i)) for i in range(count)]


def write_domain(path, loops):
    """Writes loops of (x, y, name of the segment that starts there)."""
    points, lines, names = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkStringArray()
    points.SetDataTypeToDouble()
    names.SetName("Side")
    for loop in loops:
        first = points.GetNumberOfPoints()
        for i, (x, y, name) in enumerate(loop):
            points.InsertNextPoint(x, y, 0)
            lines.InsertNextCell(2)
            lines.InsertCellPoint(first + i)
            lines.InsertCellPoint(first + (i + 1) % len(loop))
            names.InsertNextValue(name)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    data.GetCellData().AddArray(names)
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.SetDataModeToBinary()
    writer.Write()


def cascade():
    """Returns the passage of a turbine cascade, whose sides low and high are translates, around a blade."""
    first, last, pitch, count = math.tan(math.radians(30)), -math.tan(math.radians(50)), 0.9, 60

    def camber(x):
        inside = min(max(x, 0.0), 1.0)
        y = first * inside + (last - first) * inside ** 2 / 2
        return y + first * min(x, 0.0) + last * max(x - 1.0, 0.0)

    low = [(x, camber(x) - pitch / 2) for x in (-0.6 + 2.2 * i / count for i in range(count + 1))]
    high = [(x, y + pitch) for x, y in reversed(low)]
    outer = ([(x, y, "low" if i < count else "outlet") for i, (x, y) in enumerate(low)] +
             [(x, y, "high" if i < count else "inlet") for i, (x, y) in enumerate(high)])
    blade = []
    for i in range(120):
        angle = 2 * math.pi * i / 120
        x = 0.5 - 0.5 * math.cos(angle)
        blade.append((x, camber(x) - 0.07 * math.sin(angle) * (1 - 0.5 * x), "blade"))
    return [outer, blade]


def draw_with_neighbours(path, picture, size=(900, 700)):
    """Draws quads in blue between their images under the motion of the periodic sides and its inverse."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    motion = vtk.vtkMatrix4x4()
    motion.DeepCopy(grid.GetFieldData().GetArray("PeriodicMotion").GetTuple(0))
    quads, sides = vtk.vtkPolyData(), vtk.vtkPolyData()
    cells = {vtk.VTK_QUAD: vtk.vtkCellArray(), vtk.VTK_LINE: vtk.vtkCellArray()}
    for cell in range(grid.GetNumberOfCells()):
        ids = vtk.vtkIdList()
        grid.GetCellPoints(cell, ids)
        cells[grid.GetCellType(cell)].InsertNextCell(ids)
    quads.SetPoints(grid.GetPoints())
    quads.SetPolys(cells[vtk.VTK_QUAD])
    sides.SetPoints(grid.GetPoints())
    sides.SetLines(cells[vtk.VTK_LINE])
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for copy in (-1, 0, 1):
        transform = vtk.vtkTransform()
        transform.SetMatrix(motion)
        if copy == 0:
            transform.Identity()
        elif copy < 0:
            transform.Inverse()
        for data in (quads, sides):
            mapper = vtk.vtkPolyDataMapper()
            mapper.SetInputData(data)
            actor = vtk.vtkActor()
            actor.SetMapper(mapper)
            actor.SetUserTransform(transform)
            actor.GetProperty().LightingOff()
            if data is quads:
                actor.GetProperty().SetColor(*((0.85, 0.91, 0.98) if copy == 0 else (0.96, 0.96, 0.95)))
                actor.GetProperty().EdgeVisibilityOn()
                actor.GetProperty().SetEdgeColor(*((0.1, 0.3, 0.55) if copy == 0 else (0.55, 0.55, 0.55)))
            else:
                actor.GetProperty().SetColor(0.84, 0.15, 0.16)
                actor.GetProperty().SetLineWidth(3)
            renderer.AddActor(actor)
    bounds = grid.GetBounds()
    save_view(renderer, picture, size, ((bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2),
              1.03 * (bounds[3] - bounds[2]))


def save_view(renderer, picture, size, centre, height):
    """Writes a view along z, around a point, of a height in the plane."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(centre[0], centre[1], 0)
    camera.SetPosition(centre[0], centre[1], 1)
    camera.SetParallelScale(height / 2)
    renderer.ResetCameraClippingRange()
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def draw(path, picture, size=(900, 470)):
    """Draws quads with their boundary edges, coloured by the array Side."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    side = grid.GetCellData().GetAbstractArray("Side")
    quads, lines = vtk.vtkCellArray(), vtk.vtkCellArray()
    names = []
    for cell in range(grid.GetNumberOfCells()):
        ids = vtk.vtkIdList()
        grid.GetCellPoints(cell, ids)
        if grid.GetCellType(cell) == vtk.VTK_QUAD:
            quads.InsertNextCell(ids)
        else:
            lines.InsertNextCell(ids)
            names.append(side.GetValue(cell))
    order = list(dict.fromkeys(names))
    colours = vtk.vtkUnsignedCharArray()
    colours.SetNumberOfComponents(3)
    for name in names:
        colours.InsertNextTuple3(*COLOURS[order.index(name) % len(COLOURS)])
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for polys, edges in ((quads, None), (None, lines)):
        data = vtk.vtkPolyData()
        data.SetPoints(grid.GetPoints())
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputData(data)
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        if polys:
            data.SetPolys(polys)
            actor.GetProperty().SetColor(0.95, 0.95, 0.93)
            actor.GetProperty().EdgeVisibilityOn()
            actor.GetProperty().SetEdgeColor(0.45, 0.45, 0.45)
        else:
            data.SetLines(edges)
            data.GetCellData().SetScalars(colours)
            actor.GetProperty().SetLineWidth(5)
        renderer.AddActor(actor)
    bounds = grid.GetBounds()
    height = 1.05 * max(bounds[3] - bounds[2], (bounds[1] - bounds[0]) * size[1] / size[0])
    save_view(renderer, picture, size, ((bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2), height)


def main(program, folder):
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        part = os.path.join(work, "part.vtp")
        write_domain(part, [RECTANGLE, circle(96, 0.5, (1.5, 1.0), lambda i: "front" if 24 <= i < 72 else "back")])
        for name, arguments in (
                ("names", ["--quads", "500"]),
                ("counts", ["--quads", "500", "--count", "front:12", "--count", "back:19", "--count", "inlet:14"]),
                ("progression", ["--quads", "700", "--progression", "inlet:both:5", "--progression", "outlet:both:5"]),
                ("sizes", ["--size", "0.2", "--size-at", "front:0.04", "--size-at", "back:0.04"])):
            quads = os.path.join(work, name + ".vtu")
            subprocess.run([program, "quads", part, "-o", quads, *arguments], check=True)
            draw(quads, os.path.join(folder, name + ".png"))
        write_domain(part, cascade())
        quads = os.path.join(work, "periodic.vtu")
        subprocess.run([program, "quads", part, "-o", quads, "--quads", "1300", "--periodic", "low:high",
                        "--layers", "blade:0.004,1.3"], check=True)
        draw_with_neighbours(quads, os.path.join(folder, "periodic.png"))


if __name__ == "__main__":
    main(*sys.argv[1:])
