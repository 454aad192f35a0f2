"""Crouzeix-Raviart functions: linear in every triangle, one value at the midpoint of every side.

With s_i the vector along side i of a counter-clockwise triangle of area A, the basis function of
that side has the gradient rot⁻¹ s_i |s_i| / |s_i| / A = (s_iy, −s_ix) / A. For the values w_i this
gives

    ∇w = rot⁻¹ Σ w_i s_i / A,   ½ ∫ |∇w|² = ½ |Σ w_i s_i|² / A,   (K w)_e = Σ s_e · (Σ w_i s_i) / A,

the last sum over the triangles of the edge e.
"""
import numpy as np


def moment(mesh, values):
    """Returns Σ w_i s_i for values (triangles, 3): one vector per triangle."""
    return np.einsum("ti,tic->tc", values, mesh.side)


def gradient(mesh, values):
    vector = moment(mesh, values) / mesh.area[:, None]
    return np.stack([vector[:, 1], -vector[:, 0]], axis=1)


def energies(mesh, values):
    """Returns ½ ∫ |∇w|² on every triangle; values are real or complex."""
    vector = moment(mesh, values)
    return 0.5 * (np.abs(vector) ** 2).sum(axis=1) / mesh.area


def by_edge(mesh, contributions):
    """Sums contributions (triangles, 3) over the triangles of every edge."""
    index, count = mesh.edge.ravel(), len(mesh.ends)
    if np.iscomplexobj(contributions):
        return (np.bincount(index, contributions.real.ravel(), count) +
                1j * np.bincount(index, contributions.imag.ravel(), count))
    return np.bincount(index, contributions.ravel(), count)


def stiffness(mesh, values, weight=1.0):
    """Returns K w at every edge."""
    vector = (weight / mesh.area)[:, None] * moment(mesh, values)
    return by_edge(mesh, np.einsum("tic,tc->ti", mesh.side, vector))


def stiffness_sizes(mesh, weight=1.0):
    """Returns Σ |K_ef| over f at every edge: the largest effect of errors of size one in w on (K
    w)_e."""
    length = np.linalg.norm(mesh.side, axis=2)
    return by_edge(mesh, length * (weight * length.sum(axis=1) / mesh.area)[:, None])


def masses(mesh):
    """Returns ∫ of the basis functions: a third of the area of the triangles of every edge."""
    return by_edge(mesh, np.repeat(mesh.area[:, None] / 3.0, 3, axis=1))
