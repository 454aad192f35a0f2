"""Checks that fields that are minimisers are stationary: harmonic away from the constraints, with
the Karush-Kuhn-Tucker conditions on holes and imprinted circles with multipliers by least squares.

The functional is ½ ∫ w |∇u|² + 1/(4ε²) ∫ (|u|² − f²)², the penalty by the midpoint rule on sides and
only if ε is given. A loop of m edges, counter-clockwise, has one of the constraints
  degree  Σ_j Im(conj(u_j) u_{j+1}) = Σ_j sin(k Δα_j), Δα_j the angle seen from the centre,
  unit    u_j = e^{iφ} e^{i k α_j}: the values turn uniformly, and φ is the only unknown,
  sum     all loops that are not unit share one constraint, the sum of theirs.
"""
import numpy as np

from crouzeix_raviart import masses, stiffness, stiffness_sizes
from topology import HOLE, IMPRINTED, cross


class ConstrainedLoop:
    """A hole or circle with its edges and the value, target and gradient of its constraint."""

    def __init__(self, mesh, field, loop):
        self.loop = loop
        self.edges = mesh.counter_clockwise(loop)
        self.u = field.u[self.edges]
        arm = mesh.midpoint[self.edges] - mesh.centre(loop)
        following = np.roll(arm, -1, axis=0)
        step = np.arctan2(cross(arm, following), (arm * following).sum(axis=1))
        self.target = np.sin(loop.quarter * step).sum()
        self.value = (self.u.conj() * np.roll(self.u, -1)).imag.sum()
        self.gradient = 1j * (np.roll(self.u, 1) - np.roll(self.u, -1))
        self.violation = abs(self.value - self.target) / len(self.edges)
        even = np.exp(1j * loop.quarter * np.arctan2(arm[:, 1], arm[:, 0]))
        phase = (even.conj() * self.u).sum()
        nearest = even * (phase / abs(phase) if phase != 0 else 1.0)
        self.off_unit = np.abs(self.u - nearest).max()


def forces(data, mesh, field, epsilon=None, norm=1.0, weight=1.0):
    """Returns the gradient of the functional at every edge, and the sizes of the terms that cancel
    in it."""
    elastic = stiffness(mesh, field.in_triangle, weight)
    aligned = np.where(mesh.free, 0.0, field.u)
    load = stiffness(mesh, aligned[mesh.edge], weight)
    penalty = np.zeros(len(mesh.ends), complex)
    if epsilon:
        pull = masses_with(mesh, norm ** 2 * np.ones(len(mesh.triangles)))
        penalty = (masses(mesh) * np.abs(field.u) ** 2 - pull) * field.u / epsilon ** 2
    size = sum(np.linalg.norm(term[mesh.free]) for term in (elastic - load, load, penalty))
    return elastic + penalty, size


def masses_with(mesh, values):
    """Returns ∫ of the basis functions times a value for each triangle."""
    third = (mesh.area * values / 3.0)[:, None]
    return np.bincount(mesh.edge.ravel(), np.repeat(third, 3, axis=1).ravel(), len(mesh.ends))


def check_constrained(data, mesh, field, report):
    """Checks a field of the Constrained method with any of its variants."""
    epsilon = data.value("Epsilon")
    force, size = forces(data, mesh, field, epsilon)
    loops = [ConstrainedLoop(mesh, field, loop) for loop in mesh.of_kind(HOLE, IMPRINTED)]
    stated, converged = data.value("Residual"), data.value("Converged") == 1
    rounding = mesh.rounding()
    allowed = stated + rounding
    unit = []
    if data.value("UnitHoles") == 1:
        unit = [loop for loop in loops if loop.off_unit <= rounding]
        report.true("UnitHoles: some hole has unit crosses that turn evenly", bool(unit) or not loops,
                    "the nearest is off by %g" % min((loop.off_unit for loop in loops), default=0))
    held = [loop for loop in loops if loop not in unit]
    each = all(loop.violation <= allowed for loop in held)
    together = abs(sum(loop.value - loop.target for loop in held))
    edges = max(1, sum(len(loop.edges) for loop in held))
    by_sum = not each and together / edges <= allowed
    if by_sum:
        report.note("the degree constraints hold in their sum only, to %.1e, as GlobalConstraint makes "
                    "it; the file does not say whether that was asked for" % (together / edges))
    worst = together / edges if by_sum else max((loop.violation for loop in held), default=0.0)
    if not by_sum:
        report.bound("degree constraint of every hole", worst, allowed, "Residual of the file, or rounding")

    left = force.copy()
    left[~mesh.free] = 0.0
    if by_sum:
        inner = sum((loop.gradient.conj() * force[loop.edges]).real.sum() for loop in held)
        multiplier = -inner / sum((np.abs(loop.gradient) ** 2).sum() for loop in held)
        multipliers = [multiplier] * len(held)
    else:
        multipliers = [-(loop.gradient.conj() * force[loop.edges]).real.sum() /
                       max((np.abs(loop.gradient) ** 2).sum(), 1e-300) for loop in held]
    for loop, multiplier in zip(held, multipliers):
        left[loop.edges] += multiplier * loop.gradient
    for loop in unit:
        # The constraint leaves only a common rotation of all values free.
        torque = (loop.u.conj() * force[loop.edges]).imag.sum() / len(loop.edges)
        left[loop.edges] = torque * 1j * loop.u
    on_loops = np.zeros(len(mesh.ends), bool)
    for loop in loops:
        on_loops[loop.edges] = True
    residual = _check_left(report, mesh, left, on_loops, size, stated, rounding, field, epsilon)
    check_not_converged(report, converged, stated, max(worst, residual), rounding)
    return by_sum


def _check_left(report, mesh, left, on_loops, size, stated, rounding, field, epsilon):
    """Checks the residual of the stationarity, relative to the terms that cancel in it."""
    sizes = stiffness_sizes(mesh) * max(1.0, np.abs(field.u).max())
    if epsilon is None:
        # These unknowns are eliminated exactly, whether or not the iteration on the loops
        # converged.
        inside = np.abs(left / sizes)[mesh.free & ~on_loops]
        report.bound("harmonic at every edge off the loops", inside.max(initial=0.0), rounding,
                     "one rounding an edge, relative to the terms")
    residual = np.linalg.norm(left[mesh.free]) / size if size > 0 else 0.0
    # The residual in the file is relative to the terms on the loops, which may be larger.
    local = np.linalg.norm(sizes[on_loops]) / size if size > 0 and epsilon is None else 1.0
    report.bound("Karush-Kuhn-Tucker residual", residual, stated * max(1.0, 2.0 * local) + rounding,
                 "Residual of the file, or rounding")
    return residual


def check_not_converged(report, converged, stated, residual, rounding):
    """Checks that the residual of a field that has not converged is about the one in the file.

    Only roughly, since the residual in the file may be relative to the terms on the loops alone.
    """
    if not converged and stated > 1e-10:
        report.true("not converged, as the file states", residual > max(1e-3 * stated, rounding),
                    "the recomputed residual is %g" % residual)


def check_ginzburg_landau(data, mesh, field, report, norm, weight):
    force, size = forces(data, mesh, field, data.value("Epsilon"), norm, weight)
    residual = np.linalg.norm(force[mesh.free]) / size if size > 0 else 0.0
    stated, rounding = data.value("Residual"), mesh.rounding()
    report.bound("Ginzburg-Landau equation", residual, stated + rounding,
                 "Residual of the file, or rounding")
    report.bound("Residual", abs(residual - stated), max(1e-6 * stated, rounding),
                 "one rounding an edge, or of the file's own sum")
    check_not_converged(report, data.value("Converged") == 1, stated, residual, rounding)
