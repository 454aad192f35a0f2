"""Drag of a NACA 0012 profile at zero incidence in laminar flow, with OpenFOAM.

    python3 naca.py [--program CROSSFIELD] [--quads N ...] [--reynolds RE ...] [--keep FOLDER]
    python3 naca.py --drawing FILE.dxf

Writes the profile in a far field as a drawing, meshes it with a C-grid and a boundary layer, solves the case with simpleFoam and
prints cells and drag, or writes the drawing alone. Needs the Debian package openfoam.
"""
import argparse
import math
import pathlib
import shutil
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from foam_case import run, solve

DISTANCE = 10.0  # of the far field, in chords
PUBLISHED = {1000: 0.12, 5000: 0.055}  # README.md


def height(x):
    """Returns half of the thickness of the profile, whose trailing edge is sharp."""
    return 0.6 * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)


def write_drawing(path):
    """Writes the profile, with the chord from (0, 0) to (1, 0), and the far field as a .dxf file with layers."""
    xs = [(1 + math.cos(math.pi * i / 100)) / 2 for i in range(101)]
    points = [(1.0, 0.0)] + [(x, height(x)) for x in xs[1:]] + [(x, -height(x)) for x in xs[-2:0:-1]]
    r = DISTANCE
    entities = [("LWPOLYLINE", "profile", [(90, len(points)), (70, 1)] + [(code, value) for point in points
                                                                          for code, value in zip((10, 20), point)]),
                ("ARC", "farfield", [(10, 0.0), (20, 0.0), (40, r), (50, 90.0), (51, 270.0)]),
                ("LINE", "farfield", [(10, 0.0), (20, -r), (11, r), (21, -r)]),
                ("LINE", "outlet", [(10, r), (20, -r), (11, r), (21, r)]),
                ("LINE", "farfield", [(10, r), (20, r), (11, 0.0), (21, r)])]
    pairs = [(0, "SECTION"), (2, "ENTITIES")]
    for kind, layer, values in entities:
        pairs += [(0, kind), (8, layer), *values]
    path.write_text("".join(f"{code}\n{value}\n" for code, value in [*pairs, (0, "ENDSEC"), (0, "EOF")]))


def mesh(program, case, quads):
    scale = (11000 / quads) ** 0.5
    write_drawing(case / "profile.dxf")
    run(program, "quads", case / "profile.dxf", "-o", f"{case}/", "--quads", quads, "--sizing", "conformal",
        "--curve", "profile:spline", "--layers", f"profile:{1e-3 * scale}", "--count", f"profile:{2 * round(50 / scale)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="crossfield")
    parser.add_argument("--quads", type=int, nargs="+", default=[5000])
    parser.add_argument("--reynolds", type=int, nargs="+", default=[1000, 5000])
    parser.add_argument("--keep", type=pathlib.Path, help="keep the last case in this folder")
    parser.add_argument("--drawing", type=pathlib.Path, help="write the drawing to this file, and nothing else")
    options = parser.parse_args()
    if options.drawing:
        write_drawing(options.drawing)
        return
    for quads in options.quads:
        for reynolds in options.reynolds:
            with tempfile.TemporaryDirectory() as temporary:
                case = options.keep or pathlib.Path(temporary) / "case"
                shutil.rmtree(case, ignore_errors=True)
                shutil.copytree(HERE / "case", case)
                viscosity = case / "constant/transportProperties"
                viscosity.write_text(viscosity.read_text().replace("0.001;", f"{1 / reynolds};"))
                mesh(options.program, case, quads)
                cells, angle, drag, _ = solve(case)
            published = f" ({drag / PUBLISHED[reynolds] - 1:+.1%})" if reynolds in PUBLISHED else ""
            print(f"Re {reynolds}, {cells} cells, non-orthogonality at most {angle:.1f}°: Cd {drag:.4f}{published}", flush=True)


if __name__ == "__main__":
    main()
