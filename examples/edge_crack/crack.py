"""Stress intensity at an edge crack in a plate under tension, with CalculiX.

    python3 crack.py [--program CROSSFIELD] [--quads N ...] [--keep FOLDER]

The plate is meshed with quads of order 2 along the crack, whose two sides have nodes of their own, and written to
crack.inp; a step is added with tension and output, and ccx solves it. The energy release rate is that of the domain
integral J over rings of quads around the tip. Prints the stress intensity over that of the handbook. Needs the Debian
packages calculix-ccx and python3-numpy.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from calculix import pressure_on, read_mesh, run, working_folder  # noqa: E402

WIDTH, LENGTH, CRACK = 1.0, 1.5, 0.5  # width, half of the length, length of the crack
TENSION, YOUNG, POISSON = 1.0, 210000.0, 0.3
RINGS = (0.2, 0.4)  # radii between which the weight of the integral falls from 1 to 0

STEP = """*MATERIAL, NAME=steel
*ELASTIC
{young}, {poisson}
*SOLID SECTION, ELSET=domain, MATERIAL=steel
1
*BOUNDARY
{tip}, 1, 2
{front}, 2, 2
*STEP
*STATIC
*DLOAD
{loads}
*NODE FILE, OUTPUT=2D
U
*END STEP
"""


def write_part(path):
    """Writes the boundary of the plate and its crack, with names, as a .vtk file."""
    points = [(0, -LENGTH), (WIDTH, -LENGTH), (WIDTH, LENGTH), (0, LENGTH), (0, 0), (CRACK, 0)]
    lines = {"bottom": (0, 1), "right": (1, 2), "top": (2, 3), "left": (3, 0), "crack": (4, 5)}
    rows = ["# vtk DataFile Version 3.0", "plate with a crack", "ASCII", "DATASET POLYDATA", f"POINTS {len(points)} double"]
    rows += [f"{x!r} {y!r} 0" for x, y in points] + [f"LINES {len(lines)} {3 * len(lines)}"]
    rows += [f"2 {a} {b}" for a, b in lines.values()]
    rows += [f"CELL_DATA {len(lines)}", "FIELD names 1", f"Side 1 {len(lines)} string", *lines]
    path.write_text("\n".join(rows) + "\n")


def handbook():
    """Returns the stress intensity of Tada, Paris and Irwin, within 0.5 % for cracks up to 0.6 of the width."""
    a = CRACK / WIDTH
    return TENSION * math.sqrt(math.pi * CRACK) * (1.12 - 0.231 * a + 10.55 * a**2 - 21.72 * a**3 + 30.39 * a**4)


def slopes(x, y):
    """Returns the derivatives by x and y of the eight shape functions of a quad of order 2."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    a, b = corners.T
    along_x = np.concatenate([a * (1 + y * b) * (2 * x * a + y * b) / 4,
                              [-x * (1 - y), (1 - y * y) / 2, -x * (1 + y), -(1 - y * y) / 2]])
    along_y = np.concatenate([b * (1 + x * a) * (2 * y * b + x * a) / 4,
                              [-(1 - x * x) / 2, -y * (1 + x), (1 - x * x) / 2, -y * (1 - x)]])
    return np.array([along_x, along_y])


def energy_release_rate(places, elements, displacements):
    """Returns J = ∫ (σ_ij ∂u_j/∂x − W δ_ix) ∂q/∂x_i, with a weight q of 1 at the tip, in plane strain."""
    shear = YOUNG / 2 / (1 + POISSON)
    bulk = 2 * shear * POISSON / (1 - 2 * POISSON)
    inner, outer = RINGS
    gauss = 1 / math.sqrt(3)
    total = 0.0
    for element in elements:
        position = np.array([places[node][:2] for node in element])
        moved = np.array([displacements[node][:2] for node in element])
        weight = np.clip((outer - np.hypot(position[:, 0] - CRACK, position[:, 1])) / (outer - inner), 0, 1)
        for x, y in ((a, b) for a in (-gauss, gauss) for b in (-gauss, gauss)):
            local = slopes(x, y)
            jacobian = local @ position
            gradients = np.linalg.solve(jacobian, local)
            slope = gradients @ moved  # ∂u_j / ∂x_i
            strain = (slope + slope.T) / 2
            stress = bulk * np.trace(strain) * np.eye(2) + 2 * shear * strain
            energy = (stress * strain).sum() / 2
            falls = gradients @ weight
            total += (falls @ stress @ slope[0] - energy * falls[0]) * np.linalg.det(jacobian)
    return total


def solve(program, folder, quads):
    """Returns the number of quads of the mesh, the number along the crack and the stress intensity."""
    write_part(folder / "part.vtk")
    command = [program, "quads", folder / "part.vtk", "-o", folder / "crack.inp", "--open", "crack", "--quads", str(quads),
               "--order", "2", "--json", folder / "report.json"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    mesh = (folder / "crack.inp").read_text().replace("CPS8", "CPE8")
    places, elements = read_mesh(mesh)

    def nearest(x, y):
        return min(places, key=lambda node: math.dist(places[node][:2], (x, y)))

    loads = "\n".join(pressure_on(mesh, side, -TENSION) for side in ("top", "bottom"))
    (folder / "crack.inp").write_text(mesh + STEP.format(
        young=YOUNG, poisson=POISSON, tip=nearest(CRACK, 0), front=nearest(WIDTH, 0), loads=loads))
    _, displacements, _ = run(folder, "crack")
    rate = energy_release_rate(places, elements, displacements)
    report = json.loads((folder / "report.json").read_text())
    along = next(side["edges"] for side in report["sides"] if side["name"] == "crack.left")
    return report["quads"], along, math.sqrt(rate * YOUNG / (1 - POISSON**2))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="crossfield")
    parser.add_argument("--quads", type=int, nargs="+", default=[300, 1200, 4800])
    parser.add_argument("--keep", type=pathlib.Path, help="keep the files in this folder")
    options = parser.parse_args()
    for quads in options.quads:
        with working_folder(options.keep) as folder:
            found, along, intensity = solve(options.program, folder, quads)
        print(f"{found} quads, {along} along the crack: K over the handbook's {intensity / handbook():.4f}")


if __name__ == "__main__":
    main()
