"""Cases of fields and reports that are corrupted in one place."""
import numpy as np

from corrupting import of

HARMONIC = "harmonic at every edge off the loops"
KKT = "Karush-Kuhn-Tucker residual"
PHASE = "phase is harmonic, its potential continuous and constant on holes"
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
    """Moves the values on a hole along the constraint: turns them against each other."""
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
    file.report("HoleDegree")  # it exists
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


@of("constrained", "Converged only with a small residual",
    "Cross2 of lines: a unit branch at +90 degrees in the plane")
def residual_admitted_but_converged(file):
    file.report("Residual")[0] = 1e-3
    file.cell("Cross2")[file.lines[3]] *= -1.0


@of("constrained", "not converged, as the file states")
def convergence_denied(file):
    file.report("Converged")[0] = 0
    file.report("Residual")[0] = 1e-3


@of("reference", "Residual", "Ginzburg-Landau equation")
def reference_off_stationarity(file):
    """Leaves the energies unchanged, since they change to second order only."""
    file.u[file.inner_edge()] += 2e-11
    file.show()


@of("unit_holes", "UnitHoles: some hole has unit crosses that turn evenly",
    "degree constraint of every hole", "norms on holes and circles", KKT, HARMONIC)
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
