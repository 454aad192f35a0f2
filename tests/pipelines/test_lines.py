"""crossfield quads and check with lines and points inside: drawings, files, errors, and CalculiX on a crack."""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from program import PROGRAM, ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "examples"))
from calculix import read_mesh  # noqa: E402

try:
    import numpy
except ImportError:
    numpy = None

SQUARE = ((-1, -1), (1, -1), (1, 1), (-1, 1))


def write_part(path, lines, loops=(SQUARE,)):
    """Writes loops, whose first line has the name `bottom`, and named lines inside as a .vtk file."""
    points, cells, names = [], [], []
    for loop in loops:
        first = len(points)
        points += loop
        for i in range(len(loop)):
            cells.append((first + i, first + (i + 1) % len(loop)))
            names.append("bottom" if first + i == 0 else "")
    for name, chain in lines.items():
        cells.append(range(len(points), len(points) + len(chain)))
        names.append(name)
        points += chain
    rows = ["# vtk DataFile Version 3.0", "a part", "ASCII", "DATASET POLYDATA", "POINTS %d double" % len(points)]
    rows += ["%.17g %.17g 0" % tuple(point) for point in points]
    rows += ["LINES %d %d" % (len(cells), sum(len(cell) + 1 for cell in cells))]
    rows += [" ".join(map(str, (len(cell), *cell))) for cell in cells]
    rows += ["CELL_DATA %d" % len(cells), "FIELD names 1", "Side 1 %d string" % len(cells), *names]
    path.write_text("\n".join(rows) + "\n")


def dxf_line(layer, start, end):
    return "0\nLINE\n8\n%s\n10\n%g\n20\n%g\n11\n%g\n21\n%g\n" % (layer, *start, *end)


class Lines(ProgramTest):
    def quads(self, domain, *arguments):
        output = () if "-o" in arguments else ("-o", "quads.vtu")
        return json.loads(self.succeed("quads", domain, *output, "--quads", "400", "--json", "-", *arguments))

    def test_a_line_is_welded_or_open(self):
        write_part(self.folder / "part.vtk", {"crack": ((-1, 0), (0, 0))})
        welded = self.quads("part.vtk", "--line", "crack")
        opened = self.quads("part.vtk", "--open", "crack")
        for report in (welded, opened):
            self.assertEqual((report["quads"], report["inverted"]), (400, 0))
            self.assertGreater(report["scaled_jacobian"]["min"], 0.99)
        edges = {side["name"]: side["edges"] for side in opened["sides"]}
        self.assertEqual((edges["crack.left"], edges["crack.right"], edges["bottom"]), (10, 10, 20))
        self.assertEqual({side["name"]: side["edges"] for side in welded["sides"]}["crack"], 10)

    def test_names_of_a_side_on_which_a_line_ends_stay(self):
        write_part(self.folder / "part.vtk", {"crack": ((0.2, -1), (0.2, 0))})
        edges = {side["name"]: side["edges"] for side in self.quads("part.vtk", "--line", "crack")["sides"]}
        self.assertEqual(edges["bottom"], 20)

    def test_lines_cross_and_nodes_are_at_positions(self):
        write_part(self.folder / "part.vtk", {"a": ((-0.6, 0.05), (0.5, 0.1)), "b": ((0.05, -0.5), (0.1, 0.6))})
        report = self.quads("part.vtk", "-o", "quads.inp", "--line", "a", "--line", "b", "--node", "0.7,0.73", "--node", "1,-0.33")
        self.assertEqual((report["irregular"], report["inverted"]), ({}, 0))
        self.assertGreater(report["scaled_jacobian"]["min"], 0.7)
        places, _ = read_mesh((self.folder / "quads.inp").read_text())
        for place in ((0.7, 0.73), (1, -0.33), (-0.6, 0.05), (0.5, 0.1), (0.05, -0.5), (0.1, 0.6)):
            self.assertLess(min(math.dist(place, found[:2]) for found in places.values()), 1e-9, place)

    def test_an_interface_is_opened(self):
        pipe = ROOT / "tests/data/regions/pipe.vtp"
        edges = {side["name"]: side["edges"] for side in self.quads(pipe, "--open", "insulation+steel")["sides"]}
        self.assertEqual(edges["steel+insulation.left"], edges["steel+insulation.right"])
        self.assertIn("insulation+soil", edges)

    def test_layers_of_a_drawing_are_lines(self):
        text = "0\nSECTION\n2\nENTITIES\n"
        for i in range(4):
            text += dxf_line("plate", SQUARE[i], SQUARE[(i + 1) % 4])
        text += "0\nCIRCLE\n8\nhole\n10\n-0.4\n20\n0\n40\n0.3\n" + dxf_line("crack", (-0.1, 0), (0.4, 0))
        text += dxf_line("probe", (0.6, -1), (0.7, 1)) + "0\nENDSEC\n0\nEOF\n"
        (self.folder / "part.dxf").write_text(text)
        report = self.quads("part.dxf", "--open", "crack", "--line", "probe", "--count", "crack:6")
        edges = {side["name"]: side["edges"] for side in report["sides"]}
        self.assertEqual((edges["crack.left"], edges["crack.right"]), (6, 6))
        self.assertEqual((report["inverted"], len(report["regions"])), (0, 2))
        self.refuse("quads", "part.dxf", "-o", "quads.msh", says=["layer 'crack'"])

    def test_check_counts_with_lines(self):
        write_part(self.folder / "part.vtk", {"crack": ((-0.4, -0.3), (0.45, 0.25))})
        report = json.loads(self.succeed("check", "part.vtk", "--line", "crack", "--json", "-"))
        self.assertEqual((report["regions"][0]["required_interior_quarters"], report["euler_characteristic"]), (0, 0))
        self.refuse("check", "part.vtk", "--line", "crack", "--propose", "a.csv", says=["with lines is proposed by quads alone"])

    def test_what_is_not_there_is_refused(self):
        write_part(self.folder / "part.vtk", {"crack": ((-1, 0), (0, 0))})
        write_part(self.folder / "far.vtk", {"far": ((4, 4), (5, 5))})
        for arguments, says in ((("--line", "weld"), "No line of the domain has the name 'weld'"),
                                (("--open", "weld"), "There is no line or interface 'weld' to open; the domain has none"),
                                (("--line", "crack", "--open", "weld"), "to open; there are 'crack'"),
                                (("--line", "far"), "No part of the line 'far' is inside of the domain"),
                                (("--node", "7,7"), "There is no node for the place (7, 7)"),
                                (("--node", "7"), "'7' is no position"),
                                (("--line", "crack", "--layers", "bottom:0.01"), "Boundary layers are not available"),
                                (("--line", "crack", "--thin-boundary", "0.1"), "is not simplified yet")):
            domain = "far.vtk" if "far" in arguments else "part.vtk" if "--line" in arguments else "builtin:l-shape"
            self.refuse("quads", domain, "-o", "quads.msh", *arguments, says=[says])

    @unittest.skipUnless(shutil.which("ccx") and numpy, "CalculiX or numpy is not installed")
    def test_example_of_an_edge_crack(self):
        """The script of the example: K within 2 % of the handbook's with 20 rings of quads around the tip."""
        output = subprocess.run([sys.executable, ROOT / "examples/edge_crack/crack.py", "--program", PROGRAM, "--quads", "4800"],
                                stdout=subprocess.PIPE, text=True, check=True).stdout
        [(along, ratio)] = re.findall(r"(\d+) along the crack: K over the handbook's (.*)", output)
        self.assertEqual(int(along), 20)
        self.assertLess(abs(float(ratio) - 1), 0.02)


if __name__ == "__main__":
    unittest.main()
