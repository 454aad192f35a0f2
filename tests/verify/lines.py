"""Checks separatrices and patches with the map that they were traced in: NAME.lines.vtp,
NAME.faces.vtp and NAME.vtu.

The segments of a separatrix are located in the triangles of the map. They must be parallel to one
axis and continue across sides of triangles as the seams rotate them. The sides of a patch must form
a rectangle.
"""
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from reading import arrays_of


class Poly:
    """Points, cells as lists of points, and arrays of a .vtp file."""

    def __init__(self, name):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(name))
        reader.Update()
        data = reader.GetOutput()
        self.points = np.zeros((0, 2))
        if data.GetNumberOfPoints() > 0:
            self.points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)[:, :2]
        cells = data.GetPolys() if data.GetNumberOfPolys() else data.GetLines()
        ends = vtk_to_numpy(cells.GetOffsetsArray()).astype(int)
        ids = vtk_to_numpy(cells.GetConnectivityArray()).astype(int)
        self.cells = [ids[a:b] for a, b in zip(ends[:-1], ends[1:])]
        self.on_cells = arrays_of(data.GetCellData())
        self.at_points = arrays_of(data.GetPointData())
        self.field = arrays_of(data.GetFieldData())


class Charts:
    """Location of points of the plane in the triangles of a map."""

    def __init__(self, data):
        self.triangles = data.triangles
        self.places = data.points[data.triangles][:, :, 0:2]
        uv = data.at_points["UV"]
        self.w = (uv[:, 0] + 1j * uv[:, 1])[data.triangles]
        a, b, c = np.moveaxis(self.places, 1, 0)
        self.inverse = np.linalg.inv(np.stack([b - a, c - a], axis=2))
        low, high = self.places.min(axis=1), self.places.max(axis=1)
        self.origin = low.min(axis=0)
        self.extent = (high.max(axis=0) - self.origin).max()
        # Grid with about as many cells as triangles; each cell lists the triangles that may touch
        # it.
        self.count = max(1, int(np.sqrt(len(self.triangles))))
        self.grid = {}
        first, last = self._cell(low), self._cell(high)
        for t in range(len(self.triangles)):
            for i in range(first[t, 0], last[t, 0] + 1):
                for j in range(first[t, 1], last[t, 1] + 1):
                    self.grid.setdefault((i, j), []).append(t)
        self.rotation = 1j ** np.atleast_1d(data.field.get("SeamRotation", np.zeros(0)))
        vertex = data.at_points["VertexId"][data.triangles]
        seam = data.cells["Seam"][0]
        self.side = {}
        for t, corners in enumerate(vertex):
            for i in range(3):
                self.side[corners[i], corners[(i + 1) % 3]] = (t, seam[t, i])
        self.vertex = vertex

    def _cell(self, place):
        return np.clip(((place - self.origin) / self.extent * self.count).astype(int), 0,
                       self.count - 1)

    def find(self, place):
        """Returns the triangle that contains a point best, and the distance outside of it in
        heights of the triangle."""
        among = self.grid.get(tuple(self._cell(place)), [])
        if not among:
            return -1, np.inf
        inner = np.einsum("tij,tj->ti", self.inverse[among], place - self.places[among, 0])
        depth = np.minimum(inner.min(axis=1), 1.0 - inner.sum(axis=1))
        best = int(depth.argmax())
        return among[best], -depth[best]

    def at(self, t, place):
        b, c = self.inverse[t] @ (place - self.places[t, 0])
        return self.w[t, 0] + b * (self.w[t, 1] - self.w[t, 0]) + c * (self.w[t, 2] - self.w[t, 0])

    def turn(self, t, other):
        """Returns the factor of a direction from one triangle to a neighbour, or None if they share
        no side."""
        if t == other:
            return 1.0
        for i in range(3):
            a, b = self.vertex[t, i], self.vertex[t, (i + 1) % 3]
            found = self.side.get((b, a))
            if found is not None and found[0] == other:
                code = self.side[a, b][1]
                return (1.0 if code == 0 else self.rotation[code - 1] if code > 0 else
                        1.0 / self.rotation[-code - 1])
        return None


def check_beside(name, data, report):
    """Checks the separatrices and patches of a map, if the files exist."""
    stem = str(pathlib.Path(name).with_suffix(""))
    if not pathlib.Path(stem + ".lines.vtp").exists() or np.ptp(data.points[:, 2]) != 0.0:
        return
    report.kind = "seamless map with lines and faces"
    charts = Charts(data)
    lines, faces = Poly(stem + ".lines.vtp"), Poly(stem + ".faces.vtp")
    check_lines(charts, lines, report)
    check_cones(data, charts, lines, report)
    ends = data.points[data.lines]
    check_faces(charts, faces, np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum(), report)


def _segments(charts, places):
    """Returns the triangle and the step in the map of each segment; segments too short to be
    located are left out."""
    for a, b in zip(places[:-1], places[1:]):
        if np.abs(b - a).max() > 1e-9 * charts.extent:
            t, outside = charts.find(0.5 * (a + b))
            yield t, outside, charts.at(t, b) - charts.at(t, a) if t >= 0 else 0.0


def check_lines(charts, lines, report):
    bent, outside, length, ahead = 0.0, 0.0, 0.0, True
    for cell, claimed in zip(lines.cells, lines.on_cells["Length"]):
        total, last, direction = 0.0, -1, 0.0
        for t, out, step in _segments(charts, lines.points[cell]):
            outside = max(outside, out)
            bent = max(bent, min(abs(step.real), abs(step.imag)))
            here = step / abs(step)
            here = complex(round(here.real), round(here.imag))
            turn = charts.turn(last, t) if last >= 0 else None
            ahead = ahead and (turn is None or abs(direction * turn - here) < 0.5)
            last, direction = t, here
            total += abs(step)
        length = max(length, abs(total - claimed))
    tolerance = 1e-8 * charts.extent  # for points with rounded coordinates
    report.bound("lines are inside the domain", outside, 1e-6, "of the heights of triangles")
    report.bound("lines are along an axis in every triangle", bent, tolerance, "rounded points")
    report.true("lines go straight on across the sides of triangles", ahead)
    report.bound("Length of lines", length, tolerance * 100, "of all segments")


def check_cones(data, charts, lines, report):
    """Checks the number of separatrices that leave every singularity, and that they do so at right
    angles."""
    quarters = {}
    on_line = set(data.at_points["VertexId"][data.lines].ravel())
    for vertex, k, place in zip(data.at_points["VertexId"], data.at_points["QuarterIndex"],
                                data.points):
        if k != 0 and vertex not in on_line:
            quarters[vertex] = (k, place[:2])
    starts = {}
    for cell, row in zip(lines.cells, lines.on_cells["Singularity"]):
        if row >= 0:
            starts.setdefault(tuple(lines.points[cell[0]]), []).append(lines.points[cell])
    right, uneven = True, 0.0
    for vertex, (k, place) in quarters.items():
        leaving = starts.get(tuple(place), [])
        right = right and len(leaving) == 4 - k
        if len(leaving) != 4 - k:
            continue
        # Around the vertex, triangle by triangle: the angle of each separatrix in the map.
        fan = {}
        t, base = int(np.flatnonzero((charts.vertex == vertex).any(axis=1))[0]), 0.0
        while t not in fan:
            i = int(np.flatnonzero(charts.vertex[t] == vertex)[0])
            w = charts.w[t]
            fan[t] = (base, w[(i + 1) % 3] - w[i], w[i])
            base += np.angle((w[(i + 2) % 3] - w[i]) / (w[(i + 1) % 3] - w[i]))
            t = charts.side[vertex, charts.vertex[t, (i + 2) % 3]][0]
        angles = []
        for places in leaving:
            t, _ = charts.find(0.5 * (places[0] + places[1]))
            if t in fan:
                base, spoke, w = fan[t]
                angles.append(base + np.angle((charts.at(t, places[1]) - w) / spoke))
        steps = np.diff(np.sort(angles)) if len(angles) == 4 - k else np.array([np.inf])
        uneven = max(uneven, np.abs(steps - np.pi / 2).max(initial=0.0))
    report.true("4 - k lines leave every singularity", right)
    report.bound("lines leave singularities at right angles of the map", uneven, 1e-6,
                 "rounded points over the edges there")


def check_faces(charts, faces, boundary, report):
    face, uv = faces.at_points["FaceId"], faces.at_points["UV"]
    count = int(face.max()) + 1
    of_cell = faces.on_cells["FaceId"].astype(int)
    report.equal("Faces", int(faces.field["Faces"][0]), count)
    triangles = np.array(faces.cells)
    report.true("triangles of a face use its points",
                bool((face[triangles] == of_cell[:, None]).all()))
    a, b, c = np.moveaxis(faces.points[triangles], 1, 0)
    area = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    report.true("no triangle of a face is turned over", bool((area > 0).all()))
    filled = np.bincount(of_cell, area, count)
    size = np.zeros((count, 2))
    size[of_cell, 0], size[of_cell, 1] = faces.on_cells["USize"], faces.on_cells["VSize"]
    outline, rectangle, sides, off, edges = np.zeros(count), True, 0.0, 0.0, {}
    for f in range(count):
        points, w = faces.points[face == f], uv[face == f]
        x, y = points.T
        outline[f] = 0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum()
        # Once around the outline of the rectangle.
        far = np.minimum(np.abs(w), np.abs(w - size[f])).min(axis=1).max()
        around = (w[:, 0] * np.roll(w[:, 1], -1) - w[:, 1] * np.roll(w[:, 0], -1)).sum() / 2
        rectangle = rectangle and far <= 1e-12 * charts.extent and \
            abs(around - size[f].prod()) <= 1e-12 * charts.extent ** 2
        step = np.roll(w, -1, axis=0) - w
        for i, (p, q) in enumerate(zip(points, np.roll(points, -1, axis=0))):
            if np.abs(q - p).max() <= 1e-9 * charts.extent:
                continue
            edges[f, tuple(p), tuple(q)] = 1
            t, _ = charts.find(0.5 * (p + q))
            in_map = charts.at(t, q) - charts.at(t, p)
            sides = max(sides, abs(abs(in_map) - np.abs(step[i]).max()))
            off = max(off, min(abs(in_map.real), abs(in_map.imag)))
    report.bound("triangles fill their faces", np.abs(filled - outline).max() / charts.extent ** 2,
                 1e-12, "rounding")
    report.true("UV of a face runs once around its rectangle", bool(rectangle))
    report.bound("sides of faces are along an axis of the map", off, 1e-8 * charts.extent,
                 "rounded points")
    report.bound("UV of a face has the lengths of the map", sides, 1e-8 * charts.extent,
                 "rounded points")
    whole = 0.5 * sum(np.linalg.det(charts.places[:, 1:] - charts.places[:, :1]))
    report.bound("faces fill the domain", abs(filled.sum() - whole) / whole, 1e-9, "rounded points")
    report.bound("rectangles have the area of the domain", abs(size.prod(axis=1).sum() - whole) / whole,
                 1e-9, "rounded lengths")
    # Every inner edge is in two patches, or twice in one, with opposite directions.
    ways = {(p, q) for _, p, q in edges}
    alone = sum(np.hypot(*np.subtract(q, p)) for p, q in ways if (q, p) not in ways)
    report.bound("edges of one face only make up the boundary", abs(alone - boundary) / boundary, 1e-8,
                 "rounded points")
