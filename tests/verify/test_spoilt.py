"""The verifier finds what is wrong: good files pass, and of each that is spoilt it names just that.

    python3 test_spoilt.py PROGRAM CASE

CASE is one of the functions below, `good_files` or `every_check_can_fail`.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from spoiling import Spoiled
from verify import verify

FOUR = "x,y,quarter_index,radius\n0.42,0.42,1,0.1\n-0.42,0.42,1,0.1\n-0.42,-0.42,1,0.1\n0.42,-0.42,1,0.1\n"
FIVE = "x,y,quarter_index,radius\n0.6,0,1,0.1\n0.18,0.57,1,0.1\n-0.49,0.35,1,0.1\n-0.49,-0.35,1,0.1\n0.18,-0.57,1,0.1\n"
PAIR = "x,y,quarter_index,radius\n0.7,0,1,0.05\n-0.7,0,-1,0.05\n"
ELBOW = "x,y,quarter_index\n0.3,0.3,1\n0.7,0.2,-1\n"

# By name: subcommand, domain, singularities, options.
GOOD = {
    "drilled": ("drill", "builtin:disk", FOUR, "--size 0.1"),
    "imprinted": ("solve", "builtin:disk", FOUR, "--mode imprint --size 0.1"),
    "constrained": ("solve", "builtin:disk", FOUR, "--size 0.1"),
    "unit_holes": ("solve", "builtin:disk", FOUR, "--unit-holes --size 0.1"),
    "by_sum": ("solve", "builtin:disk", FOUR, "--global-constraint --size 0.1"),
    "penalty": ("solve", "builtin:disk", FIVE, "--epsilon 0.1 --size 0.1"),
    "unit_norm": ("solve", "builtin:disk", FOUR, "--method unit-norm --size 0.1"),
    "ring": ("solve", "builtin:ring", PAIR, "--method unit-norm --size 0.1"),
    "reference": ("solve", "builtin:disk", None, "--method ginzburg-landau --epsilon 0.2 --size 0.15"),
    "h": ("hfield", "builtin:l-shape", ELBOW, ""),
    "h_on_holes": ("hfield", "drilled.vtu", None, ""),
    "h_of_ring": ("hfield", "builtin:ring", PAIR, "--size 0.1"),
}
CASES = {}


def of(base, *names):
    """A case: the good file that it spoils, and the checks that have to fail, and no others."""
    def register(function):
        CASES[function.__name__] = (base, function, set(names))
        return function
    return register


HARMONIC = "harmonic at every edge off the loops"
KKT = "Karush-Kuhn-Tucker residual"
PHASE = "phase is harmonic, its potential continuous and constant on holes"
CONJUGATE = "4∇H is the conjugate of the phase's gradient"
JUMPS = "triangles in which 4∇H is not the conjugate of the phase's gradient"
H_HARMONIC = "H without its logarithms is harmonic at inner vertices"
WHOLE = "logarithms of corners between straight sides are of whole quarters"
ALIGNED = "alignment of outer and inner loops"


@of("constrained", ALIGNED, HARMONIC, KKT)
def boundary_cross_rotated(file):
    file.u[file.edges_of(1)[5]] *= np.exp(1e-6j)
    file.show(energy=True)


@of("constrained", HARMONIC, KKT)
def off_stationarity(file):
    file.u[file.inner_edge()] += 1e-7
    file.show(energy=True)


@of("constrained", "degree constraint of every hole", HARMONIC, KKT, "norms on holes and circles")
def hole_stretched(file):
    file.u[file.edges_of(3)] *= 1.0 + 1e-6
    file.show(energy=True)


@of("constrained", KKT, HARMONIC, "norms on holes and circles")
def hole_off_stationarity(file):
    """Along the constraint: the values on a hole turned against each other."""
    edges = file.edges_of(3)
    u = file.u[edges]
    push = 1j * u * np.cos(2.0 * np.pi * np.arange(len(u)) / len(u)) * 1e-5
    gradient = 1j * (np.roll(u, 1) - np.roll(u, -1))
    target = (u.conj() * np.roll(u, -1)).imag.sum()
    for _ in range(4):
        moved = u + push
        missing = target - (moved.conj() * np.roll(moved, -1)).imag.sum()
        push = push + missing * gradient / (np.abs(gradient) ** 2).sum()
    file.u[edges] = u + push
    file.show(energy=True)


@of("constrained", "Energy")
def energy_changed(file):
    file.report("Energy")[0] *= 1.0 + 1e-10


@of("unit_norm", "Energy")
def energy_of_unit_norm_changed(file):
    file.report("Energy")[0] *= 1.0 + 1e-10


@of("penalty", "GradientEnergy", "Energy is the sum of its terms")
def gradient_energy_changed(file):
    file.report("GradientEnergy")[0] *= 1.0 + 1e-10


@of("penalty", "PenaltyEnergy")
def penalty_energy_changed(file):
    file.report("PenaltyEnergy")[0] += 1e-8
    file.report("Energy")[0] += 1e-8


@of("constrained", "degrees of holes and circles")
def hole_degree_flipped(file):
    file.report("HoleDegree")[2] = -1


@of("imprinted", "degrees of holes and circles")
def circle_degree_flipped(file):
    file.report("HoleDegree")[2] = 0


@of("constrained", "norms on holes and circles")
def hole_norm_changed(file):
    file.report("HoleNormRange")[1, 1] += 1e-9


@of("constrained", "rows of HoleNormRange", "degrees of holes and circles")
def hole_dropped_from_the_report(file):
    file.report("HoleDegree")  # there is one
    for name in ("HoleDegree", "HoleNormRange"):
        array = file.grid.GetFieldData().GetArray(name)
        array.SetNumberOfTuples(array.GetNumberOfTuples() - 1)


@of("constrained", "GivenInteriorQuarters", "DegreesReached", "degree constraint of every hole")
def prescribed_index_flipped(file):
    row = file.cell("QuarterIndex")
    lines = file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]
    row[lines] = -1


@of("constrained", "DegreesReached")
def degrees_reached_denied(file):
    file.report("DegreesReached")[0] = 0


@of("penalty", "UnwantedSingularities")
def singularity_dropped_from_the_report(file):
    file.report("UnwantedSingularities")[0] -= 1


@of("reference", "GivenInteriorQuarters", "Consistent")
def singularity_dropped_from_the_reference(file):
    file.report("GivenInteriorQuarters")[0] -= 1


@of("reference", "UnwantedSingularities")
def singularity_invented(file):
    file.report("UnwantedSingularities")[0] += 2


@of("unit_norm", "UnwantedSingularities")
def singularity_invented_in_unit_norm(file):
    file.report("UnwantedSingularities")[0] += 1


@of("constrained", "EulerCharacteristic")
def euler_characteristic_changed(file):
    file.report("EulerCharacteristic")[0] = 0


@of("constrained", "Valence")
def valence_changed(file):
    file.report("Valence")[0] += 1e-9


@of("constrained", "TangentTurning")
def tangent_turning_changed(file):
    file.report("TangentTurning")[0] += 1e-9


@of("constrained", "RequiredInteriorQuarters", "Consistent")
def required_sum_changed(file):
    file.report("RequiredInteriorQuarters")[0] += 1


@of("constrained", "GivenInteriorQuarters", "Consistent")
def given_sum_changed(file):
    file.report("GivenInteriorQuarters")[0] -= 1


@of("constrained", "Consistent")
def consistency_denied(file):
    file.report("Consistent")[0] = 0


@of("constrained", "Converged only with a small residual", "Cross2 of lines: a unit branch at +90 degrees in the plane")
def residual_admitted_but_converged(file):
    file.report("Residual")[0] = 1e-3
    file.cell("Cross2")[file.lines[3]] *= -1.0


@of("constrained", "not converged, as the file states")
def convergence_denied(file):
    file.report("Converged")[0] = 0
    file.report("Residual")[0] = 1e-3


@of("reference", "Residual", "Ginzburg-Landau equation")
def reference_off_stationarity(file):
    """The energies are left as they are: to first order they do not change."""
    file.u[file.inner_edge()] += 2e-11
    file.show()


@of("unit_holes", "UnitHoles: some hole has unit crosses that turn evenly", "degree constraint of every hole",
    "norms on holes and circles", KKT, HARMONIC)
def unit_holes_stretched(file):
    for hole in range(4):
        file.u[file.edges_of(3, hole)] *= 1.0 + 1e-6
    file.show(energy=True)


@of("by_sum", "degree constraint of every hole", KKT, HARMONIC, "norms on holes and circles")
def sum_of_constraints_broken(file):
    file.u[file.edges_of(3)] *= 1.0 + 1e-6
    file.show(energy=True)


@of("unit_norm", PHASE)
def phase_off_harmonic(file):
    file.u[file.inner_edge()] *= np.exp(1e-7j)
    file.show()


@of("ring", "HolonomyDefect")
def holonomy_defect_changed(file):
    file.report("HolonomyDefect")[:] += 1e-7


@of("ring", "holonomy defects, one for an inner loop")
def holonomy_dropped(file):
    file.grid.GetFieldData().GetArray("HolonomyDefect").SetNumberOfTuples(0)


@of("h", "SizeMap is e^H", CONJUGATE, H_HARMONIC)
def h_moved_at_a_vertex(file):
    file.point("H")[file.inner_vertex()] += 1e-7


@of("h", "SizeMap is e^H")
def size_changed(file):
    file.point("SizeMap")[7] *= 1.0 + 1e-9


@of("h", "area mean of H")
def h_shifted(file):
    file.point("H")[:] += 1.0
    file.point("SizeMap")[:] *= np.e


@of("h", CONJUGATE, H_HARMONIC, WHOLE)
def cross_of_h_rotated(file):
    """One is enough to move the singularities that are fitted to all."""
    file.u[file.inner_edge()] *= np.exp(1e-6j)
    file.show()


@of("h", "crosses have norm one")
def cross_of_h_stretched(file):
    file.u[file.inner_edge()] *= 1.0 + 1e-12
    file.show()


@of("h", ALIGNED, "GivenInteriorQuarters: the singularities inside",
    "quarter indices of the logarithms, corners included: 4 times the Euler characteristic",
    "sum of all indices, corners included: 4 times the Euler characteristic")
def singularity_added_to_h(file):
    """With H and crosses that belong to it: their equations hold, the boundary does not."""
    place = file.mesh.points[file.inner_vertex()] + 0.003
    file.point("H")[:] += 0.25 * np.log(np.linalg.norm(file.mesh.points - place, axis=1))
    file.point("SizeMap")[:] = np.exp(file.point("H"))
    arm = file.mesh.midpoint - place
    file.u *= (arm[:, 0] + 1j * arm[:, 1]) / np.linalg.norm(arm, axis=1)
    file.show()


@of("h_on_holes", "H is constant on every hole", CONJUGATE, "SizeMap is e^H", "area mean of H")
def hole_of_h_not_constant(file):
    file.point("H")[file.mesh.lines[file.mesh.of_kind(3)[0].lines[0], 0]] += 1e-7


@of("h_of_ring", JUMPS)
def noise_in_h_of_ring(file):
    file.point("H")[:] += 1e-7 * np.sin(12.9898 * np.arange(len(file.mesh.points)))
    file.point("SizeMap")[:] = np.exp(file.point("H"))


@of("h", "GivenInteriorQuarters: the singularities inside", "Consistent")
def singularity_of_h_dropped(file):
    file.report("GivenInteriorQuarters")[0] -= 1


@of("h", "H is finite", "SizeMap is e^H", "area mean of H")
def h_not_finite(file):
    file.point("H")[file.inner_vertex()] = np.nan


@of("constrained", "both triangles of an edge have its value", "Representation of triangles")
def triangles_disagree(file):
    inside = np.flatnonzero(file.mesh.sides_of_edge[file.mesh.edge].min(axis=1) == 2)
    file.cell("CrossFieldCR")[inside[9], 0] += 1e-12


@of("constrained", "lines have the value of their edge three times")
def line_disagrees(file):
    file.cell("CrossFieldCR")[file.lines[4], 2] += 1e-12


@of("constrained", "Representation of triangles", "Cross of triangles: its fourth power is u")
def representation_of_a_triangle(file):
    file.cell("Representation")[11, 1] += 1e-9
    file.cell("CrossNorm")[11] = np.hypot(*file.cell("Representation")[11, :2])


@of("constrained", "Representation of lines", "CrossNorm of lines")
def representation_of_a_line(file):
    file.cell("Representation")[file.lines[4], :2] *= 1.0 + 1e-9


@of("constrained", "Representation of points", "CrossNorm of points")
def representation_of_a_point(file):
    file.point("Representation")[40, :2] *= 1.0 + 1e-9


@of("constrained", "CrossNorm of triangles")
def norm_of_a_triangle(file):
    file.cell("CrossNorm")[11] += 1e-12


@of("constrained", "Cross of lines: its fourth power is u", "Cross2 of lines: a unit branch at +90 degrees in the plane")
def cross_of_a_line_rotated(file):
    row = file.lines[4]
    x, y, _ = file.cell("Cross")[row]
    file.cell("Cross")[row] = (x - 1e-7 * y, y + 1e-7 * x, 0.0)


@of("constrained", "Cross of points: its fourth power is u", "Cross2 of points: a unit branch at +90 degrees in the plane")
def cross_of_a_point_rotated(file):
    x, y, _ = file.point("Cross")[40]
    file.point("Cross")[40] = (x - 1e-7 * y, y + 1e-7 * x, 0.0)


@of("constrained", "Cross of triangles: the branch nearest to the first axis")
def other_branch_of_a_triangle(file):
    first, second = file.cell("Cross"), file.cell("Cross2")
    first[11], second[11] = second[11].copy(), -first[11]


@of("constrained", "Cross of lines: the branch nearest to the first axis",
    "Cross of points: the branch nearest to the first axis")
def other_branches(file):
    for first, second, row in ((file.cell("Cross"), file.cell("Cross2"), file.lines[2]),
                               (file.point("Cross"), file.point("Cross2"), 30)):
        first[row], second[row] = second[row].copy(), -first[row]


@of("constrained", "Cross2 of triangles: a unit branch at +90 degrees in the plane")
def clockwise_branch(file):
    file.cell("Cross2")[11] *= -1.0


@of("constrained", "triangles have all four arrays of a field", "lines have all four arrays of a field")
def array_missing(file):
    file.remove(file.grid.GetCellData(), "Cross2")


@of("constrained", "points have all four arrays of a field")
def array_of_points_missing(file):
    file.remove(file.grid.GetPointData(), "CrossNorm")


@of("drilled", "points lie in a plane")
def point_off_the_plane(file):
    file.points[file.inner_vertex(), 2] += 1e-3


@of("drilled", "holes and circles are regular polygons")
def hole_dented(file):
    start = file.mesh.lines[file.mesh.of_kind(3)[0].lines[0], 0]
    file.points[start] *= 1.0 + 1e-9


@of("drilled", "triangles are counter-clockwise", "triangles agree in their orientation", "triangles fill the loops")
def triangle_turned(file):
    inside = np.flatnonzero(file.mesh.sides_of_edge[file.mesh.edge].min(axis=1) == 2)[3]
    file.corners[3 * inside:3 * inside + 2] = file.corners[3 * inside:3 * inside + 2][::-1].copy()


@of("drilled", "boundary cells of triangles are unset")
def triangle_called_boundary(file):
    file.cell("BoundaryKind")[5] = 1


@of("drilled", "one quarter index a loop, 0 on outer and inner ones")
def line_of_another_index(file):
    file.cell("QuarterIndex")[file.lines[(file.mesh.kind == 3)][1]] = 3


@of("drilled", "outer loops", "the outer loop runs counter-clockwise, all others clockwise",
    "numbers of outer and inner loops")
def hole_called_outer_loop(file):
    lines = file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]
    file.cell("BoundaryKind")[lines] = 1
    file.cell("QuarterIndex")[lines] = 0


@of("drilled", "lines have the domain on their left",
    "the outer loop runs counter-clockwise, all others clockwise", "triangles fill the loops")
def loop_turned(file):
    for line in file.mesh.of_kind(3)[0].lines:
        start = len(file.mesh.triangles) * 3 + 2 * line
        file.corners[start:start + 2] = file.corners[start:start + 2][::-1].copy()


@of("drilled", "no edge has more than two triangles",
    "every boundary edge has one line, and no other has", "triangles fill the loops")
def triangle_doubled(file):
    inside = np.flatnonzero(file.mesh.sides_of_edge[file.mesh.edge].min(axis=1) == 2)
    file.corners[3 * inside[3]:3 * inside[3] + 3] = file.mesh.triangles[inside[40]]


@of("drilled", "cells are triangles and lines", "Euler characteristic of a connected mesh in its loops",
    "every boundary edge has one line, and no other has", "triangles fill the loops")
def triangle_called_polygon(file):
    vtk_to_numpy(file.grid.GetCellTypesArray())[len(file.mesh.triangles) // 2] = 7


@of("drilled", "the file makes sense")
def line_turned(file):
    first = len(file.mesh.triangles) * 3
    file.corners[first:first + 2] = file.corners[first:first + 2][::-1].copy()


@of("drilled", "kinds of lines are 1 to 4", "every boundary edge has one line, and no other has",
    "imprinted circles lie inside", "Euler characteristic of a connected mesh in its loops")
def hole_of_no_kind(file):
    file.cell("BoundaryKind")[file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]] = 7


@of("drilled", "rows of singularities are unlike")
def hole_without_a_row(file):
    file.cell("BoundaryId")[file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]] = -1


@of("drilled", "loops have enough edges for their quarter index")
def index_that_no_polygon_holds(file):
    file.cell("QuarterIndex")[file.lines[(file.mesh.kind == 3) & (file.mesh.number == 1)]] = 16


def make(name, folder):
    """A good file, computed by the program."""
    subcommand, domain, rows, options = GOOD[name]
    if domain == "drilled.vtu":
        make("drilled", folder)
    command = [PROGRAM, subcommand, domain, "-o", name + ".vtu", *options.split()]
    if rows is not None:
        (folder / "rows.csv").write_text(rows)
        command += ["-s", "rows.csv"]
    subprocess.run(command, cwd=folder, check=True, timeout=60, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    return folder / (name + ".vtu")


def good_files(folder):
    for name in GOOD:
        report = verify(make(name, folder))
        if report.failures() or not report.checks:
            sys.exit(report.text(everything=False))


def every_check_can_fail(folder):
    made = {check[0] for name in GOOD for check in verify(make(name, folder)).checks}
    spoilt = set().union(*(names for _, _, names in CASES.values()))
    if made - spoilt:
        sys.exit("No case spoils what these checks look at: %s" % sorted(made - spoilt))


def run(case, folder):
    base, spoil, expected = CASES[case]
    file = Spoiled(make(base, folder))
    spoil(file)
    file.write(folder / "spoilt.vtu")
    report = verify(folder / "spoilt.vtu")
    named = {check[0] for check in report.failures()}
    if named != expected:
        sys.exit("Named without need: %s\nNot named: %s\n%s" % (
            sorted(named - expected), sorted(expected - named), report.text()))


if __name__ == "__main__":
    PROGRAM, wanted = sys.argv[1:]
    with tempfile.TemporaryDirectory(prefix="crossfield-") as place:
        if wanted in CASES:
            run(wanted, pathlib.Path(place))
        else:
            {"good_files": good_files, "every_check_can_fail": every_check_can_fail}[wanted](pathlib.Path(place))
