"""Draws the pictures of docs/glossary.md as SVG files, from results of the Python package.

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 scripts/pictures/glossary.py docs/glossary
"""
import math
import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_TRIANGLE

import crossfield

RED, BLUE, GREY, BLACK, ORANGE = "#c0392b", "#2166ac", "#b0b0b0", "#222222", "#e08214"
PALE = ["#f9dcd0", "#d1e5f7", "#d9f0d3", "#f6efc5", "#e6d9f0", "#fde0ef"]
DISK = "builtin:disk"
RING = "builtin:ring"
PLATE = pathlib.Path(__file__).resolve().parents[2] / "tests" / "data" / "parts" / "plate3.vtp"
SIDE = 200  # width and height of a panel


class Panel:
    """A square part of a picture, with the y axis upwards."""

    def __init__(self, low, high, column):
        self.low = np.asarray(low, float)[:2]
        extent = np.asarray(high, float)[:2] - self.low
        self.scale = (SIDE - 24) / extent.max()
        self.shift = np.array([column * SIDE, 0]) + (SIDE - self.scale * extent) / 2
        self.items = []

    def place(self, point):
        x, y = self.shift + self.scale * (np.asarray(point, float)[:2] - self.low)
        return "%.1f,%.1f" % (x, SIDE - y)

    def polyline(self, points, colour=BLACK, width=1.0, fill="none", closed=False, dash=""):
        tag = "polygon" if closed else "polyline"
        self.items.append(
            '<%s points="%s" fill="%s" stroke="%s" stroke-width="%s"%s stroke-linejoin="round"/>'
            % (tag, " ".join(self.place(p) for p in points), fill, colour, width,
               ' stroke-dasharray="%s"' % dash if dash else ""))

    def dot(self, point, colour, radius=4.0):
        x, y = self.place(point).split(",")
        self.items.append('<circle cx="%s" cy="%s" r="%s" fill="%s"/>' % (x, y, radius, colour))

    def circle(self, centre, radius, colour, dash=""):
        turns = np.linspace(0, 2 * math.pi, 49)[:-1]
        self.polyline([(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in turns],
                      colour, 1.5, closed=True, dash=dash)

    def text(self, point, words, colour=BLACK, size=12):
        x, y = self.place(point).split(",")
        self.items.append('<text x="%s" y="%s" font-size="%d" fill="%s" text-anchor="middle" '
                          'dominant-baseline="middle">%s</text>' % (x, y, size, colour, words))

    def caption(self, words):
        column = int(self.shift[0] // SIDE)
        self.items.append('<text x="%d" y="%d" font-size="12" fill="%s" text-anchor="middle">%s</text>'
                          % (column * SIDE + SIDE // 2, SIDE + 12, BLACK, words))

    def quads(self, mesh, colours=None, edge=GREY):
        for i, quad in enumerate(mesh.quads):
            self.polyline(mesh.points[quad], edge, 0.5, closed=True,
                          fill="none" if colours is None else colours[i])

    def irregular_nodes(self, mesh):
        for i, valence in nodes_of(mesh):
            self.dot(mesh.points[i], RED if valence < 4 else BLUE, 3.5)


def nodes_of(mesh):
    """Returns (index, valence) of the irregular nodes inside."""
    inner = np.ones(len(mesh.points), bool)
    inner[np.unique(boundary_edges(mesh))] = False
    count = np.bincount(mesh.quads.ravel(), minlength=len(mesh.points))
    return [(i, count[i]) for i in np.flatnonzero(inner & (count != 4))]


def boundary_edges(mesh):
    """Returns the edges that belong to only one quad."""
    sides = np.concatenate([mesh.quads[:, [i, (i + 1) % 4]] for i in range(4)])
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    return sides[first[count == 1]]


def outline(panel, mesh, width=1.5):
    for edge in boundary_edges(mesh):
        panel.polyline(mesh.points[edge], BLACK, width)


def panels(count, low=(-1, -1), high=(1, 1)):
    return [Panel(low, high, i) for i in range(count)]


def write(folder, name, drawn, captions=False):
    height = SIDE + (20 if captions else 0)
    text = ['<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" font-family="sans-serif">'
            % (SIDE * len(drawn), height), '<rect width="100%" height="100%" fill="white"/>']
    for panel in drawn:
        text += panel.items
    (folder / (name + ".svg")).write_text("\n".join(text + ["</svg>", ""]), encoding="utf-8")


def four(radius):
    return [(radius * math.cos(t), radius * math.sin(t), 1) for t in np.radians([45, 135, 225, 315])]


def regular_polygon(sides):
    turns = np.radians(90 + 360 / sides * np.arange(sides))
    return np.column_stack([np.cos(turns), np.sin(turns)])


def cross_field(folder):
    field = crossfield.hfield(DISK, four(0.6), size=0.06)
    [panel] = panels(1)
    chosen = {}
    for i, centre in enumerate(field.points[field.triangles].mean(axis=1)):
        key = tuple(np.floor(centre[:2] / 0.16).astype(int))
        middle = (np.array(key) + 0.5) * 0.16
        distance = np.linalg.norm(centre[:2] - middle)
        if key not in chosen or distance < chosen[key][0]:
            chosen[key] = (distance, i, centre)
    for _, i, centre in chosen.values():
        if np.linalg.norm(centre[:2]) < 0.96:
            arm = 0.065 * field.cross[i][:2]
            for step in arm, np.array([-arm[1], arm[0]]):
                panel.polyline([centre[:2] - step, centre[:2] + step], BLACK, 1)
    panel.circle((0, 0), 1, BLACK)
    for x, y, _ in four(0.6):
        panel.dot((x, y), RED)
    write(folder, "cross_field", [panel])


def irregular_node(folder):
    drawn = panels(3)
    for panel, sides, index in zip(drawn, (3, 4, 5), (1, 0, -1)):
        mesh = crossfield.quads(regular_polygon(sides), [(0, 0, index)] if index else [], size=0.17)
        panel.quads(mesh, edge=BLACK)
        panel.irregular_nodes(mesh)
        panel.caption("valence %d, k = %s" % (sides, str(index).replace("-", "−")))
    write(folder, "irregular_node", drawn, captions=True)


def clearance(folder):
    [panel] = panels(1, (0, 0), (2, 2))
    mesh = crossfield.quads([(0, 0), (2, 0), (2, 2), (0, 2)], [(1.4, 1, 1), (0.6, 1, -1)], size=0.2)
    panel.quads(mesh)
    outline(panel, mesh)
    for (x, y), colour in zip([(1.4, 1), (0.6, 1)], (RED, BLUE)):
        panel.dot((x, y), colour)
        panel.circle((x, y), 0.7 * 0.2, colour, "3,2")
    write(folder, "clearance", [panel])


def loops(folder):
    grid = crossfield.read(str(PLATE))
    low, high = np.array(grid.GetBounds())[[0, 2]], np.array(grid.GetBounds())[[1, 3]]
    mesh = crossfield.quads(str(PLATE), count=300)
    [panel] = panels(1, low, high)
    pieces = chains(boundary_edges(mesh))
    outer = max(pieces, key=lambda loop: np.ptp(mesh.points[loop][:, 0]))
    for loop in pieces:
        panel.polyline(mesh.points[loop], BLUE if loop is outer else ORANGE, 2.5, closed=True)
    for i, _ in nodes_of(mesh):
        panel.circle(mesh.points[i], 0.012 * np.ptp([low, high]), RED)
    write(folder, "loops", [panel])


def chains(edges):
    """Returns the closed chains of directed edges."""
    follows = dict(edges.tolist())
    found = []
    while follows:
        start, point = follows.popitem()
        chain = [start]
        while point != start:
            chain.append(point)
            point = follows.pop(point)
        found.append(chain)
    return found


def corner(folder):
    drawn = panels(3)
    for panel, angle, count in zip(drawn, (90, 180, 270), (1, 2, 3)):
        turns = np.radians(np.linspace(0, angle, count + 1)) + (0 if count < 3 else math.pi / 2)
        if count == 2:
            turns = np.radians([0, 90, 180])
        for first, second in zip(turns[:-1], turns[1:]):
            a, b = (0.9 * np.array([math.cos(t), math.sin(t)]) for t in (first, second))
            panel.polyline([(0, 0), a, a + b, b], GREY, 1, PALE[1], closed=True)
        for turn in (turns[0], turns[-1]):
            panel.polyline([(0, 0), (0.9 * math.cos(turn), 0.9 * math.sin(turn))], BLACK, 2.5)
        panel.dot((0, 0), BLACK)
        panel.caption("%d°: k = %s" % (angle, {1: "1", 2: "0", 3: "−1"}[count]))
    write(folder, "corner", drawn, captions=True)


def sums(folder):
    drawn = panels(3)
    for panel, domain, total in zip(drawn, (DISK, RING, "builtin:square"), (4, 0, 0)):
        mesh = crossfield.quads(domain, count=100)
        panel.low, extent = mesh.points.min(axis=0)[:2], np.ptp(mesh.points[:, :2], axis=0)
        panel.scale = (SIDE - 24) / extent.max()
        panel.shift = np.array([drawn.index(panel) * SIDE, 0]) + (SIDE - panel.scale * extent) / 2
        panel.quads(mesh)
        outline(panel, mesh)
        panel.irregular_nodes(mesh)
        report = crossfield.check(domain, []).report
        assert report["required_interior_quarters"] == total, report
        panel.caption("needs a total of %d" % total)
    write(folder, "sum", drawn, captions=True)


def holonomy_defect(folder):
    drawn = panels(2)
    for panel, start in zip(drawn, (0.0, 0.12)):
        for radius in (0.3, 1.0):
            panel.circle((0, 0), radius, BLACK)
        turns = np.linspace(0, 2 * math.pi, 121)
        panel.polyline([((0.6 + start * t / 4) * math.cos(t), (0.6 + start * t / 4) * math.sin(t)) for t in turns],
                       BLUE, 2)
        panel.dot((0.6, 0), BLUE)
        panel.caption("closes up" if start == 0 else "holonomy defect")
    write(folder, "holonomy_defect", drawn, captions=True)


def sizes(folder):
    drawn = panels(2)
    for panel, sizing in zip(drawn, ("conformal", "uniform")):
        mesh = crossfield.quads(DISK, four(0.55), count=300, sizing=sizing)
        panel.quads(mesh, edge=BLACK)
        panel.irregular_nodes(mesh)
        panel.caption(sizing + " sizes")
    write(folder, "sizes", drawn, captions=True)


def energy(folder):
    radii = (0.35, 0.6, 0.85)
    drawn = panels(3)
    for panel, radius in zip(drawn, radii):
        [row] = crossfield.energy(DISK, four(radius))
        panel.circle((0, 0), 1, BLACK)
        for x, y, _ in four(radius):
            panel.dot((x, y), RED)
        panel.caption("W = " + ("%.1f" % row["renormalized_energy"]).replace("-", "−"))
    write(folder, "energy", drawn, captions=True)


def seamless_map(folder):
    made = crossfield.separatrices(DISK, four(0.6))
    drawn = panels(2)
    points = vtk_to_numpy(made.map.GetPoints().GetData())
    uv = vtk_to_numpy(made.map.GetPointData().GetArray(crossfield.names.UV))[:, :2]
    triangles = np.array([[made.map.GetCell(i).GetPointId(j) for j in range(3)]
                          for i in range(made.map.GetNumberOfCells())
                          if made.map.GetCellType(i) == VTK_TRIANGLE])
    drawn[1] = Panel(uv.min(axis=0), uv.max(axis=0), 1)
    for panel, where in zip(drawn, (points, uv)):
        mesh_edges = np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
        edges, count = np.unique(mesh_edges, axis=0, return_counts=True)
        for edge in edges[count == 1]:
            on_circle = np.all(np.linalg.norm(points[edge][:, :2], axis=1) > 0.999)
            panel.polyline(where[edge], BLACK if on_circle else ORANGE, 1.5)
    drawn[0].caption("domain with seams")
    drawn[1].caption("its map (u, v)")
    write(folder, "map", drawn, captions=True)


def layout(folder):
    mesh = crossfield.quads(DISK, four(0.6), count=150)
    drawn = panels(3)
    separatrices = crossfield.separatrices(DISK, four(0.6))
    for line in separatrices.lines:
        drawn[0].polyline(line, BLUE, 2)
    outline(drawn[0], mesh)
    drawn[1].quads(mesh, [PALE[i % len(PALE)] for i in mesh.block])
    outline(drawn[1], mesh)
    drawn[2].quads(mesh, [PALE[3] if on else "none" for on in chord_of(mesh, len(mesh.quads) // 2)])
    outline(drawn[2], mesh)
    for panel, words in zip(drawn, ("separatrices", "blocks", "a chord")):
        panel.irregular_nodes(mesh)
        panel.caption(words)
    write(folder, "layout", drawn, captions=True)


def chord_of(mesh, first):
    """Returns, for each quad, whether it is in the chord through the first and third side of a
    given quad."""
    neighbours = {}
    for i, quad in enumerate(mesh.quads):
        for side in range(4):
            neighbours.setdefault(frozenset((quad[side], quad[(side + 1) % 4])), []).append((i, side))
    on = np.zeros(len(mesh.quads), bool)
    for side in (0, 2):
        quad, leaving = first, side
        while True:
            on[quad] = True
            edge = frozenset((mesh.quads[quad][leaving], mesh.quads[quad][(leaving + 1) % 4]))
            beyond = [entry for entry in neighbours[edge] if entry[0] != quad]
            if not beyond or on[beyond[0][0]]:
                break
            quad, leaving = beyond[0][0], (beyond[0][1] + 2) % 4
    return on


def quantisation(folder):
    [panel] = panels(1, (-0.15, -0.15), (2.35, 2.35))
    for low, high, across, up in (((0, 0), (2.2, 1.2), 6, 3), ((0, 1.2), (1.3, 2.2), 4, 3), ((1.3, 1.2), (2.2, 2.2), 2, 3)):
        (x, y), (a, b) = low, high
        for i in range(across + 1):
            s = x + (a - x) * i / across
            panel.polyline([(s, y), (s, b)], GREY, 0.7)
        for j in range(up + 1):
            s = y + (b - y) * j / up
            panel.polyline([(x, s), (a, s)], GREY, 0.7)
        panel.polyline([(x, y), (a, y), (a, b), (x, b)], BLUE, 2, closed=True)
    for point, words in (((1.1, -0.07), "6"), ((0.65, 2.27), "4"), ((1.75, 2.27), "2"), ((-0.07, 0.6), "3"), ((-0.07, 1.7), "3")):
        panel.text(point, words, BLACK, 13)
    write(folder, "quantisation", [panel])


def scaled_jacobian(folder):
    shapes = [[(-.7, -.7), (.7, -.7), (.7, .7), (-.7, .7)], [(-.9, -.5), (.4, -.5), (.9, .5), (-.4, .5)],
              [(-.8, -.8), (.8, -.8), (-.5, .1), (-.8, .8)]]
    drawn = panels(3)
    for panel, shape in zip(drawn, shapes):
        corners = np.array(shape)
        sines = []
        for i in range(4):
            a, b = corners[(i + 1) % 4] - corners[i], corners[i - 1] - corners[i]
            sines.append((a[0] * b[1] - a[1] * b[0]) / np.linalg.norm(a) / np.linalg.norm(b))
        panel.polyline(shape, BLACK, 1.5, PALE[0] if min(sines) < 0 else PALE[1], closed=True)
        panel.caption(("%.2f" % min(sines)).replace("-", "−"))
    write(folder, "scaled_jacobian", drawn, captions=True)


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    target.mkdir(parents=True, exist_ok=True)
    for draw in (cross_field, irregular_node, clearance, loops, corner, sums, holonomy_defect, sizes, energy,
                 seamless_map, layout, quantisation, scaled_jacobian):
        draw(target)
