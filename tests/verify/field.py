"""The field in a file, and the check that all arrays agree with it."""
import numpy as np

from report import ROUNDING, Unverifiable, rounding_of


class Field:
    """u at every edge, from `CrossFieldCR` of the triangles; arg u lifted in every triangle."""

    def __init__(self, data, mesh):
        shown = data.cells["CrossFieldCR"][0]
        if shown.shape != (len(mesh.triangles), 6) or not np.all(np.isfinite(shown)):
            raise Unverifiable("CrossFieldCR has no 6 finite components")
        self.in_triangle = shown[:, 0::2] + 1j * shown[:, 1::2]
        self.u = np.zeros(len(mesh.ends), complex)
        self.u[mesh.edge] = self.in_triangle
        after = np.roll(self.in_triangle, -1, axis=1)
        #: Change of arg u from side i to side i + 1 of every triangle, in (−π, π].
        self.step = np.angle(after * self.in_triangle.conj())
        # Values of unit-norm fields are products of a few numbers of norm one. Other fields deviate
        # by far more.
        self.of_unit_norm = bool(np.abs(np.abs(self.u) - 1.0).max() <= 16 * ROUNDING)


def check_arrays(data, mesh, field, report):
    """Checks that each edge has one value, and the values derived from it at cells and points."""
    report.true("both triangles of an edge have its value",
                np.array_equal(field.u[mesh.edge], field.in_triangle))
    lines = data.cells["CrossFieldCR"][1]
    of_line = field.u[mesh.edge_of_line]
    report.true("lines have the value of their edge three times",
                np.all(lines[:, 0::2] + 1j * lines[:, 1::2] == of_line[:, None]))

    count = len(mesh.points)
    sum_of_sides = field.in_triangle.sum(axis=1)
    at_corner = sum_of_sides[:, None] - 2.0 * np.roll(field.in_triangle, -1, axis=1)
    weight = np.repeat(mesh.area[:, None], 3, axis=1)
    index = mesh.triangles.ravel()
    total = np.bincount(index, weight.ravel(), count)
    weighted = (weight * at_corner).ravel()
    at_points = (np.bincount(index, weighted.real, count) +
                 1j * np.bincount(index, weighted.imag, count))
    used = total > 0
    at_points[used] /= total[used]
    largest = np.abs(field.u).max()
    shortest = np.linalg.norm(mesh.side, axis=2).min()
    # The mean at a vertex is a sum over some ten triangles.
    for where, u, shown, sums in (
            ("triangles", sum_of_sides / 3.0, {n: data.cells[n][0] for n in NAMES if n in data.cells}, 8),
            ("lines", of_line, {n: data.cells[n][1] for n in NAMES if n in data.cells}, 0),
            ("points", at_points, {n: data.at_points[n] for n in NAMES if n in data.at_points}, 64)):
        _check_shown(where, u, shown, mesh.frame,
                     sums * (ROUNDING + mesh.frame.exactness / shortest) * largest, report)


NAMES = ("Representation", "Cross", "Cross2", "CrossNorm")

#: Arrays that a file may have, depending on the options of the run.
SETS = ({*NAMES}, {"Cross", "CrossNorm"}, set())


def _check_shown(where, u, shown, frame, exactness, report):
    axes, normal = frame.axes, frame.normal
    if set(shown) not in SETS:
        report.true("%s have the arrays of a choice" % where, False, "they have %s" % sorted(shown))
        return
    if not shown:
        return
    rounding = max(map(rounding_of, shown.values()))
    shown = {name: array.astype(float) for name, array in shown.items()}
    largest = max(1.0, np.abs(u).max(initial=0.0))
    stated_u = u
    if "Representation" in shown:
        stated = shown["Representation"]
        stated_u = stated[:, 0] + 1j * stated[:, 1]
        worst = np.abs(stated_u - u).max(initial=0.0) + np.abs(stated[:, 2]).max(initial=0.0)
        report.bound("Representation of %s" % where, worst, exactness + (rounding - ROUNDING) * largest,
                     "rounding of a mean")
    worst = np.abs(shown["CrossNorm"] - np.abs(stated_u)).max(initial=0.0)
    report.bound("CrossNorm of %s" % where, worst,
                 4 * rounding * largest + (stated_u is u) * exactness, "rounding of a root")
    # Where u is that of the midpoints, its phase is as accurate as u.
    seen = np.abs(stated_u) > (stated_u is u) * exactness / 2.0 ** -20
    size = np.where(seen, np.abs(stated_u), 1.0)
    first = (shown["Cross"] @ axes.T)[:, 0] + 1j * (shown["Cross"] @ axes.T)[:, 1]
    # The axes of a tilted plane are accurate up to the rounding of its points.
    angles = max(2.0 ** -43, 8 * rounding)
    off = np.abs(first ** 4 - stated_u / size)[seen].max(initial=0.0)
    report.bound("Cross of %s: its fourth power is u" % where, off, angles, "rounding of angles and axes")
    if "Cross2" in shown:
        second = (shown["Cross2"] @ axes.T)[:, 0] + 1j * (shown["Cross2"] @ axes.T)[:, 1]
        off = max(np.abs(values).max(initial=0.0) for values in (
            second - 1j * first, np.abs(first) - 1.0, shown["Cross"] @ normal, shown["Cross2"] @ normal))
        report.bound("Cross2 of %s: a unit branch at +90 degrees in the plane" % where, off, angles,
                     "rounding of angles and axes")
    off = np.abs(np.angle(first))[seen].max(initial=0.0) - 0.25 * np.pi
    report.bound("Cross of %s: the branch nearest to the first axis" % where, off, angles,
                 "rounding of angles and axes")
