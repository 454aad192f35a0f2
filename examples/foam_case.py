"""Runs programs of OpenFOAM for the examples."""
import os
import re
import subprocess


def run(*command):
    """Runs a program in silence and returns what it printed."""
    environment = {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ}  # Debian's package does not set it
    return subprocess.run(list(map(str, command)), check=True, stdout=subprocess.PIPE, text=True, env=environment).stdout


def solve(case):
    """Checks the mesh of a case, runs simpleFoam and returns cells, largest non-orthogonality in degrees, drag and lift."""
    check = run("checkMesh", "-case", case)
    if "Mesh OK." not in check:
        raise SystemExit("checkMesh found errors:\n" + check)
    if "solution converged" not in run("simpleFoam", "-case", case):
        raise SystemExit("simpleFoam did not converge.")
    [forces] = case.glob("postProcessing/forces/0/*.dat")
    drag, _, lift = map(float, forces.read_text().splitlines()[-1].split()[1:4])
    return (int(re.search(r"cells: +(\d+)", check)[1]), float(re.search(r"non-orthogonality Max: (\S+)", check)[1]),
            drag, lift)
