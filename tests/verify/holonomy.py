"""Checks the holonomy defects of a unit-norm field (docs/method.md §7) against the field itself.

Let w_k be harmonic with the value 1 on inner loop k and 0 on the other aligned loops. The phase is
that of a single-valued potential plus Σ c_k w_k, where c_k balances the defect of loop k. The flux
of a single-valued potential's phase through every loop is 0. Therefore c follows from the fluxes of
the phase and of the w_k. Each c_k is determined up to full turns.
"""
import numpy as np

from crouzeix_raviart import stiffness
from topology import INNER

TOLERANCE = 1e-12  # relative tolerance of the iteration


def loop_functions(mesh):
    """Returns w_k at all edges, by conjugate gradients with diagonal preconditioning."""
    side = (mesh.side ** 2).sum(axis=2) / mesh.area[:, None]
    diagonal = np.bincount(mesh.edge.ravel(), side.ravel(), len(mesh.ends))
    found = []
    for loop in mesh.of_kind(INNER):
        w = np.zeros(len(mesh.ends))
        w[mesh.edge_of_line[loop.lines]] = 1.0
        left = np.where(mesh.free, -stiffness(mesh, w[mesh.edge]), 0.0)
        scaled = left / diagonal
        direction, product, start = scaled.copy(), left @ scaled, left @ scaled
        while product > TOLERANCE ** 2 * start:
            image = np.where(mesh.free, stiffness(mesh, direction[mesh.edge]), 0.0)
            length = product / (direction @ image)
            w += length * direction
            left -= length * image
            scaled = left / diagonal
            product, before = left @ scaled, product
            direction = scaled + product / before * direction
        found.append(w)
    return found


def check_holonomy(data, mesh, forces, report):
    """Checks the defects. `forces` is K φ at all edges: on the boundary, the flux of ∇φ through the
    edge."""
    loops = mesh.of_kind(INNER)
    stated = data.field.get("HolonomyDefect", np.zeros(0)).ravel()
    report.equal("holonomy defects, one for an inner loop", len(stated), len(loops))
    if not loops or len(stated) != len(loops):
        return

    def fluxes(values):
        return np.array([values[mesh.edge_of_line[loop.lines]].sum() for loop in loops])

    matrix = np.array([fluxes(stiffness(mesh, w[mesh.edge])) for w in loop_functions(mesh)]).T
    missing = np.linalg.solve(matrix, fluxes(forces)) + stated
    off = np.abs(np.remainder(missing + np.pi, 2.0 * np.pi) - np.pi).max()
    report.bound("HolonomyDefect", off, TOLERANCE * len(mesh.ends),
                 "of the verifier's own iteration, times the condition number")
