"""Meshes and draws the pictures of docs/regions.md.

    PYTHONPATH=$(crossfield --paths | sed -n 's/^python: //p') python3 scripts/pictures/regions.py FOLDER
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import crossfield


def partition(polygons):
    """Returns a mesh of polygons with materials; points at the same place are one."""
    points, cells, materials, numbers = vtkPoints(), vtkCellArray(), vtkStringArray(), {}
    points.SetDataTypeToDouble()
    materials.SetName("Material")
    for material, polygon in polygons:
        ids = []
        for x, y in polygon:
            key = (round(x, 9), round(y, 9))
            if key not in numbers:
                numbers[key] = points.InsertNextPoint(x, y, 0)
            ids.append(numbers[key])
        cells.InsertNextCell(len(ids), ids)
        materials.InsertNextValue(material)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetCellData().AddArray(materials)
    return data


def arc(x, y, radius, begin, end, count=48):
    angles = np.linspace(begin, end, count + 1)
    return [(x + radius * np.cos(a), y + radius * np.sin(a)) for a in angles]


def fibre(radius=0.5):
    """Returns a disc in a square, whose rest is two polygons."""
    upper, lower = arc(0, 0, radius, 0, np.pi), arc(0, 0, radius, -np.pi, 0)
    return [("fibre", upper[:-1] + lower[:-1]), ("matrix", [(1, 0), (1, 1), (-1, 1), (-1, 0)] + upper[::-1]),
            ("matrix", [(-1, 0), (-1, -1), (1, -1), (1, 0)] + lower[::-1])]


def sectors():
    return [("abc"[i], arc(0, 0, 1, 2 * np.pi * i / 3 + 0.5, 2 * np.pi * (i + 1) / 3 + 0.5) + [(0, 0)]) for i in range(3)]


def junction():
    a, b = np.tan(np.radians(6)), np.tan(np.radians(22))
    return [("low", [(-1, -1), (1, -1), (1, a), (0, 0), (-1, -a)]), ("left", [(-1, -a), (0, 0), (-b, 1), (-1, 1)]),
            ("right", [(0, 0), (1, a), (1, 1), (-b, 1)])]


def grains(seed=5, rows=4):
    """Returns the Voronoi cells of a jittered grid in a square."""
    random = np.random.RandomState(seed)
    seeds = [(2 * (i % rows + 0.5 + random.uniform(-0.3, 0.3)) / rows - 1, 2 * (i // rows + 0.5 + random.uniform(-0.3, 0.3)) / rows - 1)
             for i in range(rows * rows)]
    cells = []
    for own in seeds:
        cell = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        for other in seeds:
            if other == own:
                continue
            middle, normal = (np.add(own, other)) / 2, np.subtract(other, own)
            distances = [np.dot(np.subtract(p, middle), normal) for p in cell]
            clipped = []
            for i, p in enumerate(cell):
                q, d, e = cell[(i + 1) % len(cell)], distances[i], distances[(i + 1) % len(cell)]
                if d <= 0:
                    clipped.append(p)
                if (d <= 0) != (e <= 0):
                    clipped.append(tuple(np.add(p, np.multiply(d / (d - e), np.subtract(q, p)))))
            cell = clipped
        cells.append(("grain %d" % len(cells), cell))
    return cells


def draw(axes, mesh):
    """Draws quads coloured by region, irregular nodes of valence 3 in red and of valence 5 in blue."""
    axes.add_collection(PolyCollection(mesh.points[mesh.quads][:, :, :2], array=mesh.region * 7 % 20, cmap="Pastel1",
                                       edgecolor="black", linewidth=0.35))
    for a, b in mesh.points[mesh.edges[mesh.boundary_kind == 5]][:, :, :2]:
        axes.plot([a[0], b[0]], [a[1], b[1]], color="black", linewidth=1.2)
    outside = np.zeros(len(mesh.points), bool)
    outside[mesh.edges[mesh.boundary_kind != 5].ravel()] = True
    for index, colour in ((1, "red"), (-1, "blue")):
        chosen = mesh.points[~outside & (mesh.irregular == index)]
        axes.plot(chosen[:, 0], chosen[:, 1], "o", color=colour, markersize=4, zorder=3)
    axes.set_aspect("equal")
    axes.autoscale()
    axes.axis("off")


def main():
    folder = pathlib.Path(sys.argv[1])
    figure, axes = plt.subplots(1, 4, figsize=(16, 4.1))
    for one, polygons, count in zip(axes, (fibre(), sectors(), junction(), grains()), (900, 800, 800, 1500)):
        draw(one, crossfield.quads(partition(polygons), count=count))
    figure.tight_layout(pad=0.3)
    figure.savefig(folder / "regions.png", dpi=70)


if __name__ == "__main__":
    main()
