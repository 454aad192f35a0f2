"""Degrees of holes and indices of triangles and vertices, by winding of arg u (docs/method.md §8).

Triangles of midpoints and polygons of midpoints around the vertices tile the domain, so all indices
and degrees together are 4χ, corners of the boundary included.
"""
import numpy as np

from topology import HOLE, IMPRINTED, INNER, OUTER, cross

CORNER_ANGLE = np.pi / 6.0  # docs/method.md §6: a boundary vertex that turns by more is a corner
ANGLE_ROUNDING = 1e-9  # rounding of an angle that equals the limit


def turns(angle):
    return np.rint(np.asarray(angle) / (2.0 * np.pi)).astype(int)


def winding(u):
    """Returns the turns of u along a closed sequence of values."""
    return int(turns(np.angle(np.roll(u, -1) * u.conj()).sum()))


class BoundaryTurns:
    """Vertices of outer and inner loops with the turning angle of the boundary."""

    def __init__(self, mesh):
        vertices, angles, before, after = [], [], [], []
        for loop in mesh.of_kind(OUTER, INNER):
            tangent = mesh.tangent[loop.lines]
            last = np.roll(tangent, 1, axis=0)
            vertices.append(mesh.lines[loop.lines, 0])
            angles.append(np.arctan2(cross(last, tangent), (last * tangent).sum(axis=1)))
            after.append(loop.lines)
            before.append(np.roll(loop.lines, 1))
        self.vertex, self.angle, self.before, self.after = map(
            np.concatenate, (vertices, angles, before, after))
        self.corner = np.abs(self.angle) > CORNER_ANGLE + ANGLE_ROUNDING
        rotation = self.angle - 0.5 * np.pi * np.rint(self.angle / (0.5 * np.pi))
        rotation[rotation < -0.25 * np.pi + ANGLE_ROUNDING] += 0.5 * np.pi
        #: Quarter index for the smallest rotation of the cross.
        self.smallest = np.rint((self.angle - rotation) / (0.5 * np.pi)).astype(int)


class Indices:
    """Indices of every triangle and vertex; for aligned vertices the quarter index of the field."""

    def __init__(self, mesh, field, boundary):
        self.of_triangle = turns(field.step.sum(axis=1))
        around = np.zeros(len(mesh.points))
        # Sides i and i + 1 meet in point i + 1; around it the same step has the opposite direction.
        np.add.at(around, np.roll(mesh.triangles, -1, axis=1), -field.step)
        around[boundary.vertex] += 4.0 * boundary.angle
        for loop in mesh.of_kind(HOLE):
            u = field.u[mesh.edge_of_line[loop.lines]]
            around[mesh.lines[loop.lines, 0]] += np.angle(u * np.roll(u, 1).conj())
        self.of_vertex = turns(around)

    def merged_at(self, mesh, vertices):
        """Returns the indices with those of triangles at these vertices moved to the vertices; the
        last vertex of a triangle receives it."""
        marked = np.zeros(len(mesh.points), bool)
        marked[vertices] = True
        of_triangle, of_vertex = self.of_triangle.copy(), self.of_vertex.copy()
        for t in np.flatnonzero(of_triangle):
            here = mesh.triangles[t][marked[mesh.triangles[t]]]
            if len(here):
                of_vertex[here[0]] += of_triangle[t]
                of_triangle[t] = 0
        return of_triangle, of_vertex


def check_degrees(data, mesh, field, report):
    """Checks HoleDegree and HoleNormRange of holes and imprinted circles, and returns the
    degrees."""
    loops = sorted(mesh.of_kind(HOLE, IMPRINTED), key=lambda loop: (loop.kind, loop.number))
    values = [field.u[mesh.counter_clockwise(loop)] for loop in loops]
    degrees = [winding(u) for u in values]
    stated = data.field.get("HoleDegree")
    if stated is not None:
        report.equal("degrees of holes and circles", stated.ravel().tolist(), degrees)
        norms = np.array([[np.abs(u).min(), np.abs(u).max()] for u in values]).reshape(-1, 2)
        ranges = data.field["HoleNormRange"].reshape(-1, 2)
        if ranges.shape == norms.shape:
            report.bound("norms on holes and circles", np.abs(ranges - norms).max(initial=0.0),
                         4 * 2.0 ** -52 * max(1.0, norms.max(initial=0.0)), "rounding of a root")
        else:
            report.equal("rows of HoleNormRange", len(ranges), len(norms))
    return loops, degrees


def check_sum(data, mesh, indices, loops, degrees, report):
    found = int(indices.of_triangle.sum() + indices.of_vertex.sum() +
                sum(degree for loop, degree in zip(loops, degrees) if loop.kind == HOLE))
    report.equal("sum of all indices, corners included: 4 times the Euler characteristic",
                 4 * mesh.euler_characteristic(), found)
