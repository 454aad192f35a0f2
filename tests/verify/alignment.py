"""Checks the alignment: u = e^{4iτ} on every edge of outer and inner loops, τ the direction of the
edge."""
import numpy as np

from report import ROUNDING


def boundary_values(mesh):
    """Returns e^{4iτ} of the aligned lines, computed as (t / |t|)⁴."""
    tangent = mesh.tangent[mesh.aligned_lines]
    direction = tangent[:, 0] + 1j * tangent[:, 1]
    return (direction / np.abs(direction)) ** 4


def check_alignment(mesh, field, report):
    lines = mesh.aligned_lines
    length = np.linalg.norm(mesh.tangent[lines], axis=1)
    off = np.abs(field.u[mesh.edge_of_line[lines]] - boundary_values(mesh))
    # A position error δ of an end turns an edge of length l by 2δ/l, and u by four times that
    # angle.
    exactness = 8.0 * mesh.frame.exactness / length + 16.0 * ROUNDING
    worst = int(np.argmax(off / exactness))
    report.bound("alignment of outer and inner loops", off[worst], exactness[worst],
                 "rounding of the coordinates over the length of the edge")
