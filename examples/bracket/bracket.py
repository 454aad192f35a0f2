"""Stress in the fillet of a shelf bracket, with extruded hexahedra in CalculiX.

    python3 bracket.py [--program CROSSFIELD] [--size MM ...] [--keep FOLDER]

Writes the profile of the bracket as bracket.dxf, whose layers are the names of the sides, makes hexahedra of order 2
from it, adds a step with the support and the pressure on the shelf, and runs ccx. Prints the number of nodes, the
largest von Mises stress in the fillet and the deflection of the tip. Lengths in mm, stresses in MPa. Needs the Debian
package calculix-ccx.
"""
import argparse
import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from calculix import equivalent, pressure_on, run, working_folder  # noqa: E402

LEG, THICKNESS, FILLET, DEPTH = 80.0, 12.0, 8.0, 40.0
PRESSURE = 0.5
INNER = THICKNESS + FILLET  # where the fillet begins, and the position of its middle

STEP = """*MATERIAL, NAME=steel
*ELASTIC
210000, 0.3
*SOLID SECTION, ELSET=domain, MATERIAL=steel
*BOUNDARY
wall, 1, 3
*STEP
*STATIC
*DLOAD
{loads}
*NODE FILE
U
*EL FILE
S
*END STEP
"""

# Ends of the lines, and their layers.
LINES = [((0, 0), (LEG, 0), "bottom"), ((LEG, 0), (LEG, THICKNESS), "tip"), ((LEG, THICKNESS), (INNER, THICKNESS), "shelf"),
         ((THICKNESS, INNER), (THICKNESS, LEG), "inside"), ((THICKNESS, LEG), (0, LEG), "top"), ((0, LEG), (0, 0), "wall")]


def write_drawing(path):
    """Writes the profile as a .dxf file."""
    groups = [(0, "SECTION"), (2, "ENTITIES")]
    for (x0, y0), (x1, y1), layer in LINES:
        groups += [(0, "LINE"), (8, layer), (10, x0), (20, y0), (11, x1), (21, y1)]
    groups += [(0, "ARC"), (8, "fillet"), (10, INNER), (20, INNER), (40, FILLET), (50, 180), (51, 270)]
    groups += [(0, "ENDSEC"), (0, "EOF")]
    path.write_text("".join(f"{code}\n{value}\n" for code, value in groups))


def results_of(folder, mesh):
    """Adds the step to a mesh, solves, and returns nodes, the stress in the fillet and the deflection of the tip."""
    (folder / "bracket.inp").write_text(mesh + STEP.format(loads=pressure_on(mesh, "shelf", PRESSURE)))
    places, displacements, stresses = run(folder, "bracket")
    fillet = [equivalent(stresses[node]) for node, (x, y, _) in places.items()
              if x < INNER and y < INNER and abs(math.dist((x, y), (INNER, INNER)) - FILLET) < 1e-3]
    tip = [-displacements[node][1] for node, (x, y, _) in places.items() if x > LEG - 1e-6 and y < 1e-6]
    return len(places), max(fillet), sum(tip) / len(tip)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="crossfield")
    parser.add_argument("--size", type=float, nargs="+", default=[4.0, 3.0, 2.0], help="size of quads in mm")
    parser.add_argument("--keep", type=pathlib.Path, help="keep the files in this folder")
    options = parser.parse_args()
    for size in options.size:
        with working_folder(options.keep) as folder:
            write_drawing(folder / "bracket.dxf")
            layers = round(DEPTH / size / 2)
            subprocess.run([options.program, "quads", folder / "bracket.dxf", "-o", folder / "bracket.inp", "--size", str(size),
                            "--order", "2", "--extrude", f"{DEPTH},{layers}"], check=True, stdout=subprocess.DEVNULL)
            nodes, stress, deflection = results_of(folder, (folder / "bracket.inp").read_text())
        print(f"{nodes} nodes: fillet {stress:.2f} MPa, tip {deflection:.4f} mm")


if __name__ == "__main__":
    main()
