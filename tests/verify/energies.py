"""Checks the energy and its terms."""
import numpy as np

from crouzeix_raviart import energies, stiffness_sizes
from report import ROUNDING


def check_energy(name, stated, found, mesh, report, size=1.0):
    """Checks the energy. `size` is the largest value of u: the terms of ½ uᴴ K u, which cancel, are
    as large as its square."""
    cancelling = ROUNDING * 0.5 * stiffness_sizes(mesh).sum() * size ** 2
    terms = len(mesh.triangles) * ROUNDING * max(abs(stated), abs(found))
    report.bound(name, abs(found - stated), terms + cancelling, "rounding, once a term of the sum")


def penalty(mesh, field, epsilon, norm=1.0):
    """Returns 1/(4ε²) ∫ (|u|² − f²)² by the midpoint rule on sides, f constant on triangles."""
    f = norm ** 2 * np.ones(len(mesh.triangles))
    mean = ((np.abs(field.in_triangle) ** 2 - f[:, None]) ** 2).mean(axis=1)
    return 0.25 * (mesh.area * mean).sum() / epsilon ** 2


def find_pinning(data, mesh, field):
    """Returns the cell arrays for which both terms of the energy are those of the file, which does
    not name them."""
    count = len(mesh.triangles)
    arrays = {name: pair[0].astype(float) for name, pair in data.cells.items()
              if pair[0].shape == (count,) and name not in ("BoundaryKind", "BoundaryId",
                                                            "QuarterIndex", "CrossNorm")}
    plain = np.ones(count)
    norms, weights = [("", plain)] + list(arrays.items()), [("", plain)] + list(arrays.items())
    near = 1e-9  # to distinguish arrays, not to check the energy
    gradient = energies(mesh, field.in_triangle)
    weight = next((w for w in weights if np.isclose((w[1] * gradient).sum(), data.value("GradientEnergy"),
                                                    rtol=near, atol=0.0)), weights[0])
    norm = next((f for f in norms if np.isclose(penalty(mesh, field, data.value("Epsilon"), f[1]),
                                                data.value("PenaltyEnergy"), rtol=near, atol=0.0)), norms[0])
    return norm, weight


def check_terms(data, mesh, field, norm, weight, report):
    """Checks an energy with a penalty."""
    terms = len(mesh.triangles)
    stated = [data.value(name) for name in ("GradientEnergy", "PenaltyEnergy", "Energy")]
    gradient = (weight * energies(mesh, field.in_triangle)).sum()
    check_energy("GradientEnergy", stated[0], gradient, mesh, report, np.abs(field.u).max())
    found = penalty(mesh, field, data.value("Epsilon"), norm)
    # |u|² − f² loses the digits that both have in common.
    area = (mesh.area * np.maximum(norm, 1.0) ** 4).sum()
    lost = terms * ROUNDING * (found + np.sqrt(found * area) / data.value("Epsilon"))
    report.bound("PenaltyEnergy", abs(found - stated[1]), lost, "one rounding a term of the sum")
    report.bound("Energy is the sum of its terms", abs(stated[2] - stated[0] - stated[1]),
                 4 * ROUNDING * abs(stated[2]), "rounding of a sum")
