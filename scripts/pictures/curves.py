"""Meshes and draws the pictures of docs/curves.md.

    xvfb-run -a -s -noreset pvpython scripts/pictures/curves.py PROGRAM FOLDER
"""
import os
import subprocess
import sys
import tempfile

import vtk

from sides import circle, save_view, write_domain

STEPS = 8  # straight parts of a drawn edge


def add_polyline(places, points, lines):
    lines.InsertNextCell(len(places))
    for place in places:
        lines.InsertCellPoint(points.InsertNextPoint(place))


def along(cell, ends):
    """Returns places along a straight line of parametric coordinates."""
    places = []
    for i in range(STEPS + 1):
        t, place, sub = i / STEPS, [0.0] * 3, vtk.mutable(0)
        weights = [0.0] * cell.GetNumberOfPoints()
        cell.EvaluateLocation(sub, [a + t * (b - a) for a, b in zip(*ends)], place, weights)
        places.append(tuple(place))
    return places


def actor_of(points, lines, colour, width):
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetLineWidth(width)
    return actor


def draw(path, picture, centre, height, size=(440, 440), outline=None):
    """Draws quads of any order with their nodes, and a polygon in grey."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    inside, edges = (vtk.vtkPoints(), vtk.vtkCellArray()), (vtk.vtkPoints(), vtk.vtkCellArray())
    for number in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(number)
        if cell.GetCellDimension() == 2:
            corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
            for i in range(4):
                add_polyline(along(cell, (corners[i], corners[(i + 1) % 4])), *inside)
        else:
            add_polyline(along(cell, ((0, 0, 0), (1, 0, 0))), *edges)
    nodes = vtk.vtkPolyData()
    nodes.SetPoints(grid.GetPoints())
    vertices = vtk.vtkVertexGlyphFilter()
    vertices.SetInputData(nodes)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(vertices.GetOutputPort())
    dots = vtk.vtkActor()
    dots.SetMapper(mapper)
    dots.GetProperty().SetPointSize(5)
    dots.GetProperty().SetColor(0.12, 0.47, 0.71)
    dots.GetProperty().LightingOff()
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    if outline:
        polygon = (vtk.vtkPoints(), vtk.vtkCellArray())
        add_polyline([(x, y, 0) for x, y, _ in outline + outline[:1]], *polygon)
        renderer.AddActor(actor_of(*polygon, (0.84, 0.15, 0.16), 1.5))
    renderer.AddActor(actor_of(*inside, (0.45, 0.45, 0.45), 1))
    renderer.AddActor(actor_of(*edges, (0.1, 0.1, 0.1), 2.5))
    renderer.AddActor(dots)
    save_view(renderer, picture, size, centre, height)


def main(program, folder):
    square = [(-2, -2, "bottom"), (2, -2, "right"), (2, 2, "top"), (-2, 2, "left")]
    hole = circle(12, 1.0, (0, 0), lambda i: "hole")
    with tempfile.TemporaryDirectory() as place:
        part, mesh = os.path.join(place, "part.vtp"), os.path.join(place, "quads.vtu")
        write_domain(part, [square, hole])
        for name, options in (("polygon", []), ("circle", ["--curve", "hole:circle"]),
                              ("order2", ["--curve", "hole:circle", "--order", "2"])):
            subprocess.run([program, "quads", part, "-o", mesh, "--quads", "120", *options], check=True,
                           stdout=subprocess.DEVNULL)
            draw(mesh, os.path.join(folder, name + ".png"), (0, 0), 3.2, outline=hole)


if __name__ == "__main__":
    main(*sys.argv[1:])
