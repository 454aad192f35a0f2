"""crossfield quads -o part.msh|.inp|.su2: what Gmsh, meshio, CalculiX and this program read back, and refusals."""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from program import PROGRAM, ProgramTest
from test_sides import RECTANGLE, circle, write_domain

try:
    import meshio
except ImportError:
    meshio = None

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = {"bottom": "in let", "right": 'say "out"', "top": "Стена", "left": "1,2"}
GMSH_TYPES = {1: (1, 3), 2: (8, 10), 3: (26, 36)}  # line and quad of an order


def area(corners):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1])) / 2


def sections(text):
    """Returns the lines of each section of a .msh file."""
    return {name: body.strip().splitlines() for name, body in re.findall(r"\$(\w+)\n(.*?)\$End\1", text, re.DOTALL)}


def read_msh22(text):
    """Returns nodes by number, rows of (type, group, nodes) and names by group of a .msh file of version 2.2."""
    parts = sections(text)
    nodes = {int(row.split()[0]): tuple(map(float, row.split()[1:])) for row in parts["Nodes"][1:]}
    elements = []
    for row in parts["Elements"][1:]:
        _, kind, tags, *rest = map(int, row.split())
        elements.append((kind, rest[0], rest[tags:]))
    names = {}
    for row in parts["PhysicalNames"][1:]:
        dimension, tag, name = row.split(" ", 2)
        names[int(dimension), int(tag)] = name.strip('"')
    return nodes, elements, names


class Formats(ProgramTest):
    def setUp(self):
        super().setUp()
        loop = [(x, y, NAMES[name]) for x, y, name in RECTANGLE]
        write_domain(self.folder / "plate.vtp", [loop, circle(24, 0.4, (1.4, 1.0), lambda i: "hole")])
        write_domain(self.folder / "plain.vtp", [RECTANGLE])

    def quads(self, domain, file, *arguments):
        """Meshes a domain and returns the report and the text of the file."""
        report = json.loads(self.succeed("quads", domain, "-o", file, "--quads", "150", "--json", "-", *arguments))
        return report, (self.folder / file).read_text(encoding="utf-8")

    def test_msh_has_all_quads_and_sides_in_named_groups(self):
        for order in (1, 2, 3):
            report, text = self.quads("plate.vtp", "a.msh", "--order", order, "--curve", "hole:circle", "--msh-version", "2.2")
            nodes, elements, names = read_msh22(text)
            self.assertEqual(sorted(names.values()), ["1,2", "domain", "hole", "in let", "say 'out'", "Стена"])
            edges = {side["name"].replace('"', "'"): side["edges"] for side in report["sides"]}
            line, quad = GMSH_TYPES[order]
            found, total = {}, 0.0
            for kind, group, ids in elements:
                self.assertIn(kind, (line, quad))
                name = names[2 if kind == quad else 1, group]
                found[name] = found.get(name, 0) + 1
                if kind == quad:
                    self.assertGreater(area([nodes[i] for i in ids[:4]]), 0)
                elif name == "hole":
                    for i in ids:
                        self.assertAlmostEqual(math.dist(nodes[i][:2], (1.4, 1.0)), 0.4, delta=1e-12)
                else:
                    (x0, y0, _), (x1, y1, _) = nodes[ids[0]], nodes[ids[1]]
                    self.assertGreater((x0 - 1.5) * (y1 - 1) - (x1 - 1.5) * (y0 - 1), 0, "the domain is on the left")
            self.assertEqual(found.pop("domain"), report["quads"])
            self.assertEqual(found, edges)

    def test_both_versions_of_msh_are_read_by_this_program(self):
        for version in ("2.2", "4.1"):
            report, _ = self.quads("plate.vtp", "a.msh", "--msh-version", version)
            back, _ = self.quads("a.msh", "b.vtu")
            lengths = {side["name"]: side["length"] for side in back["sides"]}
            expected = {side["name"].replace('"', "'"): side["length"] for side in report["sides"]}
            self.assertEqual(set(lengths), set(expected))
            for name in expected:  # the hole is a polygon of other points
                self.assertAlmostEqual(lengths[name], expected[name], delta=0.05 if name == "hole" else 1e-9)

    @unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
    def test_gmsh_reads_every_order_and_version(self):
        for order in (1, 2, 3):
            _, text = self.quads("plate.vtp", "a.msh", "--order", order, "--msh-version", "2.2")
            nodes, elements, names = read_msh22(text)
            self.quads("plate.vtp", "b.msh", "--order", order)
            for file in ("a.msh", "b.msh"):
                subprocess.run(["gmsh", file, "-save", "-format", "msh22", "-o", "read.msh", "-v", "2"], cwd=self.folder,
                               check=True, capture_output=True)
                again = read_msh22((self.folder / "read.msh").read_text(encoding="utf-8"))
                self.assertEqual(again[2], names)

                def shape(parts):
                    rows = [(kind, group, [parts[0][i] for i in ids]) for kind, group, ids in parts[1]]
                    return sorted(rows, key=lambda row: (row[:2], [round(x, 6) for place in row[2] for x in place]))

                for row, expected in zip(shape(again), shape((nodes, elements, names)), strict=True):
                    self.assertEqual(row[:2], expected[:2])
                    for place, exact in zip(row[2], expected[2], strict=True):
                        self.assertLess(math.dist(place, exact), 1e-14)  # gmsh writes 16 digits
                check = subprocess.run(["gmsh", "-check", file], cwd=self.folder, check=True, capture_output=True, text=True)
                self.assertNotRegex(check.stdout + check.stderr, "Warning|Error")

    @unittest.skipUnless(meshio, "meshio is not installed")
    def test_meshio_reads_the_same_mesh_from_every_format(self):
        report, _ = self.quads("plain.vtp", "a.msh")
        edges = {side["name"]: side["edges"] for side in report["sides"]}
        for ending in (".msh", ".inp", ".su2", ".vtk"):
            self.succeed("quads", "plain.vtp", "-o", "a" + ending, "--quads", "150")
            mesh = meshio.read(self.folder / ("a" + ending))
            [quads] = [block.data for block in mesh.cells if block.type == "quad"]
            self.assertEqual(len(quads), report["quads"])
            areas = [area([list(mesh.points[i]) for i in quad]) for quad in quads]
            self.assertGreater(min(areas), 0)
            self.assertAlmostEqual(sum(areas), 6, delta=1e-12)
            if ending == ".msh":
                self.assertEqual(set(mesh.field_data), {*edges, "domain"})
            if ending == ".inp":
                self.assertEqual({name: len(ids) - 1 for name, ids in mesh.point_sets.items() if name in edges}, edges)
            if ending == ".vtk":  # sides are numbers
                [sides] = [of for of, block in zip(mesh.cell_data["Side"], mesh.cells) if block.type == "line"]
                self.assertEqual([sides.tolist().count(i) for i in range(len(edges))], list(edges.values()))
            if ending != ".inp":
                self.assertEqual(sum(len(block.data) for block in mesh.cells if block.type == "line"), sum(edges.values()))

    def test_su2_has_a_marker_for_each_side(self):
        report, text = self.quads("plate.vtp", "a.su2")
        markers = dict(re.findall(r"MARKER_TAG= (\S+)\nMARKER_ELEMS= (\d+)\n", text))
        self.assertEqual(set(markers), {"in_let", "say__out_", "side______", "side_1_2", "hole"})
        self.assertEqual(int(markers["hole"]), {side["name"]: side["edges"] for side in report["sides"]}["hole"])
        self.assertIn("NELEM= %d\n" % report["quads"], text)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_passes_the_patch_test(self):
        """Uniform tension on irregular quads: sets and faces are the right ones, and the stress is exact."""
        (self.folder / "pair.csv").write_text("x,y,quarter_index\n1,0.9,1\n2,1.2,-1\n")
        for order in (1, 2):
            _, text = self.quads("plain.vtp", "a.inp", "--order", order, "-s", "pair.csv")
            rows = text.split("*SURFACE, NAME=right, TYPE=ELEMENT\n")[1].split("*")[0].replace("S", "P").splitlines()
            (self.folder / "a.inp").write_text(text + """*MATERIAL, NAME=steel
*ELASTIC
1000, 0.3
*SOLID SECTION, ELSET=domain, MATERIAL=steel
0.01
*BOUNDARY
left, 1, 1
bottom, 2, 2
*STEP
*STATIC
*DLOAD
%s
*EL PRINT, ELSET=domain
S
*END STEP
""" % "\n".join(row + ", -1" for row in rows))
            subprocess.run(["ccx", "a"], cwd=self.folder, check=True, capture_output=True)
            stresses = [tuple(map(float, row.split()[2:6])) for row in
                        (self.folder / "a.dat").read_text().splitlines() if re.match(r" +\d+ +\d+ ", row)]
            self.assertGreater(len(stresses), 4 * 100)
            for xx, yy, _, xy in stresses:
                self.assertLess(max(abs(xx - 1), abs(yy), abs(xy)), 1e-3 if order == 1 else 1e-4)

    def solve(self, text):
        """Runs CalculiX and returns the printed displacements by node."""
        (self.folder / "a.inp").write_text(text)
        subprocess.run(["ccx", "a"], cwd=self.folder, check=True, capture_output=True)
        rows = [row.split() for row in (self.folder / "a.dat").read_text().splitlines() if re.match(r" +\d+ ", row)]
        return {int(row[0]): tuple(map(float, row[1:4])) for row in rows}

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_uses_the_equations_of_periodic_sides(self):
        """A sector of a ring under inner pressure: equations hold it, and the displacement is Lamé's."""
        count, inner, outer, angle = 48, 1.0, 2.0, 0.7

        def arc(radius, name, begin, end):  # without its end
            turns = [begin + (end - begin) * i / count for i in range(count)]
            return [(radius * math.cos(turn), radius * math.sin(turn), name) for turn in turns]

        write_domain(self.folder / "sector.vtp", [[*arc(outer, "outside", -angle, 0), (outer, 0.0, "high"), *arc(inner, "inside", 0, -angle),
                                                   (inner * math.cos(angle), -inner * math.sin(angle), "low")]])
        _, text = self.quads("sector.vtp", "a.inp", "--periodic", "low:high", "--order", "2", "--curve", "inside:circle", "--curve",
                             "outside:circle")
        rows = text.split("*SURFACE, NAME=inside, TYPE=ELEMENT\n")[1].split("*")[0].replace("S", "P").splitlines()
        # A rotation about the centre is free otherwise. Nodes are tied to one on the side with y = 0.
        node = text.split("*EQUATION\n")[1].splitlines()[1].split(",")[3].strip()
        found = self.solve(text + """*MATERIAL, NAME=steel
*ELASTIC
1000, 0.3
*SOLID SECTION, ELSET=domain, MATERIAL=steel
0.01
*BOUNDARY
%s, 2, 2
*STEP
*STATIC
*DLOAD
%s
*NODE PRINT, NSET=inside
U
*END STEP
""" % (node, "\n".join(row + ", 1" for row in rows)))
        a2, b2 = inner**2, outer**2
        exact = a2 / (1000 * (b2 - a2)) * (0.7 * inner + 1.3 * b2 / inner)
        self.assertGreater(len(found), 10)
        for x, y, _ in found.values():
            self.assertLess(abs(math.hypot(x, y) / exact - 1), 2e-3)

    def test_a_node_on_the_axis_stays_there(self):
        """Two sides of a square are images of each other about their corner, which may not move in the plane."""
        _, text = self.quads("builtin:square", "a.inp", "--periodic", "outer0:outer1")
        rows = text.split("*EQUATION\n")[1].splitlines()
        nodes = dict(row.split(", ", 1) for row in text.split("NSET=NALL\n")[1].split("*")[0].splitlines())
        single = [row.split(", ") for count, row in zip(rows[::2], rows[1::2]) if count == "1"]
        self.assertEqual([degree for _, degree, _ in single], ["1", "2"])
        [corner] = {node for node, _, _ in single}
        self.assertIn(nodes[corner].split(", ")[0].strip(), ("0", "0.", "2", "2.", "0.0", "2.0"))
        dependent = [tuple(row.split(", ")[:2]) for row in rows[1::2]]
        self.assertEqual(len(dependent), len(set(dependent)), "each once")

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_reads_shells(self):
        """A clamped strip in a tilted plane under pressure; without lateral contraction the deflection is that of a beam."""
        cos, sin, length, thickness = math.cos(0.5), math.sin(0.5), 2.0, 0.05
        (self.folder / "tilted.csv").write_text("x,y,z\n" + "".join(
            "%.17g,%.17g,%.17g\n" % (x, y * cos, y * sin) for x, y in ((0, 0), (length, 0), (length, 0.5), (0, 0.5))))
        for order, element in ((1, "S4"), (2, "S8")):
            _, text = self.quads("tilted.csv", "a.inp", "--order", order)
            self.assertIn("*ELEMENT, TYPE=%s, " % element, text)
            nodes = [list(map(float, row.split(","))) for row in text.split("NSET=NALL\n")[1].split("*")[0].splitlines()]
            at = {x: ", ".join(str(int(row[0])) for row in nodes if abs(row[1] - x) < 1e-9) for x in (0.0, length)}
            found = self.solve(text + """*MATERIAL, NAME=steel
*ELASTIC
210000, 0.
*SHELL SECTION, ELSET=domain, MATERIAL=steel
%g
*NSET, NSET=clamped
%s
*NSET, NSET=tip
%s
*BOUNDARY
clamped, 1, 6
*STEP
*STATIC
*DLOAD
domain, P, 0.01
*NODE PRINT, NSET=tip
U
*END STEP
""" % (thickness, at[0.0], at[length]))
            exact = 0.01 * length**4 / (8 * 210000 * thickness**3 / 12)
            self.assertGreater(len(found), 2)
            for x, y, z in found.values():
                self.assertLess(abs(math.hypot(y, z) / exact - 1), 0.1 if order == 1 else 0.01)
                self.assertLess(abs(y * cos + z * sin), 0.01 * exact)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_example_of_a_plate_with_a_hole(self):
        """The script of the example: Kt within 0.5 % of the reference with 280 nodes, 0.3 % with 1,100."""
        output = subprocess.run(
            [sys.executable, ROOT / "examples/plate_with_hole/plate.py", "--program", PROGRAM, "--quads", "240", "1000"],
            stdout=subprocess.PIPE, text=True, check=True).stdout
        found = [(int(nodes), float(factor)) for nodes, factor in re.findall(r"(\d+) nodes of quads: Kt (.*)", output)]
        self.assertEqual(len(found), 2, output)
        for (nodes, factor), most, tolerance in zip(found, (300, 1200), (0.005, 0.003)):
            self.assertLess(nodes, most)
            self.assertLess(abs(factor / 4.348 - 1), tolerance)

    def test_a_format_that_cannot_have_the_mesh_is_refused_without_a_file(self):
        (self.folder / "old.inp").write_text("old")
        for arguments, says in ((("-o", "old.inp", "--order", "3"), "no elements of order 3"),
                                (("-o", "a.su2", "--order", "2"), "order 1 only"),
                                (("-o", "a.cgns", "--order", "2"), "order 1 only"),
                                (("-o", "a.exo", "--order", "3"), "no elements of order 3"),
                                (("-o", "a.case",), "must end in .vtu, .cgns, .e, .ex2, .exo, .foam, .inp, .msh, .msh2, .su2, .vtk, .xyz or /")):
            self.refuse("quads", "plain.vtp", *arguments, says=[says])
        self.assertEqual((self.folder / "old.inp").read_text(), "old")
        result = self.run_program("quads", "plain.vtp", "-o", "a.msh", "--msh-version", "3")
        self.assertEqual(result.returncode, 2)
        self.assertFalse((self.folder / "a.msh").exists())

    @unittest.skipUnless(shutil.which("cgnscheck"), "cgnscheck is not installed")
    def test_cgns_has_no_warnings_and_the_same_content(self):
        for domain in ("plate.vtp", "builtin:disk"):
            self.succeed("quads", domain, "-o", "a.cgns", "--quads", "300")
            check = subprocess.run(["cgnscheck", "-v", "a.cgns"], cwd=self.folder, check=True, capture_output=True, text=True)
            self.assertNotRegex(check.stdout + check.stderr, "(?i)warning|error")
            self.succeed("quads", domain, "-o", "b.cgns", "--quads", "300")
            difference = subprocess.run(["cgnsdiff", "-d", "a.cgns", "b.cgns"], cwd=self.folder, check=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(difference.stdout, "")
        self.succeed("quads", "plate.vtp", "-o", "a.cgns", "--quads", "300")
        text = subprocess.run(["cgnslist", "a.cgns"], cwd=self.folder, check=True, capture_output=True, text=True).stdout
        for name in ("in let", "say 'out'", "Стена", "1,2", "hole"):
            self.assertRegex(text, r"(?m)^ +\+-%s$" % re.escape(name))

    def test_files_come_in_pairs_or_not_at_all(self):
        self.succeed("quads", "plate.vtp", "-o", "a.xyz", "--quads", "150")
        before = (self.folder / "a.xyz").read_bytes()
        (self.folder / "a.nmf").unlink()
        (self.folder / "a.nmf").mkdir()
        self.refuse("quads", "plate.vtp", "-o", "a.xyz", "--quads", "300", says=["is a folder"])
        self.assertEqual((self.folder / "a.xyz").read_bytes(), before)

    def test_tilted_planes(self):
        text = (self.folder / "plain.vtp").read_text()
        points = "0 0 0 3 0 1 3 2 1 0 2 0"
        (self.folder / "tilted.vtp").write_text(re.sub(r'(format="ascii">)0 0 0 3 0 0 3 2 0 0 2 0', r"\g<1>" + points, text))
        self.refuse("quads", "tilted.vtp", "-o", "a.su2", says=["z = const"])
        _, text = self.quads("tilted.vtp", "a.msh", "--msh-version", "2.2")
        nodes, _, _ = read_msh22(text)
        for x, _, z in nodes.values():
            self.assertAlmostEqual(z, x / 3, delta=1e-12)
