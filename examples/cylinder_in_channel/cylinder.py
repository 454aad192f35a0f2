"""Flow around a cylinder in a channel with OpenFOAM (Schäfer and Turek, 2D-1).

    python3 cylinder.py [--program CROSSFIELD] [--quads N ...] [--gmsh] [--keep FOLDER]

Meshes channel.dxf with a boundary layer on the cylinder, solves the case with simpleFoam and prints cells, the
largest non-orthogonality, drag and lift. With --gmsh the mesh is that of gmsh.geo. Needs the Debian package
openfoam, and gmsh for --gmsh.
"""
import argparse
import pathlib
import shutil
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from foam_case import run, solve

DRAG, LIFT = 5.57953523384, 0.010618948146  # Nabh (1998), from a spectral method


def mesh(program, case, quads):
    # The layer begins with 1/50 of the diameter; with growth 1.1 it blends into the quads around it.
    first = 2e-3 * (4000 / quads) ** 0.5
    run(program, "quads", HERE / "channel.dxf", "-o", f"{case}/", "--quads", quads, "--layers", f"cylinder:{first},1.1")


def mesh_with_gmsh(case, size):
    run("gmsh", "-3", HERE / "gmsh.geo", "-setnumber", "near", size, "-o", case / "gmsh.msh", "-v", 1)
    run("gmshToFoam", "-case", case, case / "gmsh.msh")
    run("foamDictionary", case / "constant/polyMesh/boundary", "-entry", "entry0/frontAndBack/type", "-set", "empty")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="crossfield")
    parser.add_argument("--quads", type=int, nargs="+", default=[2000, 4000, 8000])
    parser.add_argument("--gmsh", action="store_true", help="use quads of Gmsh")
    parser.add_argument("--keep", type=pathlib.Path, help="keep the last case in this folder")
    options = parser.parse_args()
    for quads in options.quads:
        with tempfile.TemporaryDirectory() as temporary:
            case = options.keep or pathlib.Path(temporary) / "case"
            shutil.rmtree(case, ignore_errors=True)
            shutil.copytree(HERE / "case", case)
            if options.gmsh:
                mesh_with_gmsh(case, 0.005 * (4000 / quads) ** 0.5)
            else:
                mesh(options.program, case, quads)
            cells, angle, drag, lift = solve(case)
        print(f"{cells} cells, non-orthogonality at most {angle:.1f}°: Cd {drag:.4f} ({drag / DRAG - 1:+.2%}), "
              f"Cl {lift:.4f} ({lift - LIFT:+.4f})", flush=True)


if __name__ == "__main__":
    main()
