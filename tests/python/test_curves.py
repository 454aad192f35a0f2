"""Curves of sides and quads of order 2 and 3: areas, and convergence of a solver with u = 0 on the true circles.

    python3 test_curves.py
"""
import contextlib
import sys

import numpy as np

import crossfield
from checks import check

try:
    import scipy.sparse
    import scipy.sparse.linalg
except ImportError:
    sys.exit(77)


@contextlib.contextmanager
def raises(kind, words):
    try:
        yield
    except kind as error:
        check(words in str(error), "%r is not in %r" % (words, str(error)))
        return
    raise AssertionError("no error with %r" % words)


def circle(count, radius=1.0):
    angles = 2 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def lattice_order(order):
    """Returns for VTK's order of nodes their indices (i, j)."""
    p = order
    nodes = [(0, 0), (p, 0), (p, p), (0, p)]
    nodes += [(k, 0) for k in range(1, p)] + [(p, k) for k in range(1, p)]
    nodes += [(k, p) for k in range(1, p)] + [(0, k) for k in range(1, p)]
    return nodes + [(i, j) for j in range(1, p) for i in range(1, p)]


class Elements:
    """Values, derivatives and weights of a mesh at Gauss points."""

    def __init__(self, mesh, points_per_side):
        p = mesh.order
        x, weights = np.polynomial.legendre.leggauss(points_per_side)
        x, weights = (x + 1) / 2, weights / 2
        steps = np.arange(p + 1) / p
        basis = [np.polynomial.Polynomial.fromroots(np.delete(steps, i)) for i in range(p + 1)]
        basis = [b / b(s) for b, s in zip(basis, steps)]
        value = np.array([b(x) for b in basis])
        slope = np.array([b.deriv()(x) for b in basis])
        nodes = lattice_order(p)
        product = lambda a, b: np.array([np.outer(b[j], a[i]).ravel() for i, j in nodes])
        self.value = product(value, value)
        local = np.array([product(slope, value), product(value, slope)])  # axis, node, Gauss point
        corners = mesh.points[mesh.quad_nodes][:, :, :2]
        jacobian = np.einsum("eni,ang->egia", corners, local)
        self.det = np.linalg.det(jacobian)
        self.weight = self.det * np.outer(weights, weights).ravel()
        inverse = np.linalg.inv(jacobian)
        self.gradient = np.einsum("egai,ang->engi", inverse, local)
        self.place = np.einsum("eni,ng->egi", corners, self.value)


def poisson_error(mesh, exact, source):
    """Solves −Δu = f with u = 0 on the boundary and returns the L2 error."""
    elements = Elements(mesh, mesh.order + 2)
    nodes, count = mesh.quad_nodes, len(mesh.points)
    stiffness = np.einsum("engi,emgi,eg->enm", elements.gradient, elements.gradient, elements.weight)
    rows, columns = np.repeat(nodes, nodes.shape[1], axis=1), np.tile(nodes, nodes.shape[1])
    matrix = scipy.sparse.coo_matrix((stiffness.ravel(), (rows.ravel(), columns.ravel())), (count, count)).tocsr()
    load = np.einsum("ng,eg,eg->en", elements.value, elements.weight, source(*np.moveaxis(elements.place, -1, 0)))
    right = np.bincount(nodes.ravel(), load.ravel(), count)
    free = np.ones(count, bool)
    free[mesh.edge_nodes] = False
    u = np.zeros(count)
    u[free] = scipy.sparse.linalg.spsolve(matrix[free][:, free].tocsc(), right[free])
    difference = np.einsum("en,ng->eg", u[nodes], elements.value) - exact(*np.moveaxis(elements.place, -1, 0))
    return np.sqrt(np.sum(difference ** 2 * elements.weight))


def disk_solution(x, y):
    return (1 - x * x - y * y) * np.exp(x)


def disk_source(x, y):
    g = 1 - x * x - y * y
    return -np.exp(x) * (g - 4 - 4 * x)


def ring_solution(x, y):
    s = x * x + y * y
    return (s - 1) * (4 - s) * np.exp(x / 2)


def ring_source(x, y):
    s = x * x + y * y
    return -np.exp(x / 2) * (20 - 16 * s + 2 * (5 - 2 * s) * x + (s - 1) * (4 - s) / 4)


def ring(outer, inner):
    """Returns a ring of two polygons as a vtkPolyData with the sides 'wall' and 'hole'."""
    from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    points, lines, sides = vtkPoints(), vtkCellArray(), vtkStringArray()
    points.SetDataTypeToDouble()
    sides.SetName("Side")
    for loop, name in ((outer, "wall"), (inner, "hole")):
        first = points.GetNumberOfPoints()
        for i, (x, y) in enumerate(loop):
            points.InsertNextPoint(x, y, 0)
            lines.InsertNextCell(2)
            lines.InsertCellPoint(first + i)
            lines.InsertCellPoint(first + (i + 1) % len(loop))
            sides.InsertNextValue(name)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    data.GetCellData().AddArray(sides)
    return data


def check_orders(make, exact, source):
    """The error of order p decreases as h^(p + 1), here with a rate of at least p + 0.9."""
    for order in (1, 2, 3):
        errors, sizes = [], []
        for count in (600, 2400) if order == 3 else (1200, 4800):  # the rates of coarser meshes vary
            mesh = make(count, order)
            check(mesh.order == order, "order")
            errors.append(poisson_error(mesh, exact, source))
            sizes.append(1 / np.sqrt(len(mesh.quads)))
        rate = np.log(errors[0] / errors[1]) / np.log(sizes[0] / sizes[1])
        check(rate >= order + 0.9, "order %d: rate %.2f of errors %s" % (order, rate, errors))
        print("order %d: L2 errors %s, rate %.2f" % (order, ["%.2e" % error for error in errors], rate))


FOUR = [(0.5, 0.5, 1), (-0.5, 0.5, 1), (-0.5, -0.5, 1), (0.5, -0.5, 1)]

# A solver converges on a polygon of 16 points as on the disk, and on a ring of 12 and 24.
check_orders(lambda count, order: crossfield.quads(circle(16), FOUR, count=count, curves="auto", order=order,
                                                   sizing="conformal"),
             disk_solution, disk_source)
check_orders(lambda count, order: crossfield.quads(ring(circle(24, 2), circle(12)), [], count=count, order=order,
                                                   curves={"wall": "circle", "hole": "circle"}),
             ring_solution, ring_source)

# Areas of order 2 with 3,840 quads.
mesh = crossfield.quads(circle(16), count=3840, curves="auto", order=2)
area = Elements(mesh, 4).weight.sum()
check(abs(area / np.pi - 1) <= 1e-7, "area of the disk: %r" % (area / np.pi - 1))
mesh = crossfield.quads(ring(circle(24, 2), circle(12)), [], count=3840, curves="auto", order=2)
area = Elements(mesh, 4).weight.sum()
check(abs(area / (3 * np.pi) - 1) <= 1e-7, "area of the ring: %r" % (area / (3 * np.pi) - 1))

# All nodes of the boundary are on the circles, and the report describes them.
for side, radius in (("wall", 2), ("hole", 1)):
    places = mesh.points[mesh.edge_nodes[mesh.edge_side == side]]
    check(np.abs(np.linalg.norm(places, axis=-1) - radius).max() < 1e-14, "nodes of " + side)
    check(len(mesh.side(side)) == np.sum(mesh.edge_side == side), "points of " + side)
report = mesh.report
check(report["higher_order"]["order"] == 2 and report["higher_order"]["inverted"] == 0, report["higher_order"])
check(0.4 < report["higher_order"]["jacobian_ratio"] < 1, report["higher_order"])
check({curve["sides"]: curve["kind"] for curve in report["curves"]} == {"wall": "circle", "hole": "circle"},
      report["curves"])
moved = {curve["sides"]: curve["moved"] for curve in report["curves"]}
check(0.9 < moved["hole"] / (1 - np.cos(np.pi / 12)) <= 1 + 1e-9, moved)
check(mesh.valence.shape == (len(mesh.points),), "valence")
check("curves" not in crossfield.quads(circle(40), count=100).report, "no curves without a request")

# A mesh without curves may have a higher order as well.
square = crossfield.quads([(0, 0), (1, 0), (1, 1), (0, 1)], size=0.25, order=3)
check(square.quad_nodes.shape == (16, 16) and abs(Elements(square, 4).weight.sum() - 1) < 1e-14, "square")

# Curves of a simplified domain.
many, _ = crossfield.simplify(circle(2000), thin=0.02, curves={"outer0": "circle"})
check(many.GetCellData().HasArray("Curve") and many.GetNumberOfPoints() < 1000, "curves are passed on")
mesh = crossfield.quads(many, count=200, order=2)
check(np.abs(np.linalg.norm(mesh.points[mesh.edge_nodes], axis=-1) - 1).max() < 1e-12, "nodes after thinning")

for arguments, words in (
        ({"curves": {"outer0": "ellipsis"}}, "'outer0:ellipsis' is not of the form"),
        ({"curves": {"hole": "circle"}}, "no side 'hole' for a curve"),
        ({"curves": "circle"}, 'neither "auto" nor a dictionary'),
        ({"order": 4}, "no quads of order 4; give 1, 2 or 3"),
):
    with raises(crossfield.Error, words):
        crossfield.quads(circle(16), count=100, **arguments)
square = [(0, 0), (1, 0), (1, 1), (0, 1)]
with raises(crossfield.Error, "Side 'outer0' is declared as circle"):
    crossfield.quads(square, count=100, curves={"outer0": "circle"})
