"""Cases of quad meshes that are corrupted in one place."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from corrupting import of

SHAPES = ("ScaledJacobian is the least sine of the angles", "ScaledJacobianRange", "EtaRange",
          "SizeRange: roots of areas")
SIDES = "every boundary edge has one line with the domain on its left, and no other has"
EULER = "Euler characteristic of a connected mesh in its loops"
VALENCE = "quads at a point: 4 - k inside, 2 - k on the boundary"


def _inner(file):
    """Returns a regular inner point."""
    return np.flatnonzero((file.point("BoundarySide") < 0) & (file.point("Irregular") == 0))[5]


def _inner_quad(file):
    """Returns a quad whose points are all regular inner points."""
    good = (file.point("BoundarySide") < 0) & (file.point("Irregular") == 0)
    return np.flatnonzero(good[file.data.quads].all(axis=1))[7]


@of("quads", "points lie in a plane", SHAPES[0])
def quad_point_off_the_plane(file):
    file.points[_inner(file), 2] += 1e-3


@of("quads", *SHAPES)
def quad_point_moved(file):
    file.points[_inner(file), :2] += 1e-5


@of("quads", "no two points are in one place", "Inverted", "MinimumAngle", *SHAPES)
def quad_point_on_another(file):
    quad = file.data.quads[_inner_quad(file)]
    file.points[quad[0]] = file.points[quad[1]]


@of("quads", "quads agree in their orientation", SIDES, "Inverted", "quads fill the loops",
    "neighbours in a lattice share their side", "no quad is turned over except the reported ones", *SHAPES)
def quad_turned_over(file):
    first = 4 * _inner_quad(file)
    file.corners[first:first + 4] = file.corners[first:first + 4][::-1].copy()


@of("quads", "BoundarySide is the loop of a point")
def quad_point_of_another_loop(file):
    file.point("BoundarySide")[_inner(file)] = 1


@of("regions", "the edges between materials have one line, and others are inside", SIDES, "the file makes sense")
def line_between_materials_on_the_boundary(file):
    kinds = file.cell("BoundaryKind")
    kinds[np.flatnonzero(kinds == 1)[0]] = 5


@of("quads", "the edges on sharp edges are inside, with one line each", SIDES, "the file makes sense")
def line_of_a_sharp_edge_on_the_boundary(file):
    kinds = file.cell("BoundaryKind")
    kinds[np.flatnonzero(kinds == 1)[0]] = 7


@of("regions", "RegionLeft is the material beside a line", "RegionRight is the material beside a line",
    "Region is the material beside a line")
def materials_beside_a_line_changed(file):
    line = np.flatnonzero(file.cell("BoundaryKind") == 5)[0]
    for name in ("RegionLeft", "RegionRight", "Region"):
        file.cell(name)[line] = 7


@of("quads", "Part numbers what is connected")
def quad_of_another_part(file):
    file.cell("Part")[0] = 1


@of("quads", "Valence counts the quads")
def quad_valence_changed(file):
    file.point("Valence")[_inner(file)] = 5


@of("quads", VALENCE, "sum of all indices: 4 times the Euler characteristic")
def irregular_node_dropped(file):
    file.point("Irregular")[np.flatnonzero(file.point("Irregular") == 1)[0]] = 0


@of("quads", "IrregularObtained")
def irregular_nodes_miscounted(file):
    file.report("IrregularObtained")[0] += 1


@of("quads", "irregular nodes as asked")
def asked_nodes_miscounted(file):
    file.report("IrregularRequested")[0] += 1


@of("quads", "IrregularObtained", "irregular nodes as asked", "no other irregular node")
def irregular_valence_hidden(file):
    file.report("IrregularValence")[0] = 9


@of("quads", "Blocks")
def blocks_miscounted(file):
    file.report("Blocks")[0] += 1


@of("quads", "Quads")
def quads_miscounted(file):
    file.report("Quads")[0] += 1


@of("quads", "blocks are full lattices")
def quad_of_another_column(file):
    file.cell("I")[_inner_quad(file)] += 100


@of("quads", "ScaledJacobianRange")
def minimum_jacobian_changed(file):
    file.report("ScaledJacobianRange")[0] += 1e-9


@of("quads", "MinimumAngle")
def minimum_angle_changed(file):
    file.report("MinimumAngle")[0] += 1e-6


@of("quads", "EtaRange")
def eta_changed(file):
    file.report("EtaRange")[1] += 1e-9


@of("quads", "SizeRange: roots of areas")
def quad_sizes_changed(file):
    file.report("SizeRange")[2] *= 1 + 1e-9


@of("quads", "Inverted")
def inverted_quad_claimed(file):
    file.report("Inverted")[0] = 1


@of("quads", SIDES)
def quad_lines_turned(file):
    start = 4 * len(file.data.quads)
    lines = file.corners[start:].reshape(-1, 2)
    lines[:] = lines[:, ::-1].copy()


@of("quads", "quads have four points", "no edge has more than two quads", "quads agree in their orientation", SIDES,
    "Valence counts the quads", VALENCE, "IrregularObtained", "irregular nodes as asked",
    "neighbours in a lattice share their side", "Inverted", "quads fill the loops",
    "no quad is turned over except the reported ones", "MinimumAngle", *SHAPES)
def quad_with_a_point_twice(file):
    first = 4 * _inner_quad(file)
    file.corners[first] = file.corners[first + 2]


@of("quads", "cells are quads and lines", EULER, SIDES, "Valence counts the quads", VALENCE, "IrregularObtained",
    "irregular nodes as asked", "Quads", "blocks are full lattices", "quads fill the loops",
    *SHAPES[1:])
def quad_called_polygon(file):
    vtk_to_numpy(file.grid.GetCellTypesArray())[_inner_quad(file)] = 7
