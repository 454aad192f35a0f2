"""crossfield quads, check and separatrices with surfaces in space: formats, repairs, and broken files."""
import json
import math
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import unittest

from program import PROGRAM, ProgramTest


def sphere(n=6):
    """Returns points and triangles of a cube of n × n squares a face, blown up."""
    numbers, points, triangles = {}, [], []

    def at(place):
        if place not in numbers:
            numbers[place] = len(points)
            warped = [math.tan(math.pi / 4 * (2 * k / n - 1)) for k in place]
            norm = math.sqrt(sum(x * x for x in warped))
            points.append([x / norm for x in warped])
        return numbers[place]

    for axis in range(3):
        for end in (0, n):
            for i in range(n):
                for j in range(n):
                    corners = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        place = [0, 0, 0]
                        place[axis] = end
                        place[(axis + 1) % 3] = i + (di if end else dj)
                        place[(axis + 2) % 3] = j + (dj if end else di)
                        corners.append(at(tuple(place)))
                    triangles += [corners[:3], [corners[0], *corners[2:]]]
    return points, triangles


def upper_half(points, triangles):
    """Returns the triangles with z ≥ 0, and their points."""
    kept = [t for t in triangles if min(points[v][2] for v in t) > -1e-9]
    used = sorted({v for t in kept for v in t})
    number = {v: i for i, v in enumerate(used)}
    return [points[v] for v in used], [[number[v] for v in t] for t in kept]


def cube_corners(radius=1.0):
    at = radius / math.sqrt(3)
    return [(x, y, z, 1) for x in (-at, at) for y in (-at, at) for z in (-at, at)]


def stl(points, triangles):
    facets = ["facet normal 0 0 0\nouter loop\n%s\nendloop\nendfacet" %
              "\n".join("vertex %.9g %.9g %.9g" % tuple(points[v]) for v in triangle) for triangle in triangles]
    return "solid part\n" + "\n".join(facets) + "\nendsolid part\n"


def binary_stl(points, triangles):
    return b"\0" * 80 + struct.pack("<I", len(triangles)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for v in triangle for x in points[v]), 0) for triangle in triangles)


def obj(points, triangles):
    return "".join("v %.17g %.17g %.17g\n" % tuple(p) for p in points) + "".join(
        "f %d %d %d\n" % tuple(v + 1 for v in t) for t in triangles)


def off(points, triangles):
    return "OFF\n%d %d 0\n" % (len(points), len(triangles)) + "".join(
        "%.17g %.17g %.17g\n" % tuple(p) for p in points) + "".join("3 %d %d %d\n" % tuple(t) for t in triangles)


def ply(points, triangles):
    return ("ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (len(points), len(triangles))
            ) + off(points, triangles).split("\n", 2)[2]


def vtk(points, triangles):
    return ("# vtk DataFile Version 3.0\na surface\nASCII\nDATASET POLYDATA\nPOINTS %d double\n" % len(points) + "".join(
        "%.17g %.17g %.17g\n" % tuple(p) for p in points) + "POLYGONS %d %d\n" % (len(triangles), 4 * len(triangles)) +
        "".join("3 %d %d %d\n" % tuple(t) for t in triangles))


def msh(points, triangles):
    return ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % len(points) + "".join(
        "%d %.17g %.17g %.17g\n" % (i + 1, *p) for i, p in enumerate(points)) + "$EndNodes\n$Elements\n%d\n" %
        len(triangles) + "".join("%d 2 2 0 1 %d %d %d\n" % (i + 1, *(v + 1 for v in t))
                                 for i, t in enumerate(triangles)) + "$EndElements\n")


WRITERS = {"stl": stl, "obj": obj, "off": off, "ply": ply, "vtk": vtk, "msh": msh}


DOCS = pathlib.Path(__file__).parents[2] / "docs/surfaces"


def named_msh():
    """Returns a blown-up cube without its lower half as a .msh: its top is the group "lid", the rest "wall", and half of
    the boundary is the group "rim" of lines."""
    points, triangles = upper_half(*sphere())
    is_lid = [all(points[v][2] > max(abs(points[v][0]), abs(points[v][1])) - 1e-9 for v in t) for t in triangles]
    rim = [(t[i], t[(i + 1) % 3]) for t in triangles for i in range(3)
           if all(abs(points[t[k % 3]][2]) < 1e-9 for k in (i, i + 1)) and
           points[t[i]][0] + points[t[(i + 1) % 3]][0] > 1e-9]
    elements = ["1 2 4 1 %d %d" % tuple(v + 1 for v in line) for line in rim] + [
        "2 2 %d 1 %d %d %d" % (8 if lid else 6, *(v + 1 for v in t)) for lid, t in zip(is_lid, triangles)]
    return ('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 4 "rim"\n2 8 "lid"\n2 6 "wall"\n'
            "$EndPhysicalNames\n$Nodes\n%d\n" % len(points) + "".join(
                "%d %.17g %.17g %.17g\n" % (i + 1, *p) for i, p in enumerate(points)) +
            "$EndNodes\n$Elements\n%d\n" % len(elements) + "".join(
                "%d %s\n" % (i + 1, element) for i, element in enumerate(elements)) + "$EndElements\n")


class Surfaces(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("eight.csv", cube_corners())

    def write(self, name, rows):
        (self.folder / name).write_text(
            "x,y,z,quarter_index\n" + "".join("%.17g,%.17g,%.17g,%d\n" % row for row in rows))

    def quads(self, surface, *arguments, singularities="eight.csv"):
        output = () if "-o" in arguments else ("-o", "quads.vtu")
        return json.loads(self.succeed("quads", surface, "-s", singularities, *output, "--json", "-", *arguments))

    def test_formats(self):
        points, triangles = sphere()
        for ending, write in WRITERS.items():
            (self.folder / ("part." + ending)).write_text(write(points, triangles))
        (self.folder / "binary.stl").write_bytes(binary_stl(points, triangles))
        for name in [*("part." + ending for ending in WRITERS), "binary.stl"]:
            with self.subTest(name):
                report = self.quads(name, "--quads", "600")
                self.assertEqual((report["quads"], report["blocks"], report["irregular"], report["inverted"]),
                                 (600, 6, {"3": 8}, 0))

    def test_outputs(self):
        (self.folder / "part.obj").write_text(obj(*sphere()))
        self.quads("part.obj", "--quads", "150", "-o", "quads.obj.vtu", "--blocks", "blocks.vtm", "--layout", "l.vtp",
                   "--save-singularities", "saved.csv")
        rows = (self.folder / "saved.csv").read_text().split()
        self.assertEqual(rows[0], "x,y,z,quarter_index")
        self.assertEqual(len(rows), 9)
        report = self.quads("part.obj", "--quads", "150", singularities="saved.csv")
        self.assertEqual(report["irregular"], {"3": 8})
        lines = json.loads(self.succeed("separatrices", "part.obj", "-s", "eight.csv", "-o", "lines.vtp", "--json", "-"))
        self.assertGreaterEqual(lines["faces"], 6)
        field = json.loads(self.succeed("hfield", "part.obj", "-s", "eight.csv", "-o", "field.vtu", "--json", "-"))
        self.assertEqual((field["triangles"], field["unwanted_singularities"]), (432, 0))
        self.assertIn("H from -", self.succeed("hfield", "part.obj", "-s", "eight.csv", "-o", "field.vtu"))
        check = json.loads(self.succeed("check", "part.obj", "-s", "eight.csv", "--json", "-"))
        self.assertEqual((check["required_interior_quarters"], check["euler_characteristic"]), (8, 2))
        self.assertAlmostEqual(check["total_curvature"], 2)
        self.assertIn("total curvature 2", self.succeed("check", "part.obj", "-s", "eight.csv"))

    def test_files_for_solvers(self):
        (self.folder / "part.obj").write_text(obj(*sphere()))
        for name in ("quads.msh", "quads.inp", "quads.vtk", "quads.ex2"):
            with self.subTest(name):
                self.quads("part.obj", "--quads", "150", "-o", name)
                self.assertTrue((self.folder / name).stat().st_size > 1000)

    def test_chosen_singularities(self):
        (self.folder / "part.off").write_text(off(*sphere(12)))
        report = json.loads(self.succeed("quads", "part.off", "--quads", "600", "-o", "quads.vtu", "--json", "-"))
        self.assertEqual((report["irregular"], report["inverted"]), ({"3": 8}, 0))
        self.assertGreater(report["scaled_jacobian"]["min"], 0.7)
        self.assertEqual(len(report["singularities"]), 8)
        self.assertGreater(report["seconds"]["choose"], 0)
        lines = json.loads(self.succeed("separatrices", "part.off", "-o", "lines.vtp", "--json", "-"))
        self.assertEqual(lines["lines"], 24)
        field = json.loads(self.succeed("hfield", "part.off", "-o", "field.vtu", "--json", "-"))
        self.assertEqual(field["unwanted_singularities"], 0)
        coarse = json.loads(self.succeed("quads", "part.off", "--quads", "600", "--merge", "coarse", "-o", "coarse.vtu",
                                         "--json", "-"))
        self.assertLessEqual(coarse["blocks"], 30)
        self.assertEqual(coarse["irregular"], {"3": 8})

    def test_order_two(self):
        points, triangles = sphere(12)
        (self.folder / "part.off").write_text(off(points, triangles))
        (self.folder / "half.off").write_text(off(*upper_half(points, triangles)))
        self.write("four.csv", [row for row in cube_corners() if row[2] > 0])
        for name, singularities, sides in (("part", "eight.csv", 0), ("half", "four.csv", 1)):
            report = self.quads(name + ".off", "--quads", "150", "--order", "2", "-o", name + ".inp",
                                singularities=singularities)
            text = (self.folder / (name + ".inp")).read_text()
            self.assertIn("TYPE=S8", text)
            self.assertEqual(text.count("*NSET, NSET=outer0"), sides)
            nodes = [[float(x) for x in line.split(",")[1:]]
                     for line in text.split("*NODE, NSET=NALL\n")[1].split("*")[0].splitlines()]
            self.assertEqual(len(nodes), report["quads"] * 3 + (2 if sides == 0 else 1 + report["sides"][0]["edges"]))
            for node in nodes:
                self.assertAlmostEqual(math.hypot(*node), 1, delta=0.01)
            if sides:
                rim = text.split("*NSET, NSET=outer0\n")[1].split("*")[0].replace(",", " ").split()
                self.assertEqual(len(rim), 2 * report["sides"][0]["edges"])
                self.assertLess(max(abs(nodes[int(node) - 1][2]) for node in rim), 1e-12)

    def test_sharp_edges(self):
        corners = [[i % 2, i // 2 % 2, i // 4] for i in range(8)]
        cube = [[0, 3, 1], [0, 2, 3], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 7, 3], [2, 6, 7], [0, 4, 6],
                [0, 6, 2], [1, 3, 7], [1, 7, 5]]
        (self.folder / "cube.stl").write_text(stl(corners, cube))
        report = json.loads(self.succeed("quads", "cube.stl", "--quads", "600", "-o", "cube.vtu", "--json", "-"))
        self.assertEqual((report["quads"], report["blocks"], report["irregular"]), (600, 6, {"3": 8}))
        self.assertAlmostEqual(report["scaled_jacobian"]["min"], 1)
        self.assertEqual([(side["name"], side["edges"]) for side in report["sides"]], [("features", 120)])
        self.assertTrue(report["events"][0].startswith("Quads follow the lines between faces of the surface: 12 lines"))
        self.succeed("quads", "cube.stl", "--quads", "600", "-o", "cube.inp")
        self.assertIn("*NSET, NSET=features", (self.folder / "cube.inp").read_text())
        check = json.loads(self.succeed("check", "cube.stl", "--json", "-"))
        self.assertEqual((check["required_interior_quarters"], len(check["corners"])), (0, 24))
        self.assertTrue(check["consistent"])
        over = self.run_program("quads", "cube.stl", "--quads", "600", "--feature-angle", "180", "-o", "over.vtu",
                                "--json", "-")
        self.assertEqual(json.loads(over.stdout)["sides"], [])
        self.assertIn("The surface turns by more than 60 degrees within ", over.stderr)
        self.refuse("quads", "cube.stl", "-o", "q.vtu", "--feature-angle", "-1", says=["--feature-angle"])

    def test_physical_groups(self):
        (self.folder / "named.msh").write_text(named_msh())
        report = json.loads(self.succeed("quads", "named.msh", "--quads", "500", "-o", "named.inp", "--json", "-"))
        self.assertEqual({region["name"] for region in report["regions"]}, {"lid", "wall"})
        self.assertEqual(sum(region["quads"] for region in report["regions"]), report["quads"])
        self.assertEqual([one["name"] for one in report["interfaces"]], ["wall+lid"])
        self.assertGreater(report["scaled_jacobian"]["min"], 0.5)
        text = (self.folder / "named.inp").read_text()
        for name in ("*ELEMENT, TYPE=S4, ELSET=lid", "*ELEMENT, TYPE=S4, ELSET=wall", "NSET=rim\n", "NSET=wall_lid\n",
                     "NSET=outer0\n"):
            self.assertIn(name, text)
        # As one region, only the name of the boundary is left.
        report = json.loads(self.succeed("quads", "named.msh", "--materials", "none", "--quads", "500", "-o", "named.inp",
                                         "--json", "-"))
        self.assertNotIn("regions", report)
        self.assertIn("NSET=rim\n", (self.folder / "named.inp").read_text())
        # Without singularities the wall, whose inner boundary has four corners of index -1, lacks some.
        result = self.run_program("check", "named.msh")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"Face at \(.*\): .* whose corners have -4 needs 4; give")

    def test_all_faces_of_a_model(self):
        housing = str(DOCS / "housing.step")
        if "without Open CASCADE" in self.run_program("quads", housing, "-o", "one.vtu").stderr:
            self.skipTest("built without Open CASCADE")
        report = json.loads(self.succeed("quads", housing, "--all-faces", "--quads", "1500", "-o", "housing.inp", "--json",
                                         "-"))
        self.assertEqual(report["irregular"], {"3": 8, "5": 8})
        self.assertGreater(report["scaled_jacobian"]["min"], 0.65)
        self.assertEqual(report["drawing"]["unit"], "mm")
        self.assertEqual({region["name"] for region in report["regions"]},
                         {"bore", "rounding", *("face%d" % i for i in (1, 2, 4, 5, 6, 7))})
        text = (self.folder / "housing.inp").read_text()
        for name in ("ELSET=bore\n", "ELSET=rounding\n", "NSET=seal\n", "NSET=rounding_face6\n"):
            self.assertIn(name, text)

    def test_sizes(self):
        (self.folder / "part.obj").write_text(obj(*sphere(16)))
        report = self.quads("part.obj", "--chord-error", "0.01")
        self.assertAlmostEqual(math.sqrt(4 * math.pi / report["quads"]), 0.2, delta=0.02)
        self.assertLessEqual(report["surface_distance"]["max"], 0.011)
        self.assertGreater(report["size_target"]["area_share"], 0.9)
        result = self.run_program("quads", "part.obj", "--size", "0.2", "--size-near", "0,0,1:0.1", "-o", "near.vtu")
        self.assertEqual(result.returncode, 0)
        (self.folder / "half.off").write_text(off(*upper_half(*sphere(16))))
        for arguments, least, most in ((("--count", "outer0:60"), 60, 60), (("--size-at", "outer0:0.1"), 51, 75)):
            report = json.loads(self.succeed("quads", "half.off", "--quads", "500", "-o", "half.vtu", "--json", "-", *arguments))
            [edges] = [side["edges"] for side in report["sides"] if side["name"] == "outer0"]
            self.assertTrue(least <= edges <= most, edges)
        self.refuse("quads", "half.off", "-o", "none.vtu", "--count", "rim:60", says=["rim", "outer0"])
        self.refuse("quads", "half.off", "-o", "none.vtu", "--count", "outer0:61", says=["outer0:61 fits no mesh", "give outer0:62"])
        for arguments, words in ((("--chord-error", "-1"), "--chord-error"), (("--chord-error", "0"), "--chord-error")):
            result = self.run_program("quads", "part.obj", "-o", "none.vtu", *arguments)
            self.assertEqual(result.returncode, 2)
            self.assertIn(words, result.stderr)
        result = self.run_program("quads", "builtin:square", "--chord-error", "0.1", "-o", "none.vtu")
        self.assertEqual(result.returncode, 2)
        self.assertIn("no chord error", result.stderr)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_example_of_pinched_shells(self):
        """The script of the example: displacements within 1 % of the literature's, and of those of mapped meshes."""
        script = DOCS.parents[1] / "examples/pinched_shells/shells.py"
        output = subprocess.run([sys.executable, script, "--program", PROGRAM, "--quads", "1200"], stdout=subprocess.PIPE,
                                text=True, check=True).stdout
        rows = re.findall(r"irregular nodes (.*), displacement over the literature's (.*); mapped mesh of \d+: (.*)", output)
        self.assertEqual([row[0] for row in rows], ["{}", "{'3': 4}"])
        for _, ours, mapped in rows:
            self.assertLess(abs(float(ours) - 1), 0.01)
            self.assertLess(abs(float(ours) - float(mapped)), 0.01)

    def test_order_two_on_sharp_edges(self):
        def on_can(place):
            cube = [x / max(map(abs, place)) for x in place]
            radius = math.hypot(*cube[:2])
            scale = max(map(abs, cube[:2])) / radius if radius else 0
            return [cube[0] * scale, cube[1] * scale, cube[2]]
        points, triangles = sphere(24)
        (self.folder / "can.off").write_text(off([on_can(point) for point in points], triangles))
        self.succeed("quads", "can.off", "--quads", "800", "--order", "2", "-o", "can.inp")
        text = (self.folder / "can.inp").read_text()
        nodes = [[float(x) for x in line.split(",")[1:]]
                 for line in text.split("*NODE, NSET=NALL\n")[1].split("*")[0].splitlines()]
        rims = text.split("*NSET, NSET=features\n")[1].split("*")[0].replace(",", " ").split()
        self.assertGreater(len(rims), 100)
        for node in rims:
            place = nodes[int(node) - 1]
            self.assertAlmostEqual(abs(place[2]), 1, delta=1e-12)
            self.assertGreater(math.hypot(*place[:2]), math.cos(math.pi / 96) - 1e-9)  # of chords 0.997

    def test_how_they_fit(self):
        (self.folder / "part.off").write_text(off(*sphere(24)))
        for quads in (150, 600):
            report = self.quads("part.off", "--quads", str(quads))
            self.assertAlmostEqual(report["surface_distance"]["mean"] / (math.pi / quads), 1, delta=0.15)  # h² / 4
            self.assertLess(report["scaled_jacobian"]["by_surface"], report["scaled_jacobian"]["min"] + 1e-9)
        few = self.run_program("quads", "part.off", "-s", "eight.csv", "--quads", "6", "-o", "few.vtu")
        self.assertEqual(few.returncode, 0)
        self.assertIn("The surface turns by more than 60 degrees within ", few.stderr)

    def test_repairs(self):
        points, triangles = sphere()
        turned = [t[::-1] if i % 3 == 0 else t for i, t in enumerate(triangles)]
        twice = [*triangles, triangles[4], [7, 7, 9]]
        middle = [(a + b) / 2 for a, b in zip(points[triangles[0][0]], points[triangles[0][1]])]
        a, b, c = triangles[0]
        flat = [[a, len(points), c], [len(points), b, c], [a, b, len(points)], *triangles[1:]]
        beside = [[x + 2, y, z] for x, y, z in points]  # touches the first one
        both = [*triangles, *([v + len(points) for v in t] for t in triangles)]
        for name, data, says in (("turned", (points, turned), "turned over"), ("twice", (points, twice), "given twice"),
                                 ("flat", ([*points, middle], flat), "without an area")):
            with self.subTest(name):
                (self.folder / "part.off").write_text(off(*data))
                report = self.quads("part.off", "--quads", "600")
                self.assertEqual((report["quads"], report["irregular"]), (600, {"3": 8}))
                if name != "twice":  # VTK removes these
                    self.assertTrue(any(says in event for event in report["events"]), report["events"])
        (self.folder / "part.off").write_text(off([*points, *beside], both))
        self.write("sixteen.csv", [*cube_corners(), *((x + 2, y, z, k) for x, y, z, k in cube_corners())])
        report = self.quads("part.off", singularities="sixteen.csv")
        self.assertEqual((report["parts"], report["irregular"]), (2, {"3": 16}))
        self.assertIn("1 point was added where parts of the surface meet in a point only.", report["events"])

    def test_refusals(self):
        points, triangles = sphere(3)
        write = (self.folder / "part.off").write_text
        write(off([*points, [3, 0, 0]], [*triangles, [*triangles[0][:2], len(points)]]))
        refuse = ("quads", "part.off", "-s", "eight.csv", "-o", "q.vtu")
        self.refuse(*refuse, says=["The edge from (", "has 3 triangles", "at most two"])
        write(off(points, triangles[1:]))
        self.refuse(*refuse, says=["add up to 8", "a surface of Euler characteristic 1"], status=1)
        write(off([[0, 0, 0], [1, 0, 0], [1, 1, 1], [-1, 0, 0], [-1, -1, 0]], [[0, 1, 2], [0, 3, 4]]))
        self.refuse(*refuse, says=["touches itself in the point (0, 0, 0)"])
        write(off(points, triangles))
        self.write("seven.csv", cube_corners()[1:])
        self.refuse("quads", "part.off", "-s", "seven.csv", "-o", "q.vtu", says=["add up to 7", "needs 8"], status=1)
        self.write("off.csv", cube_corners(3))
        self.refuse("quads", "part.off", "-s", "off.csv", "-o", "q.vtu", says=["Singularity 1", "off the surface"])
        self.refuse(*refuse, "--layers", "outer0:0.1", says=["boundary layers", "leave this option out"])
        self.refuse("solve", "part.off", "-s", "eight.csv", "-o", "q.vtu", says=["not planar"])
        check = self.run_program("check", "part.off", "-s", "seven.csv")
        self.assertEqual(check.returncode, 1)
        self.assertIn("add up to 7", check.stderr)

    def test_broken_files(self):
        """Thirty files of which nothing can be made: one sentence each."""
        points, triangles = sphere(2)
        count = 0
        for ending, write in WRITERS.items():
            text = write(points, triangles)
            lines = text.splitlines(keepends=True)
            numbers = [i for i, line in enumerate(lines) if sum("." in word for word in line.split()) == 3]
            broken = {
                "empty": "", "header": lines[0], "no coordinates": "".join(line for i, line in enumerate(lines)
                                                                         if i not in numbers),
                "word": "".join(lines).replace(lines[numbers[3]], lines[numbers[3]].replace("0.", "a."), 1),
                "infinite": "".join(lines).replace(lines[numbers[3]], "v inf inf inf\n" if ending == "obj" else
                                                   "vertex inf inf inf\n" if ending == "stl" else
                                                   "4 inf inf inf\n" if ending == "msh" else "inf inf inf\n", 1)}
            for what, content in broken.items():
                with self.subTest(ending=ending, what=what):
                    (self.folder / ("part." + ending)).write_text(content)
                    self.refuse("quads", "part." + ending, "-s", "eight.csv", "-o", "q.vtu")
                    count += 1
        self.assertEqual(count, 30)


if __name__ == "__main__":
    unittest.main()
