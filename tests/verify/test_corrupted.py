"""Tests of the verifier: correct files pass, and for a corrupted file exactly the expected checks
fail.

    python3 test_corrupted.py PROGRAM CASES

CASES is a file corrupted_*.py, without .py, one of its functions, `good_files`, `good_files_of_every_size` or
`every_check_can_fail`.
"""
import pathlib
import subprocess
import sys
import tempfile

import corrupted_fields  # noqa: F401, registers its cases
import corrupted_h  # noqa: F401
import corrupted_maps  # noqa: F401
import corrupted_meshes  # noqa: F401
import corrupted_quads  # noqa: F401
from corrupting import CASES, CorruptedFile
from verify import verify

HEADER = "x,y,quarter_index,radius"
FOUR = [HEADER, "0.42,0.42,1,0.1", "-0.42,0.42,1,0.1", "-0.42,-0.42,1,0.1", "0.42,-0.42,1,0.1"]
FIVE = [HEADER, "0.6,0,1,0.1", "0.18,0.57,1,0.1", "-0.49,0.35,1,0.1", "-0.49,-0.35,1,0.1",
        "0.18,-0.57,1,0.1"]
RING = [HEADER, "0.8,0.08,1,0.02", "-0.8,-0.08,1,0.02", "-0.08,0.8,1,0.02", "0.08,-0.8,1,0.02",
        "0.55,0.05,-1,0.02", "-0.55,-0.05,-1,0.02", "-0.05,0.55,-1,0.02", "0.05,-0.55,-1,0.02"]
PAIR = [HEADER, "0.7,0,1,0.05", "-0.7,0,-1,0.05"]
ELBOW = [HEADER, "0.3,0.3,1,0.02", "0.7,0.2,-1,0.02"]

# Name -> subcommand, domain, singularities, options.
GOOD = {
    "drilled": ("drill", "builtin:disk", FOUR, "--size 0.1"),
    "imprinted": ("solve", "builtin:disk", FOUR, "--mode imprint --size 0.1"),
    "constrained": ("solve", "builtin:disk", FOUR, "--method constrained --size 0.1"),
    "unit_holes": ("solve", "builtin:disk", FOUR, "--unit-holes --size 0.1"),
    "by_sum": ("solve", "builtin:disk", FOUR, "--global-constraint --size 0.1"),
    "penalty": ("solve", "builtin:disk", FIVE, "--epsilon 0.1 --size 0.1"),
    "unit_norm": ("solve", "builtin:disk", FOUR, "--method unit-norm --size 0.1"),
    "ring": ("solve", "builtin:ring", PAIR, "--method unit-norm --size 0.1"),
    "display": ("solve", "builtin:disk", FOUR, "--method constrained --size 0.1 --arrays display"),
    "exact": ("solve", "builtin:disk", FOUR, "--size 0.1 --arrays exact"),
    "exact_h": ("hfield", "builtin:disk", FOUR, "--size 0.1 --arrays exact"),
    "reference": ("solve", "builtin:disk", None, "--method ginzburg-landau --epsilon 0.2 --size 0.15"),
    "h": ("hfield", "builtin:l-shape", ELBOW, ""),
    "h_on_holes": ("hfield", "drilled.vtu", None, ""),
    "quads": ("quads", "builtin:ring", RING, "--size 0.08"),
    "regions": ("quads", "squares.msh", None, "--size 0.2"),
    "map": ("separatrices", "builtin:ring", RING, "--size 0.08"),
    "h_of_ring": ("hfield", "builtin:ring", PAIR, "--size 0.1"),
}
# Two squares of two materials, in the format of Gmsh.
SQUARES = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
6
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
$EndNodes
$Elements
2
1 3 2 1 1 1 2 5 4
2 3 2 2 2 2 3 6 5
$EndElements
"""
# Arrays that have the unit of length.
LENGTHS = ("Epsilon", "Moved", "Size", "SizeRange", "SeamTranslation", "UV", "Length", "USize", "VSize",
           "Longest", "Mismatch")


def make(name, folder):
    """Returns a correct file, computed by the program once."""
    if (folder / (name + ".vtu")).exists():
        return folder / (name + ".vtu")
    subcommand, domain, rows, options = GOOD[name]
    if domain == "drilled.vtu":
        make("drilled", folder)
    if domain == "squares.msh":
        (folder / domain).write_text(SQUARES)
    command = [PROGRAM, subcommand, domain, "-o", name + ".vtu", *options.split()]
    if subcommand == "separatrices":
        command[4:5] = [name + ".lines.vtp", "--faces", name + ".faces.vtp", "--map", name + ".vtu"]
    if rows is not None:
        (folder / "rows.csv").write_text("\n".join(rows) + "\n")
        command += ["-s", "rows.csv"]
    subprocess.run(command, cwd=folder, check=True, timeout=60, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    return folder / (name + ".vtu")


def good_files(folder):
    for name in GOOD:
        report = verify(make(name, folder))
        if report.failures() or not report.checks:
            sys.exit(report.text(everything=False))


def good_files_of_every_size(folder):
    """Checks that in another unit of length all numbers except lengths are the same, within the
    limits of the program."""
    for name in GOOD:
        made = make(name, folder)
        for scale in (2.0**-196, 2.0**-116, 2.0**116, 2.0**196):  # exact
            file = CorruptedFile(made)
            for part in (file, *file.beside.values()):
                part.scale(scale, LENGTHS)
            file.write(folder / "scaled.vtu")
            report = verify(folder / "scaled.vtu")
            if report.failures() or not report.checks:
                sys.exit("%s, scaled by %g: %s" % (name, scale, report.text(everything=False)))


def every_check_can_fail(folder):
    made = {check[0] for name in GOOD for check in verify(make(name, folder)).checks}
    corrupted = set().union(*(names for _, _, names in CASES.values()))
    if made - corrupted:
        sys.exit("No case makes these checks fail: %s" % sorted(made - corrupted))


def run(case, folder):
    base, corrupt, expected = CASES[case]
    file = CorruptedFile(make(base, folder))
    corrupt(file)
    (folder / case).mkdir()
    file.write(folder / case / "corrupted.vtu")
    report = verify(folder / case / "corrupted.vtu")
    named = {check[0] for check in report.failures()}
    if named == expected:
        return True
    print("%s\nFailed unexpectedly: %s\nDid not fail: %s\n%s" % (
        case, sorted(named - expected), sorted(expected - named), report.text()))
    return False


if __name__ == "__main__":
    PROGRAM, wanted = sys.argv[1:]
    chosen = [case for case, (_, corrupt, _) in CASES.items() if wanted in (case, corrupt.__module__)]
    with tempfile.TemporaryDirectory(prefix="crossfield-") as place:
        if chosen:
            sys.exit(not all([run(case, pathlib.Path(place)) for case in chosen]))
        {"good_files": good_files, "good_files_of_every_size": good_files_of_every_size,
         "every_check_can_fail": every_check_can_fail}[wanted](pathlib.Path(place))
