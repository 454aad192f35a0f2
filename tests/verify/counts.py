"""Checks the generalised Poincaré-Hopf theorem (docs/method.md §7): the required sum and the given
one."""
import numpy as np

from topology import HOLE, IMPRINTED


def check_counts(data, mesh, boundary, indices, given, report):
    """Checks the counts. `given` is the sum of quarter indices inside, or None if the file does not
    have it.

    Returns the required sum and the boundary vertices whose index must have been prescribed.
    """
    report.equal("EulerCharacteristic", data.value("EulerCharacteristic"), mesh.euler_characteristic())
    required = data.value("RequiredInteriorQuarters")
    stated = data.value("Valence"), data.value("TangentTurning")
    # Vertices that meshing adds to a side are off it by rounding to 2^-46 of the extent (docs/method.md
    # §10.7), which turns the edges at its ends; along the side the turns cancel.
    shortest = np.linalg.norm(mesh.points[mesh.lines[:, 1]] - mesh.points[mesh.lines[:, 0]], axis=1).min()
    rounding = len(boundary.angle) * 2.0 ** -50 + 2.0 ** -46 * mesh.frame.size / shortest

    def count(fixed, quarters):
        rotation = boundary.angle[fixed] - 0.5 * np.pi * quarters[fixed]
        return rotation.sum() / (2.0 * np.pi), boundary.angle[~fixed].sum() / (2.0 * np.pi)

    chosen, quarters = recorded(data, mesh, boundary)
    found = count(boundary.corner | chosen, quarters)
    if abs(found[0] - stated[0]) > rounding or abs(found[1] - stated[1]) > rounding:
        # Indices were prescribed: the field shows which, wherever it is constrained to them.
        taken = taken_indices(mesh, boundary, indices)
        chosen = taken != np.where(boundary.corner, boundary.smallest, 0)
        found = count(boundary.corner | chosen, taken)
    agree = [abs(a - b) <= rounding for a, b in zip(found, stated)]
    if all(agree) or not chosen.any():
        report.bound("Valence", abs(found[0] - stated[0]), rounding, "rounding of a sum of angles")
        report.bound("TangentTurning", abs(found[1] - stated[1]), rounding, "rounding of a sum of angles")
    else:
        report.note("Valence is not that of the indices that the field takes at corners; chosen "
                    "indices, which the file does not list, may explain it")
        total = boundary.angle.sum() / (2.0 * np.pi) - sum(stated)
        report.bound("Valence and TangentTurning lack whole quarters only",
                     abs(4.0 * total - np.rint(4.0 * total)), rounding, "rounding of a sum of angles")
    report.equal("RequiredInteriorQuarters", required, int(np.rint(4.0 * sum(stated))))
    if given is not None:
        report.equal("GivenInteriorQuarters", data.value("GivenInteriorQuarters"), given)
    report.equal("Consistent", data.value("Consistent"),
                 int(required == data.value("GivenInteriorQuarters")))
    return chosen


def recorded(data, mesh, boundary):
    """Returns the boundary vertices that are singularities of the configuration, and the quarter
    indices of all boundary vertices with these; the file states their positions. The field may
    differ from them where its norm is free."""
    chosen = np.zeros(len(boundary.angle), bool)
    quarters = np.where(boundary.corner, boundary.smallest, 0)
    for x, y, z, quarter in data.field.get("BoundarySingularities", np.zeros((0, 4))):
        distance = np.linalg.norm(data.points[boundary.vertex] - [x, y, z], axis=1)
        if distance.min() <= mesh.frame.exactness * mesh.frame.size:
            chosen[distance.argmin()] = True
            quarters[distance.argmin()] = quarter
    return chosen, quarters


def taken_indices(mesh, boundary, indices):
    """Returns the quarter index of the field at every aligned vertex, including the triangles
    there."""
    _, of_vertex = indices.merged_at(mesh, boundary.vertex)
    return of_vertex[boundary.vertex]


def prescribed(mesh):
    return sum(loop.quarter for loop in mesh.of_kind(HOLE, IMPRINTED))
