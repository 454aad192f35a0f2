"""Cases of meshes and of arrays derived from the field that are corrupted in one place."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from corrupting import of


@of("drilled", "points lie in a plane")
def point_off_the_plane(file):
    file.points[file.inner_vertex(), 2] += 1e-3


@of("drilled", "holes and circles are regular polygons")
def hole_dented(file):
    start = file.mesh.lines[file.mesh.of_kind(3)[0].lines[0], 0]
    file.points[start] *= 1.0 + 1e-9


@of("drilled", "triangles are counter-clockwise", "triangles agree in their orientation",
    "triangles fill the loops")
def triangle_turned(file):
    inside = np.flatnonzero(file.mesh.sides_of_edge[file.mesh.edge].min(axis=1) == 2)[3]
    file.corners[3 * inside:3 * inside + 2] = file.corners[3 * inside:3 * inside + 2][::-1].copy()


@of("drilled", "boundary cells of triangles are unset")
def triangle_called_boundary(file):
    file.cell("BoundaryKind")[5] = 1


@of("drilled", "one quarter index a loop, 0 on outer and inner ones")
def line_of_another_index(file):
    file.cell("QuarterIndex")[file.lines[(file.mesh.kind == 3)][1]] = 3


@of("drilled", "outer loops", "the outer loop runs counter-clockwise, all others clockwise",
    "numbers of outer and inner loops")
def hole_called_outer_loop(file):
    lines = file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]
    file.cell("BoundaryKind")[lines] = 1
    file.cell("QuarterIndex")[lines] = 0


@of("drilled", "lines have the domain on their left",
    "the outer loop runs counter-clockwise, all others clockwise", "triangles fill the loops")
def loop_turned(file):
    for line in file.mesh.of_kind(3)[0].lines:
        start = len(file.mesh.triangles) * 3 + 2 * line
        file.corners[start:start + 2] = file.corners[start:start + 2][::-1].copy()


@of("drilled", "no edge has more than two triangles",
    "every boundary edge has one line, and no other has", "triangles fill the loops")
def triangle_doubled(file):
    inside = np.flatnonzero(file.mesh.sides_of_edge[file.mesh.edge].min(axis=1) == 2)
    file.corners[3 * inside[3]:3 * inside[3] + 3] = file.mesh.triangles[inside[40]]


@of("drilled", "cells are triangles and lines", "Euler characteristic of a connected mesh in its loops",
    "every boundary edge has one line, and no other has", "triangles fill the loops")
def triangle_called_polygon(file):
    vtk_to_numpy(file.grid.GetCellTypesArray())[len(file.mesh.triangles) // 2] = 7


@of("drilled", "the file makes sense")
def line_turned(file):
    first = len(file.mesh.triangles) * 3
    file.corners[first:first + 2] = file.corners[first:first + 2][::-1].copy()


@of("drilled", "kinds of lines are 1 to 4", "every boundary edge has one line, and no other has",
    "imprinted circles lie inside", "Euler characteristic of a connected mesh in its loops")
def hole_of_no_kind(file):
    file.cell("BoundaryKind")[file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]] = 7


@of("drilled", "rows of singularities are unlike")
def hole_without_a_row(file):
    file.cell("BoundaryId")[file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]] = -1


@of("drilled", "loops have enough edges for their quarter index")
def index_that_no_polygon_holds(file):
    file.cell("QuarterIndex")[file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]] = 16


@of("constrained", "both triangles of an edge have its value")
def triangles_disagree(file):
    inside = np.flatnonzero(file.mesh.sides_of_edge[file.mesh.edge].min(axis=1) == 2)
    file.cell("CrossFieldCR")[inside[9], 0] += 1e-12


@of("constrained", "lines have the value of their edge three times")
def line_disagrees(file):
    file.cell("CrossFieldCR")[file.lines[4], 2] += 1e-12


@of("constrained", "Representation of triangles", "Cross of triangles: its fourth power is u")
def representation_of_a_triangle(file):
    file.cell("Representation")[11, 1] += 1e-4
    file.cell("CrossNorm")[11] = np.hypot(*file.cell("Representation")[11, :2])


@of("constrained", "Representation of lines", "CrossNorm of lines")
def representation_of_a_line(file):
    file.cell("Representation")[file.lines[4], :2] *= 1.0 + 1e-5


@of("constrained", "Representation of points", "CrossNorm of points")
def representation_of_a_point(file):
    file.point("Representation")[40, :2] *= 1.0 + 1e-5


@of("constrained", "CrossNorm of triangles")
def norm_of_a_triangle(file):
    file.cell("CrossNorm")[11] += 1e-5


@of("constrained", "Cross of lines: its fourth power is u",
    "Cross2 of lines: a unit branch at +90 degrees in the plane")
def cross_of_a_line_rotated(file):
    row = file.lines[4]
    x, y, _ = file.cell("Cross")[row]
    file.cell("Cross")[row] = (x - 1e-5 * y, y + 1e-5 * x, 0.0)


@of("constrained", "Cross of points: its fourth power is u",
    "Cross2 of points: a unit branch at +90 degrees in the plane")
def cross_of_a_point_rotated(file):
    x, y, _ = file.point("Cross")[40]
    file.point("Cross")[40] = (x - 1e-5 * y, y + 1e-5 * x, 0.0)


@of("constrained", "Cross of triangles: the branch nearest to the first axis")
def other_branch_of_a_triangle(file):
    first, second = file.cell("Cross"), file.cell("Cross2")
    first[11], second[11] = second[11].copy(), -first[11]


@of("constrained", "Cross of lines: the branch nearest to the first axis",
    "Cross of points: the branch nearest to the first axis")
def other_branches(file):
    for first, second, row in ((file.cell("Cross"), file.cell("Cross2"), file.lines[2]),
                               (file.point("Cross"), file.point("Cross2"), 30)):
        first[row], second[row] = second[row].copy(), -first[row]


@of("constrained", "Cross2 of triangles: a unit branch at +90 degrees in the plane")
def clockwise_branch(file):
    file.cell("Cross2")[11] *= -1.0


@of("constrained", "triangles have the arrays of a choice", "lines have the arrays of a choice")
def array_missing(file):
    file.remove(file.grid.GetCellData(), "Cross2")


@of("constrained", "points have the arrays of a choice")
def array_of_points_missing(file):
    file.remove(file.grid.GetPointData(), "CrossNorm")
