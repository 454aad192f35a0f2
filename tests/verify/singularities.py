"""Singularities of a field. Singular triangles and vertices that touch count as one."""
import numpy as np

from topology import IMPRINTED


class Singularity:
    def __init__(self, quarter, position, inside):
        self.quarter, self.position, self.inside = quarter, position, inside


def _root(parent, v):
    while parent.setdefault(v, v) != v:
        v = parent[v]
    return v


def _zero(mesh, field, t, sign):
    """Returns the zero of the linear function on a triangle, if it has one with the winding
    `sign`."""
    w = field.in_triangle[t]
    corner = w.sum() - 2.0 * np.roll(w, -1)
    matrix = np.array([(corner[1:] - corner[0]).real, (corner[1:] - corner[0]).imag])
    determinant = np.linalg.det(matrix)
    if not determinant * sign > 0.0:
        return None
    inner = np.linalg.solve(matrix, [-corner[0].real, -corner[0].imag])
    barycentric = np.array([1.0 - inner.sum(), *inner])
    return barycentric @ mesh.points[mesh.triangles[t]] if barycentric.min() >= 0.0 else None


def find(mesh, field, indices, boundary):
    """Returns all singularities except those at corners of outer and inner loops and in holes."""
    corners = boundary.vertex[boundary.corner]
    of_triangle, of_vertex = indices.merged_at(mesh, corners)
    of_vertex[corners] = 0
    singular = of_vertex != 0
    parent = {}
    for t in np.flatnonzero(of_triangle):
        a, b, c = (_root(parent, v) for v in mesh.triangles[t].tolist())
        parent[a] = parent[b] = c
        parent[_root(parent, b)] = _root(parent, c)
    for a, b in mesh.ends[singular[mesh.ends].all(axis=1)].tolist():
        parent[_root(parent, a)] = _root(parent, b)
    on_loop = np.zeros(len(mesh.points), bool)
    on_loop[boundary.vertex] = True

    clusters = {}
    for t in np.flatnonzero(of_triangle):
        centre = mesh.points[mesh.triangles[t]].mean(axis=0)
        clusters.setdefault(_root(parent, int(mesh.triangles[t, 0])), []).append(
            (of_triangle[t], centre, True))
    for v in np.flatnonzero(singular):
        clusters.setdefault(_root(parent, int(v)), []).append(
            (of_vertex[v], mesh.points[v], not on_loop[v]))
    near = {root: [] for root in clusters}
    for t in np.flatnonzero((of_triangle != 0) | singular[mesh.triangles].any(axis=1)):
        corner = mesh.triangles[t]
        start = corner[0] if of_triangle[t] else corner[singular[corner]][0]
        near[_root(parent, int(start))].append(t)

    found = []
    for root, parts in clusters.items():
        quarter = int(sum(part[0] for part in parts))
        weights = np.array([abs(part[0]) for part in parts], float)
        position = weights @ np.array([part[1] for part in parts]) / weights.sum()
        inside = any(part[2] for part in parts)
        if inside and abs(quarter) == 1:
            zeros = [z for t in near[root] if (z := _zero(mesh, field, t, quarter)) is not None]
            position = min(zeros, key=lambda z: np.linalg.norm(z - position), default=position)
        if quarter:
            found.append(Singularity(quarter, position, inside))
    return found


def give_to_boundary(data, mesh, boundary, found):
    """Assigns singularities in triangles beside a vertex of a boundary singularity to the boundary.
    The file states their positions. A triangle may have a part of an index of 2 or more, and the vertex
    the remainder."""
    for x, y, z, quarter in data.field.get("PointSingularities", np.zeros((0, 4))):
        distance = np.linalg.norm(data.points[boundary.vertex] - [x, y, z], axis=1)
        vertex = boundary.vertex[distance.argmin()]
        if distance.min() > mesh.frame.exactness * mesh.frame.size:
            continue
        touching = (mesh.triangles == vertex).any(axis=1)
        reach = 2.0 * np.linalg.norm(mesh.points[mesh.triangles[touching]] - mesh.points[vertex], axis=2).max()
        for singularity in found:
            if (0 < np.sign(quarter) * singularity.quarter <= abs(quarter) and
                    np.linalg.norm(singularity.position - mesh.points[vertex]) <= reach):
                singularity.inside = False


def beyond_circles(mesh, found):
    """Returns Σ |k| of singularities that the imprinted circles, with an edge around them, did not
    prescribe."""
    appeared = 0
    circles = []
    for loop in mesh.of_kind(IMPRINTED):
        polygon = mesh.polygon(loop)
        centre = mesh.centre(loop)
        length = np.linalg.norm(mesh.tangent[loop.lines], axis=1)
        circles.append([centre, (np.linalg.norm(polygon - centre, axis=1) + length).max(), loop, []])
    for singularity in found:
        for centre, reach, _, inside in circles:
            if np.linalg.norm(singularity.position - centre) <= reach:
                inside.append(singularity.quarter)
                break
        else:
            appeared += abs(singularity.quarter)
    for _, _, loop, inside in circles:
        appeared += sum(map(abs, inside)) - (abs(loop.quarter) if sum(inside) == loop.quarter else 0)
    return appeared


def check_unwanted(data, mesh, indices, boundary, chosen, found, report):
    """Checks UnwantedSingularities of a perforated field."""
    stated = data.value("UnwantedSingularities")
    if mesh.of_kind(IMPRINTED) or data.value("Epsilon") is not None:
        report.equal("UnwantedSingularities", stated, beyond_circles(mesh, found))
        return
    # Corners and prescribed vertices may have any index. Singularities within two edges of a
    # prescribed vertex belong to it; the file does not state which corners were prescribed.
    most = sum(abs(singularity.quarter) for singularity in found)
    free = mesh.points[boundary.vertex[boundary.corner | chosen]]
    reach = 2.0 * np.linalg.norm(mesh.tangent, axis=1).max()
    near = [singularity for singularity in found if len(free) and
            np.linalg.norm(free - singularity.position, axis=1).min() <= reach]
    least = most - sum(abs(singularity.quarter) for singularity in near)
    if least == most:
        report.equal("UnwantedSingularities", stated, least)
    else:
        report.true("UnwantedSingularities", least <= stated <= most,
                    "the file states %s, it has %d to %d" % (stated, least, most))


def check_reached(data, mesh, loops, degrees, by_sum, report):
    stated = data.value("DegreesReached")
    if stated is None:
        return
    reached = [degree == loop.quarter for loop, degree in zip(loops, degrees)]
    wanted = sum(loop.quarter for loop in loops)
    report.equal("DegreesReached", stated, int(sum(degrees) == wanted if by_sum else all(reached)))
