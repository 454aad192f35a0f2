"""Draws the pictures of docs/mesh_a_part.md and of the other pages that take one part from start to end.

    PYTHONPATH=$(crossfield --paths | sed -n 's/^python: //p') python3 scripts/pictures/parts.py RESULTS DOCS

RESULTS has a folder for each page with the files that its commands write: scripts/parts.sh runs both.
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_LINE, VTK_QUAD
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "examples"))
from calculix import equivalent, read_mesh, read_results  # noqa: E402

SIDES = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e")


class Mesh:
    """Quads and named boundary edges of a .vtu file."""

    def __init__(self, path):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        self.points = vtk_to_numpy(grid.GetPoints().GetData())[:, :2]
        side = grid.GetCellData().GetAbstractArray("Side")
        region = grid.GetCellData().GetArray("Region")
        self.quads, self.edges, self.regions = [], {}, []
        for cell in range(grid.GetNumberOfCells()):
            ids = grid.GetCell(cell).GetPointIds()
            nodes = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
            if grid.GetCellType(cell) == VTK_QUAD:
                self.quads.append(nodes)
                self.regions.append(region.GetTuple1(cell) if region else 0)
            elif grid.GetCellType(cell) == VTK_LINE:
                self.edges.setdefault(side.GetValue(cell), []).append(nodes)
        self.quads = np.array(self.quads)
        # Valences of nodes of the boundary and of interfaces do not show irregular nodes.
        self.irregular = np.bincount(self.quads.ravel(), minlength=len(self.points))
        self.irregular[np.unique(np.concatenate(list(self.edges.values())))] = 4

    def draw(self, axes, colours=None, width=0.4):
        """Draws quads, and the sides in colours with a legend."""
        # Without snap=False lines are moved to whole pixels, one by one.
        axes.add_collection(PolyCollection(self.points[self.quads], edgecolor="0.3", linewidth=width, snap=False,
                                           facecolor=colours if colours is not None else "#f4f4f0"))
        for (name, edges), colour in zip(sorted(self.edges.items()), SIDES):
            axes.add_collection(LineCollection(self.points[np.array(edges)], color=colour, linewidth=2.2, label=name))
        for valence, colour in ((3, "red"), (5, "blue")):
            axes.plot(*self.points[self.irregular == valence].T, "o", color=colour, markersize=4, zorder=3)


def finish(axes, low=None, high=None):
    axes.set_aspect("equal")
    axes.autoscale()
    if low:
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
    axes.axis("off")


def save(figure, path):
    figure.tight_layout(pad=0.3)
    figure.savefig(path, dpi=100)
    plt.close(figure)


def sides(path, picture, size, **legend):
    figure, axes = plt.subplots(figsize=size)
    Mesh(path).draw(axes)
    finish(axes)
    axes.legend(frameon=False, **legend)
    save(figure, picture)


class Solved:
    """Elements of order 2 of an .inp file, each as the polygon of its eight nodes."""

    def __init__(self, mesh):
        text = mesh.read_text()
        # read_mesh() reads one block of elements; a mesh of several materials has one for each.
        self.places, elements = read_mesh(text)
        for part in text.split("*ELEMENT")[2:]:
            elements += read_mesh(text.split("*ELEMENT")[0] + "*ELEMENT" + part)[1]
        around = [0, 4, 1, 5, 2, 6, 3, 7]
        self.elements = [[nodes[i] for i in around] for nodes in elements]

    def polygons(self):
        return [[self.places[node][:2] for node in nodes] for nodes in self.elements]

    def draw(self, axes, values, low, high, label):
        """Draws each element as a fan around its middle, so that colours follow the values at its nodes."""
        points, triangles, colours = [], [], []
        for nodes in self.elements:
            first = len(points)
            points += [self.places[node][:2] for node in nodes]
            colours += [values[node] for node in nodes]
            # Value and place in the middle of a serendipity element.
            weights = np.array([-0.25, 0.5] * 4)
            points.append(tuple(weights @ np.array(points[first:first + 8])))
            colours.append(weights @ np.array(colours[first:first + 8]))
            triangles += [(first + i, first + (i + 1) % 8, first + 8) for i in range(8)]
        shown = axes.tripcolor(*np.array(points).T, triangles, colours, shading="gouraud", cmap="turbo", vmin=low, vmax=high)
        axes.add_collection(PolyCollection(self.polygons(), facecolor="none", edgecolor="0.2", linewidth=0.3, snap=False))
        axes.figure.colorbar(shown, ax=axes, shrink=0.7, label=label)


def mesh_a_part(results, docs):
    for name, size in (("names", (6, 5)), ("bracket", (6, 5))):
        sides(results / f"{name}.vtu", docs / {"names": "names.png", "bracket": "quads.png"}[name], size, loc="upper right")


def named_svg(results, docs):
    for name, size in (("channel", (8, 4)), ("corner", (8, 4.3))):
        sides(results / f"{name}.vtu", docs / f"{name}.png", size, loc="center left", bbox_to_anchor=(1, 0.5))


def stress_at_holes(results, docs):
    mesh = Mesh(results / "bar.vtu")
    figure, axes = plt.subplots(figsize=(11, 2.6))
    mesh.draw(axes)
    finish(axes)
    axes.legend(frameon=False, loc="lower right", ncol=5, bbox_to_anchor=(1, -0.02), fontsize=8)
    save(figure, docs / "mesh.png")
    fine = Solved(results / "bar.inp")
    _, _, stresses = read_results(results / "pull.frd")
    figure, axes = plt.subplots(figsize=(9, 2.6))
    fine.draw(axes, {node: equivalent(stress) for node, stress in stresses.items()}, 0, 133, "MPa")
    finish(axes, (30, -40), (150, 0))
    save(figure, docs / "stress.png")


def flow_around_a_profile(results, docs):
    mesh = Mesh(results / "profile.vtu")
    figure, rows = plt.subplots(1, 3, figsize=(12, 4))
    for axes, (low, high) in zip(rows, (((-10.2, -10.2), (10.2, 10.2)), ((-0.5, -1), (1.5, 1)), ((0.9, -0.1), (1.1, 0.1)))):
        mesh.draw(axes, width=0.25)
        finish(axes, low, high)
    save(figure, docs / "mesh.png")


def two_materials(results, docs):
    mesh = Mesh(results / "rod.vtu")
    figure, axes = plt.subplots(figsize=(5, 5))
    mesh.draw(axes, np.array(["#f9dcd0", "#d1e5f7"])[np.array(mesh.regions, int)])
    finish(axes)
    axes.legend(frameon=False, loc="lower right")
    save(figure, docs / "quads.png")
    solved = Solved(results / "rod.inp")
    rows = [line.split() for line in (results / "heat.dat").read_text().splitlines()]
    figure, axes = plt.subplots(figsize=(6, 5))
    solved.draw(axes, {int(row[0]): float(row[1]) for row in rows if len(row) == 2}, 0, 436, "K")
    finish(axes)
    save(figure, docs / "temperature.png")


def main():
    results, docs = map(pathlib.Path, sys.argv[1:3])
    for draw in (mesh_a_part, named_svg, stress_at_holes, flow_around_a_profile, two_materials):
        (docs / draw.__name__).mkdir(exist_ok=True)
        draw(results / draw.__name__, docs / draw.__name__)


if __name__ == "__main__":
    main()
