"""Cases of H and its crosses that are corrupted in one place."""
import numpy as np

from corrupting import of

CONJUGATE = "4∇H is the conjugate of the phase's gradient"
JUMPS = "triangles in which 4∇H is not the conjugate of the phase's gradient"
H_HARMONIC = "H without its logarithms is harmonic at inner vertices"
WHOLE = "logarithms of corners between straight sides are of whole quarters"
ALIGNED = "alignment of outer and inner loops"


@of("h", "SizeMap is e^H", CONJUGATE, H_HARMONIC)
def h_moved_at_a_vertex(file):
    file.point("H")[file.inner_vertex()] += 4e-7


@of("h", "SizeMap is e^H")
def size_changed(file):
    file.point("SizeMap")[7] *= 1.0 + 1e-6


@of("h", "area mean of H")
def h_shifted(file):
    file.point("H")[:] += 1.0
    file.point("SizeMap")[:] = np.exp(file.point("H"))


@of("h", CONJUGATE, H_HARMONIC, WHOLE)
def cross_of_h_rotated(file):
    """Rotates one cross, which moves the fitted singularities."""
    file.u[file.inner_edge()] *= np.exp(1e-6j)
    file.show()


@of("h", "crosses have norm one")
def cross_of_h_stretched(file):
    file.u[file.inner_edge()] *= 1.0 + 1e-12
    file.show()


@of("h", ALIGNED, "GivenInteriorQuarters: the singularities inside",
    "quarter indices of the logarithms: 4 times the Euler characteristic",
    "sum of all indices, corners included: 4 times the Euler characteristic")
def singularity_added_to_h(file):
    """Adds a singularity with its H and crosses: their equations hold, the boundary conditions do
    not."""
    place = file.mesh.points[file.inner_vertex()] + 0.003
    file.point("H")[:] += 0.25 * np.log(np.linalg.norm(file.mesh.points - place, axis=1))
    file.point("SizeMap")[:] = np.exp(file.point("H"))
    arm = file.mesh.midpoint - place
    file.u *= (arm[:, 0] + 1j * arm[:, 1]) / np.linalg.norm(arm, axis=1)
    file.show()


@of("h_on_holes", "H is constant on every hole", CONJUGATE, "SizeMap is e^H", "area mean of H")
def hole_of_h_not_constant(file):
    file.point("H")[file.mesh.lines[file.mesh.of_kind(3)[0].lines[0], 0]] += 1e-5


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
