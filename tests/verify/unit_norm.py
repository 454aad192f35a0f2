"""Checks fields of norm one: the phase is discretely harmonic, and so is its conjugate potential.

∇φ = rot ∇Φ with a continuous P1 function Φ that is constant on every hole exactly if the flux of ∇φ
is continuous across every inner edge and zero through every edge of a hole: if (K φ)_e = 0 there.
"""
import numpy as np

from crouzeix_raviart import energies, stiffness, stiffness_sizes
from holonomy import check_holonomy


class Phase:
    """Lifts of arg u in every triangle."""

    def __init__(self, mesh, field):
        step = field.step.copy()
        turns = np.rint(step.sum(axis=1) / (2.0 * np.pi))
        # Where the three short changes around a triangle do not add up to 0, the largest is
        # replaced by its complement.
        rows = np.flatnonzero(turns)
        longest = np.argmax(step[rows] * turns[rows, None], axis=1)
        step[rows, longest] -= 2.0 * np.pi * turns[rows]
        self.values = np.stack([np.zeros(len(step)), step[:, 0], -step[:, 2]], axis=1)
        self.unclear = turns != 0
        self.residual = stiffness(mesh, self.values)
        self.sizes = stiffness_sizes(mesh)


def relift(mesh, phase, rounding):
    """Adds full turns to single triangles as long as this reduces the residual of the fluxes.

    Several triangles at a corner may have changes above π; only one of all lifts is harmonic.
    """
    inside = mesh.free[mesh.edge]
    changed = set(np.flatnonzero(phase.unclear).tolist())
    for _ in range(50):
        off = np.abs(phase.residual) > rounding * phase.sizes
        suspects = np.flatnonzero((off[mesh.edge] & inside).any(axis=1))
        if len(suspects) > 0.1 * len(mesh.triangles) + 20:
            break  # more than a few corners are wrong
        best = None
        for t in suspects:
            for lift in LIFTS:
                flux = mesh.side[t] @ (lift @ mesh.side[t]) / mesh.area[t]
                before = phase.residual[mesh.edge[t]][inside[t]] / phase.sizes[mesh.edge[t]][inside[t]]
                after = before + flux[inside[t]] / phase.sizes[mesh.edge[t]][inside[t]]
                gain = before @ before - after @ after
                if gain > rounding and (best is None or gain > best[0]):
                    best = gain, t, lift, flux
        if best is None:
            break
        _, t, lift, flux = best
        phase.values[t] += lift
        phase.residual[mesh.edge[t]] += flux
        changed.add(int(t))
    if changed:
        phase.residual = stiffness(mesh, phase.values)
    return len(changed)


LIFTS = [2.0 * np.pi * np.array([0, a, b]) for a in (-1, 0, 1) for b in (-1, 0, 1) if a or b]


def potential_range(energy, mesh):
    """Returns an estimate of the range of the conjugate potential, at least one: g L for a strip
    with the length and the area of the domain, with the energy ½ g² L W. Phases have its rounding,
    which matters in long domains.
    """
    extent = np.ptp(mesh.points, axis=0).max()
    return np.sqrt(max(1.0, 2.0 * energy * extent ** 2 / mesh.area.sum()))


def check_unit_norm(data, mesh, field, report):
    """Checks that the phase is harmonic and the potential closed, and returns ½ ∫ |∇φ|²."""
    rounding = mesh.rounding()
    phase = Phase(mesh, field)
    mended = relift(mesh, phase, rounding)
    if mended:
        report.note("in %d triangles the phase turns by more than half a turn; their neighbours "
                    "tell by how much" % mended)
    # A phase has the magnitude one.
    off = np.abs(phase.residual / phase.sizes)[mesh.free]
    report.bound("phase is harmonic, its potential continuous and constant on holes",
                 off.max(initial=0.0), rounding, "one rounding an edge, relative to the terms")
    check_holonomy(data, mesh, phase.residual, report)
    return energies(mesh, phase.values).sum(), phase
