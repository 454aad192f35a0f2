"""Stress concentration at a hole in a plate under tension, with CalculiX.

    python3 plate.py [--program CROSSFIELD] [--quads N ...] [--points N] [--straight] [--keep FOLDER]

A quarter of the plate is meshed with quads of order 2 along the circle and written to plate.inp, a step is added
with symmetry, tension and output, and ccx solves it. Prints the number of corner nodes and the largest stress over the
tension, Kt. The hole is half as wide as the plate. Needs the Debian package calculix-ccx.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from calculix import pressure_on, run, working_folder  # noqa: E402

WIDTH, LENGTH, RADIUS = 1.0, 3.0, 0.5  # half of the width and length of the plate
TENSION = 1.0
THICKNESS = 0.01  # CalculiX makes solids of plane elements; thick ones raise Kt by 1 %

STEP = f"""*MATERIAL, NAME=steel
*ELASTIC
210000, 0.3
*SOLID SECTION, ELSET=domain, MATERIAL=steel
{THICKNESS}
*BOUNDARY
bottom, 2, 2
left, 1, 1
*STEP
*STATIC
*DLOAD
{{loads}}
*NODE FILE, OUTPUT=2D
U
*EL FILE, OUTPUT=2D
S
*END STEP
"""


def write_part(path, points):
    """Writes the boundary of a quarter of the plate, with the names of its sides, as a .vtp file."""
    arc = [(RADIUS * math.cos(a), RADIUS * math.sin(a))
           for a in (math.pi / 2 * (1 - i / points) for i in range(points + 1))]
    corners = [(WIDTH, 0.0), (WIDTH, LENGTH), (0.0, LENGTH)]
    places = arc + corners  # clockwise along the hole, then around the plate
    names = ["hole"] * points + ["bottom", "right", "top", "left"]
    lines = " ".join(f"{i} {(i + 1) % len(places)}" for i in range(len(places)))
    letters = " ".join(str(code) for name in names for code in name.encode() + b"\0")
    path.write_text(f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="{len(places)}" NumberOfLines="{len(names)}">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
{" ".join(f"{x!r} {y!r} 0" for x, y in places)}
</DataArray></Points>
<Lines><DataArray type="Int64" Name="connectivity" format="ascii">{lines}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{" ".join(str(2 * i + 2) for i in range(len(names)))}</DataArray></Lines>
<CellData><Array type="String" Name="Side" format="ascii">{letters}</Array></CellData>
</Piece></PolyData></VTKFile>
""")


def solve(program, folder, quads, points, curved):
    """Returns the number of corner nodes of the mesh and Kt."""
    write_part(folder / "part.vtp", points)
    command = [program, "quads", folder / "part.vtp", "-o", folder / "plate.inp", "--quads", str(quads), "--order", "2",
               "--json", folder / "report.json", *(["--curve", "hole:circle"] if curved else [])]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    mesh = (folder / "plate.inp").read_text()
    (folder / "plate.inp").write_text(mesh + STEP.format(loads=pressure_on(mesh, "top", -TENSION)))
    places, _, stresses = run(folder, "plate")
    report = json.loads((folder / "report.json").read_text())
    node = max(stresses, key=lambda node: stresses[node][1])
    place, stress = places[node][:2], stresses[node][1]
    if math.dist(place, (RADIUS, 0.0)) > 1e-3:
        raise SystemExit(f"The largest stress is at {place}, and not at the hole.")
    nodes = report["quads"] + sum(side["edges"] for side in report["sides"]) // 2 + 1  # Euler's formula
    return nodes, stress / TENSION


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="crossfield")
    parser.add_argument("--quads", type=int, nargs="+", default=[240, 1000, 4000])
    parser.add_argument("--points", type=int, default=64, help="segments of the polygon along the quarter of the hole")
    parser.add_argument("--straight", action="store_true", help="use the polygon as it is")
    parser.add_argument("--keep", type=pathlib.Path, help="keep the files in this folder")
    options = parser.parse_args()
    for quads in options.quads:
        with working_folder(options.keep) as folder:
            nodes, factor = solve(options.program, folder, quads, options.points, not options.straight)
        print(f"{nodes} nodes of quads: Kt {factor:.3f}")


if __name__ == "__main__":
    main()
