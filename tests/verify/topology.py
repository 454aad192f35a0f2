"""Computes edges, loops and the Euler characteristic of a drilled mesh from its triangles and lines
only."""
import numpy as np

from plane import Frame
from report import ROUNDING, Unverifiable

OUTER, INNER, HOLE, IMPRINTED = 1, 2, 3, 4


def cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


class Loop:
    """Lines of one kind and number, ordered along their directions."""

    def __init__(self, kind, number, lines, quarter):
        self.kind, self.number, self.lines, self.quarter = kind, number, lines, quarter


class Mesh:
    """Triangles with their sides: side i of a triangle joins its points i and i + 1."""

    def __init__(self, data):
        if len(data.triangles) == 0:
            raise Unverifiable("there are no triangles")
        self.frame = Frame(data.points)
        self.points = self.frame.coordinates
        self.triangles = data.triangles
        self.lines = data.lines
        self.kind, self.number, self.quarter = (
            data.cells[name][1].astype(int) for name in ("BoundaryKind", "BoundaryId", "QuarterIndex"))
        corners = self.points[self.triangles]
        self.side = np.roll(corners, -1, axis=1) - corners
        self.area = 0.5 * cross(self.side[:, 0], self.side[:, 1])

        start, end = self.triangles, np.roll(self.triangles, -1, axis=1)
        count = len(self.points)
        key = np.minimum(start, end) * count + np.maximum(start, end)
        keys, self.edge = np.unique(key.ravel(), return_inverse=True)
        self.edge = self.edge.reshape(key.shape)
        self.ends = np.stack([keys // count, keys % count], axis=1)
        self.sides_of_edge = np.bincount(self.edge.ravel(), minlength=len(keys))
        # +1 if a side runs from the first to the second end of its edge, otherwise -1.
        sign = np.where(start < end, 1, -1)
        self.direction = np.bincount(self.edge.ravel(), sign.ravel(), len(keys)).astype(int)

        a, b = self.lines[:, 0], self.lines[:, 1]
        key = np.minimum(a, b) * count + np.maximum(a, b)
        position = np.minimum(np.searchsorted(keys, key), len(keys) - 1)
        if len(key) and np.any(keys[position] != key):
            raise Unverifiable("a line is not the side of any triangle")
        self.edge_of_line = position
        self.line_sign = np.where(a < b, 1, -1)
        self.midpoint = 0.5 * (self.points[self.ends[:, 0]] + self.points[self.ends[:, 1]])
        self.tangent = self.points[b] - self.points[a]
        self.loops = self._find_loops()
        aligned = (self.kind == OUTER) | (self.kind == INNER)
        self.aligned_lines = np.flatnonzero(aligned)
        self.free = np.ones(len(keys), bool)
        self.free[position[aligned]] = False

    def rounding(self):
        """Returns the relative rounding of equations on edges: one rounding per edge, which bounds
        the backward error of a factorisation and of a sum along a path, and the rounding of
        coordinates, which is larger in a tilted plane."""
        shortest = np.linalg.norm(self.side, axis=2).min()
        return len(self.ends) * ROUNDING + 8.0 * self.frame.exactness / shortest

    def _find_loops(self):
        loops = []
        for kind, number in sorted(set(zip(self.kind.tolist(), self.number.tolist()))):
            lines = np.flatnonzero((self.kind == kind) & (self.number == number))
            after = {self.lines[i, 0]: i for i in lines}
            order = [lines[0]]
            while len(order) <= len(lines):
                following = after.get(self.lines[order[-1], 1])
                if following is None:
                    raise Unverifiable("lines of kind %d, number %d are no closed loop" % (kind, number))
                if following == order[0]:
                    break
                order.append(following)
            if len(after) != len(lines) or len(order) != len(lines):
                raise Unverifiable("the lines of kind %d, number %d are not one loop" % (kind, number))
            loops.append(Loop(kind, number, np.array(order), int(self.quarter[order[0]])))
        return loops

    def of_kind(self, *kinds):
        return [loop for loop in self.loops if loop.kind in kinds]

    def polygon(self, loop):
        return self.points[self.lines[loop.lines, 0]]

    def centre(self, loop):
        """Returns the centre of mass of the polygon's sides, which does not depend on their
        subdivision."""
        length = np.linalg.norm(self.tangent[loop.lines], axis=1)
        return length @ self.midpoint[self.edge_of_line[loop.lines]] / length.sum()

    def sides(self, loop):
        """Returns the corners of the polygon, without points inside straight sides."""
        polygon, tangent = self.polygon(loop), self.tangent[loop.lines]
        turn = np.abs(cross(np.roll(tangent, 1, axis=0), tangent)) / np.linalg.norm(tangent, axis=1)
        return polygon[turn > 64 * self.frame.exactness]

    def counter_clockwise(self, loop):
        """Returns the edges of a hole or imprinted circle, counter-clockwise; its lines have the
        opposite direction."""
        return self.edge_of_line[loop.lines[::-1]]

    def euler_characteristic(self):
        """Returns the Euler characteristic of the domain before the holes were drilled."""
        used = len(np.unique(self.triangles))
        return used - len(self.ends) + len(self.triangles) + len(self.of_kind(HOLE))


def check_mesh(data, mesh, report):
    """Checks that the mesh is valid, and its three arrays."""
    report.true("cells are triangles and lines", data.only_triangles_and_lines)
    report.bound("points lie in a plane", mesh.frame.deviation, 1e-6 * mesh.frame.size,
                 "single precision of the points, relative to the size")
    report.true("triangles are counter-clockwise", mesh.area.min() > 0, "area %g" % mesh.area.min())
    report.true("no edge has more than two triangles", mesh.sides_of_edge.max() <= 2)
    report.true("triangles agree in their orientation",
                np.all(mesh.direction[mesh.sides_of_edge == 2] == 0))
    report.true("boundary cells of triangles are unset",
                all(np.all(data.cells[name][0] == value) for name, value in
                    (("BoundaryKind", 0), ("BoundaryId", -1), ("QuarterIndex", 0))))

    boundary = np.isin(mesh.kind, (OUTER, INNER, HOLE))
    edges = np.sort(mesh.edge_of_line[boundary])
    report.true("every boundary edge has one line, and no other has",
                np.array_equal(edges, np.flatnonzero(mesh.sides_of_edge == 1)))
    report.true("lines have the domain on their left",
                np.all(mesh.direction[mesh.edge_of_line[boundary]] == mesh.line_sign[boundary]))
    report.true("imprinted circles lie inside",
                np.all(mesh.sides_of_edge[mesh.edge_of_line[~boundary]] == 2))
    report.true("kinds of lines are 1 to 4", np.all(np.isin(mesh.kind, (1, 2, 3, 4))))
    report.equal("outer loops", 1, len(mesh.of_kind(OUTER)))
    turning = {loop: cross(p := mesh.polygon(loop), np.roll(p, -1, axis=0)).sum() for loop in mesh.loops}
    report.true("the outer loop runs counter-clockwise, all others clockwise",
                all((value > 0) == (loop.kind == OUTER) for loop, value in turning.items()))
    inside = sum(value for loop, value in turning.items() if loop.kind != IMPRINTED)
    report.bound("triangles fill the loops", abs(mesh.area.sum() - 0.5 * inside),
                 len(mesh.area) * mesh.frame.exactness * mesh.frame.size,
                 "rounding of the coordinates, once a triangle")
    report.equal("Euler characteristic of a connected mesh in its loops",
                 2 - len(mesh.of_kind(OUTER, INNER)), mesh.euler_characteristic())
    report.true("one quarter index a loop, 0 on outer and inner ones",
                all(np.all(mesh.quarter[loop.lines] == loop.quarter) for loop in mesh.loops) and
                all(loop.quarter == 0 for loop in mesh.of_kind(OUTER, INNER)))
    report.equal("numbers of outer and inner loops", list(range(1 + len(mesh.of_kind(INNER)))),
                 [loop.number for loop in mesh.of_kind(OUTER, INNER)])
    rows = sorted(loop.number for loop in mesh.of_kind(HOLE, IMPRINTED))
    report.true("rows of singularities are unlike",
                len(set(rows)) == len(rows) and min(rows, default=0) >= 0)
    report.true("loops have enough edges for their quarter index",
                all(len(loop.lines) > 2 * abs(loop.quarter) for loop in mesh.of_kind(HOLE, IMPRINTED)))
    worst = 0.0
    for loop in mesh.of_kind(HOLE, IMPRINTED):
        if len(loop.lines) > 3:  # a marked triangle may have any shape
            polygon = mesh.sides(loop)
            distance = np.linalg.norm(polygon - polygon.mean(axis=0), axis=1)
            length = np.linalg.norm(np.roll(polygon, -1, axis=0) - polygon, axis=1)
            worst = max(worst, np.ptp(distance), np.ptp(length))
    report.bound("holes and circles are regular polygons", worst, 64 * mesh.frame.exactness,
                 "rounding of the coordinates and of their mean")
