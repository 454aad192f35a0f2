"""Fields of norm one: the phase is discretely harmonic, and so is its conjugate potential.

∇φ = rot ∇Φ with a continuous P1 function Φ that is constant on every hole exactly if the flux of ∇φ is
continuous across every inner edge and zero through every edge of a hole: if (K φ)_e = 0 there.
"""
import numpy as np

from crouzeix_raviart import energies, stiffness, stiffness_sizes
from holonomy import check_holonomy


class Phase:
    """Lifts of arg u in every triangle."""

    def __init__(self, mesh, field):
        step = field.step.copy()
        turns = np.rint(step.sum(axis=1) / (2.0 * np.pi))
        # Where the short ways around a triangle do not close, the longest of them was the long way.
        rows = np.flatnonzero(turns)
        longest = np.argmax(step[rows] * turns[rows, None], axis=1)
        step[rows, longest] -= 2.0 * np.pi * turns[rows]
        self.values = np.stack([np.zeros(len(step)), step[:, 0], -step[:, 2]], axis=1)
        self.unclear = turns != 0
        self.residual = stiffness(mesh, self.values)
        self.sizes = stiffness_sizes(mesh)


def relift(mesh, phase, rounding):
    """Whole turns are added to single triangles as long as that makes fluxes fit better.

    The long way around a corner may be that of several triangles; of all lifts only one is harmonic.
    """
    inside = mesh.free[mesh.edge]
    changed = set(np.flatnonzero(phase.unclear).tolist())
    for _ in range(50):
        off = np.abs(phase.residual) > rounding * phase.sizes
        suspects = np.flatnonzero((off[mesh.edge] & inside).any(axis=1))
        if len(suspects) > 0.1 * len(mesh.triangles) + 20:
            break  # that is no matter of a few corners
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
    """How far the conjugate potential ranges, about: in a strip as long as the domain and of its area, g L with the energy
    ½ g² L W; at least one. Phases are rounded as it is, which tells in long domains.
    """
    extent = np.ptp(mesh.points, axis=0).max()
    return np.sqrt(max(1.0, 2.0 * energy * extent ** 2 / mesh.area.sum()))


def check_unit_norm(data, mesh, field, report):
    """Harmonic phase, closed potential; gives ½ ∫ |∇φ|²."""
    rounding = mesh.rounding()
    phase = Phase(mesh, field)
    mended = relift(mesh, phase, rounding)
    if mended:
        report.note("in %d triangles the phase turns by more than half a turn; their neighbours "
                    "tell by how much" % mended)
    # A phase is a number of size one.
    off = np.abs(phase.residual / phase.sizes)[mesh.free]
    report.bound("phase is harmonic, its potential continuous and constant on holes",
                 off.max(initial=0.0), rounding, "one rounding an edge, relative to the terms")
    check_holonomy(data, mesh, phase.residual, report)
    return energies(mesh, phase.values).sum(), phase
