"""Checks the size field H: its equation, and that H + iθ with the crosses is analytic
(docs/method.md §2 and §11).

Φ = 4H. Along side s of a triangle a conjugate pair has ΔΦ = −s · Σ φ_j s_j / A: the flux of ∇φ. On
a mesh with holes this holds in every triangle. On a mesh without holes it holds for the regular
parts

    R = Φ − Σ_j k_j log|x − b_j| − Σ_c s_c log|x − p_c|,   φ − Σ_j k_j arg(x − b_j) − Σ_c s_c arg(x − p_c),

b_j the singularities, p_c the corners, and R is P1-harmonic at inner vertices. The file has neither
the b_j nor the s_c: they are fitted. A wrong field cannot be fitted to rounding in thousands of
triangles.
"""
import numpy as np

from report import ROUNDING, rounding_of
from topology import HOLE, INNER, OUTER, cross


def flux(mesh, phases):
    """Returns s_i · Σ φ_j s_j / A of every side."""
    vector = np.einsum("ti,tic->tc", phases, mesh.side) / mesh.area[:, None]
    return np.einsum("tic,tc->ti", mesh.side, vector)


def sizes(mesh):
    length = np.linalg.norm(mesh.side, axis=2)
    return length * (length.sum(axis=1) / mesh.area)[:, None]


def check_arrays(data, mesh, on_holes, report):
    h = data.at_points["H"]
    report.true("H is finite", np.all(np.isfinite(h)))
    if "SizeMap" in data.at_points:  # otherwise the run did not request it
        size = data.at_points["SizeMap"]
        report.bound("SizeMap is e^H", np.abs(size.astype(float) / np.exp(h) - 1.0).max(),
                     rounding_of(size) + 4 * ROUNDING * max(1.0, np.abs(h).max()),
                     "rounding of an exponential")
    mean = (mesh.area * h[mesh.triangles].mean(axis=1)).sum() / mesh.area.sum()
    if on_holes:
        report.bound("area mean of H", abs(mean), len(mesh.area) * ROUNDING * np.abs(h).max(),
                     "one rounding a triangle")
    else:
        # The program integrates the logarithms exactly; these are nodal values.
        length = np.linalg.norm(mesh.side, axis=2).max()
        scale = length ** 2 / mesh.area.sum() * len(mesh.points) ** 0.5
        report.bound("area mean of H", abs(mean), scale * np.abs(h).max(),
                     "discretisation of logarithms by values at vertices")


def check_on_holes(data, mesh, phase, report):
    """Checks that H is constant on holes and conjugate to the phase in every triangle."""
    potential = 4.0 * data.at_points["H"]
    rounding = mesh.rounding()
    spread = max((np.ptp(potential[mesh.lines[loop.lines, 0]]) for loop in mesh.of_kind(HOLE)), default=0.0)
    report.bound("H is constant on every hole", spread, rounding * max(1.0, np.abs(potential).max()),
                 "one rounding an edge")
    corner = potential[mesh.triangles]
    off = np.abs(np.roll(corner, -1, axis=1) - corner + flux(mesh, phase.values)) / sizes(mesh)
    _check_conjugate(data, mesh, off.max(axis=1), rounding * max(1.0, np.abs(potential).max()), report)


def _check_conjugate(data, mesh, off, tolerance, report):
    defects = np.abs(data.field.get("HolonomyDefect", np.zeros(0))).max(initial=0.0)
    if defects <= tolerance:
        report.bound("4∇H is the conjugate of the phase's gradient", off.max(initial=0.0), tolerance,
                     "one rounding an edge, relative to the terms")
        return
    report.note("H is a branch with a jump along a way to every inner loop: its triangles are left out")
    beyond = np.count_nonzero(off > tolerance)
    ways = 4.0 * np.sqrt(len(off)) * len(mesh.of_kind(INNER))
    report.bound("triangles in which 4∇H is not the conjugate of the phase's gradient", beyond, ways,
                 "those of ways across the mesh, about the root of their number")


class Fit:
    """Regular parts for given positions of singularities. Also fits the strengths of corners and
    the position on a curve of the logarithms of its vertices."""

    def __init__(self, data, mesh, field, boundary, singularities, extra):
        self.mesh, self.field = mesh, field
        self.potential = 4.0 * data.at_points["H"]
        self.quarters = np.array([s.quarter for s in singularities], float)
        self.places = np.array([s.position for s in singularities]).reshape(-1, 2)
        self.corners = boundary.vertex[boundary.corner | extra]
        self.strengths = np.zeros(len(self.corners))
        self.origins = mesh.points[self.corners].copy()
        self.middle = mesh.midpoint[mesh.edge]
        on_corner = np.zeros(len(mesh.points), bool)
        on_corner[self.corners] = True
        # At the source of a logarithm the value of H is a mean; curves are aligned at the end.
        curved = np.zeros(len(mesh.points), bool)
        turning = (np.abs(boundary.angle) > 1e-12) & ~(boundary.corner | extra)
        for loop in mesh.of_kind(OUTER, INNER):
            vertices = mesh.lines[loop.lines, 0]
            if np.isin(boundary.vertex[turning], vertices).any():
                curved[vertices] = True
        self.curved = curved
        bends = (boundary.corner | extra).nonzero()[0]
        self.on_curve = ~boundary.corner[bends] & curved[self.corners]
        aligned = np.zeros(len(mesh.ends), bool)
        aligned[mesh.edge_of_line[mesh.aligned_lines]] = True
        at_curve = aligned & curved[mesh.ends].all(axis=1)
        self.used = ~on_corner[mesh.triangles].any(axis=1) & ~at_curve[mesh.edge].any(axis=1)

    def regular(self):
        """Returns R at vertices, NaN at a source."""
        r = self.potential.copy()
        with np.errstate(divide="ignore", invalid="ignore"):
            for k, b in zip(self.quarters, self.places):
                r -= k * np.log(np.linalg.norm(self.mesh.points - b, axis=1))
            for s, origin in zip(self.strengths, self.origins):
                if s != 0.0:
                    r -= s * np.log(np.linalg.norm(self.mesh.points - origin, axis=1))
        r[~np.isfinite(r)] = np.nan
        r[self.corners[self.strengths != 0.0]] = np.nan
        return r

    def _turn(self, place):
        """Returns the angle from the midpoint of side i to that of side i + 1, seen from a
        point."""
        arm = self.middle - place
        after = np.roll(arm, -1, axis=1)
        return np.arctan2(cross(arm, after), (arm * after).sum(axis=2))

    def residual(self):
        """Returns ΔR + flux of the regular phase on every side."""
        step = self.field.step.copy()
        for k, b in zip(self.quarters, self.places):
            step -= k * self._turn(b)
        for s, origin in zip(self.strengths, self.origins):
            step -= s * self._turn(origin)
        step -= 2.0 * np.pi * np.rint(step / (2.0 * np.pi))
        phases = np.stack([np.zeros(len(step)), step[:, 0], -step[:, 2]], axis=1)
        corner = self.regular()[self.mesh.triangles]
        return np.roll(corner, -1, axis=1) - corner + flux(self.mesh, phases)

    def _columns(self, rows):
        """Returns the derivatives of the residual by the positions, in units of the domain's size,
        and by the strengths, on chosen triangles."""
        mesh = self.mesh
        points = mesh.points[mesh.triangles[rows]]
        middle = self.middle[rows]
        side, area = mesh.side[rows], mesh.area[rows]

        def of(at_points, at_middles):
            vector = np.einsum("ti,tic->tc", at_middles, side) / area[:, None]
            return (np.roll(at_points, -1, axis=1) - at_points +
                    np.einsum("tic,tc->ti", side, vector)).ravel()

        columns = []
        moving = list(zip(self.quarters, self.places))
        moving += zip(self.strengths[self.on_curve], self.origins[self.on_curve])
        for k, b in moving:
            y, z = points - b, middle - b
            y, z = (mesh.frame.size * v / (v ** 2).sum(axis=2, keepdims=True) for v in (y, z))
            columns.append(of(k * y[..., 0], -k * z[..., 1]))
            columns.append(of(k * y[..., 1], k * z[..., 0]))
        for place in self.origins:
            turn = self._turn(place)[rows]
            angles = np.stack([np.zeros(len(turn)), turn[:, 0], -turn[:, 2]], axis=1)
            columns.append(of(-np.log(np.linalg.norm(points - place, axis=2)), -angles))
        return np.array(columns).T

    def run(self, multivalued):
        scale = sizes(self.mesh)
        for _ in range(12):
            with np.errstate(invalid="ignore"):
                residual = self.residual() / scale
                rows = np.flatnonzero(self.used & np.isfinite(residual).all(axis=1))
                if multivalued:
                    size = np.abs(residual[rows]).max(axis=1)
                    rows = rows[size <= np.quantile(size, 0.9)]
                columns = self._columns(rows) / scale[rows].reshape(-1, 1)
            if columns.size == 0:
                return
            step = np.linalg.lstsq(columns, -residual[rows].ravel(), rcond=None)[0]
            inside, count = len(self.places), len(self.corners)
            moved = self.mesh.frame.size * step[:len(step) - count].reshape(-1, 2)
            self.places += moved[:inside]
            self.origins[self.on_curve] += moved[inside:]
            self.strengths += step[len(step) - count:]
            if np.abs(step).max(initial=0.0) < 1e-15:
                return


def check_at_points(data, mesh, field, boundary, singularities, chosen, report):
    """Checks H with singularities that are points."""
    inside = [s for s in singularities if s.inside]
    fit = Fit(data, mesh, field, boundary, inside, chosen)
    defects = np.abs(data.field.get("HolonomyDefect", np.zeros(0))).max(initial=0.0)
    # A logarithm is exact to a few roundings and is subtracted where it is large.
    rounding = mesh.rounding() * max(1.0, np.abs(fit.potential).max())
    fit.run(defects > rounding)
    with np.errstate(invalid="ignore"):
        off = np.abs(fit.residual() / sizes(mesh)).max(axis=1)
    known = fit.used & np.isfinite(off)
    report.note("H is tested in %d of %d triangles, not at sources and at sides of curves" % (
        np.count_nonzero(known), len(known)))
    _check_conjugate(data, mesh, off[known], rounding, report)
    if defects > rounding:
        return
    r = fit.regular()
    corner = r[mesh.triangles]
    length = np.linalg.norm(mesh.side, axis=2)
    # Gradient of the hat function of point i: rot s_{i+1} / 2A.
    hat = np.roll(mesh.side, -1, axis=1) / (2.0 * mesh.area[:, None, None])
    gradient = np.einsum("ti,tic->tc", corner - corner[:, :1], hat)
    share = np.einsum("tic,tc->ti", hat, gradient) * mesh.area[:, None]
    bound = np.roll(length, -1, axis=1) * (length.sum(axis=1) / (4.0 * mesh.area))[:, None]
    count = len(mesh.points)
    total = np.bincount(mesh.triangles.ravel(), share.ravel(), count)
    bounds = np.bincount(mesh.triangles.ravel(), bound.ravel(), count)
    inner = np.ones(count, bool)
    inner[mesh.lines[mesh.aligned_lines].ravel()] = False
    inner &= np.isfinite(total) & (bounds > 0)
    report.bound("H without its logarithms is harmonic at inner vertices",
                 np.abs(total[inner] / bounds[inner]).max(initial=0.0), rounding,
                 "one rounding an edge, relative to the terms")
    straight = ~fit.curved[fit.corners]
    position = {v: i for i, v in enumerate(boundary.vertex)}
    rows = [position[v] for v in fit.corners]
    angle = boundary.angle[rows]
    # A corner of quarter index k at which the boundary turns by t has the strength (2πk − 4t) / (π
    # − t).
    quarters = (fit.strengths * (np.pi - angle) + 4.0 * angle) / (2.0 * np.pi)
    report.bound("logarithms of corners between straight sides are of whole quarters",
                 np.abs(quarters - np.rint(quarters))[straight].max(initial=0.0), 1e3 * rounding,
                 "rounding of the fit, a thousand times that of its equations")
    if straight.all():
        report.equal("quarter indices of the logarithms: 4 times the Euler characteristic",
                     4 * mesh.euler_characteristic(), int(np.rint(quarters).sum() + fit.quarters.sum()))
