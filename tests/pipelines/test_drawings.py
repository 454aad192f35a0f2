"""Drawings as domains: the same plate in every format, units, names, gaps, and damaged files."""

import json
import pathlib
import random
import subprocess
import time
import unittest

import drawing_files
from drawing_files import circle, dxf, line, plate
from program import PROGRAM, SENTENCE, ProgramTest
from test_damaged_files import damage

DATA = pathlib.Path(__file__).resolve().parents[1] / "data" / "drawings"
HAS_MODELS = subprocess.run([PROGRAM, "check", str(DATA / "plate.brep")], capture_output=True, check=False,
                            text=True).stderr.find("built without Open CASCADE") < 0


class Drawings(ProgramTest):
    def write(self, name, content):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def check(self, name, *options):
        """Returns the exit status, the report and what is printed on standard error."""
        result = subprocess.run([PROGRAM, "check", str(name), *options, "--json", "-"], cwd=self.folder, timeout=60,
                                capture_output=True, check=False, text=True, errors="replace")
        return result.returncode, json.loads(result.stdout) if result.stdout else None, result.stderr

    def accept(self, name, loops, *options):
        """Expects a domain with so many loops; returns the report and the warnings."""
        status, report, printed = self.check(name, *options)
        self.assertIn(status, (0, 1), printed)
        self.assertEqual(report["euler_characteristic"], 2 - loops, name)
        return report, printed

    def refuse_text(self, name, content, *parts):
        self.write(name, content)
        status, report, printed = self.check(name)
        self.assertEqual((status, report), (2, None), printed)
        sentence = printed.splitlines()[-1] + "\n"
        self.assertRegex(sentence, SENTENCE)
        for part in parts:
            self.assertIn(part, sentence)

    def test_the_plate_in_every_format(self):
        files = {"a.dxf": drawing_files.plate_dxf(), "a.svg": drawing_files.SVG, "a.geojson": drawing_files.GEOJSON,
                 "a.msh": drawing_files.msh22(), "b.msh": drawing_files.msh41(),
                 "c.msh": drawing_files.msh22_binary()}
        for name, content in files.items():
            with self.subTest(name):
                report, printed = self.accept(self.write(name, content), 2)
                self.assertEqual(printed.count("Warning"), 0, printed)
                self.assertEqual(report["drawing"]["largest_gap"], 0.0)
                unit = {"dxf": "mm", "svg": "mm", "geojson": "degree"}.get(name[2:])
                self.assertEqual(report["drawing"].get("unit"), unit)

    def test_names_are_sides(self):
        for name, content in (("a.dxf", drawing_files.plate_dxf()), ("a.svg", drawing_files.SVG),
                              ("a.msh", drawing_files.msh22())):
            self.write(name, content)
            report = json.loads(self.run_program("quads", name, "-o", "q.vtu", "--quads", "200", "--count", "hole:16",
                                                 "--json", "-").stdout)
            sides = {side["name"]: side["edges"] for side in report["sides"]}
            self.assertEqual((sorted(sides), sides["hole"]), (["hole", "wall"], 16))

    def test_aerofoils(self):
        for name, content in (("blunt.dat", drawing_files.naca()), ("sharp.dat", drawing_files.naca(blunt=False))):
            report, _ = self.accept(self.write(name, content), 1)
            self.assertIn("drawing", report)
            self.assertEqual(len(report["corners"]), 2 if name == "blunt.dat" else 1)
        # A sharp leading edge at a straight side is a corner, and the side stays straight.
        upper = [(i / 20, 0.4 * i / 20 * (1 - i / 20)) for i in range(20, -1, -1)]
        rows = upper + [(i / 20, 0) for i in range(1, 21)]
        self.write("plane.dat", "plane\n" + "".join("%.6f %.6f\n" % row for row in rows))
        report = json.loads(self.run_program("quads", "plane.dat", "-o", "q.vtu", "--quads", "300", "--json", "-").stdout)
        self.assertEqual(report["inverted"], 0)
        corners = self.accept("plane.dat", 1)[0]["corners"]
        self.assertEqual([(corner["x"], corner["y"]) for corner in corners], [(0, 0), (1, 0)])
        # Plain loops are still read as loops.
        report, _ = self.accept(self.write("square.dat", "square\n0 0\n1 0\n1 1\n0 1\n"), 1)
        self.assertNotIn("drawing", report)

    def test_far_from_the_origin(self):
        for shift in (1e6, 1e9, -1e9):
            report, printed = self.accept(self.write("far.dxf", drawing_files.plate_dxf(shift)), 2)
            self.assertEqual(len(report["corners"]), 4)
            self.assertNotIn("Warning", printed)

    def test_gaps(self):
        rows = plate()
        rows[0] = line((0, 0), (3.999, 0))
        self.refuse_text("gap.dxf", dxf(rows), "open at (3.999, 0)", "join tolerance to 0.0011")
        _, printed = self.accept("gap.dxf", 2, "--join-tolerance", "0.0011")
        self.assertIn("0.001 wide", printed)
        rows[0] = line((0, 0), (3.99999, 0))
        self.accept(self.write("gap.dxf", dxf(rows)), 2)  # within the default

    def test_warnings(self):
        rows = plate() + plate()[:2] + [("TEXT", 8, "wall", 10, 0, 20, 0, 1, "words")]
        _, printed = self.accept(self.write("twice.dxf", dxf(rows)), 2)
        self.assertIn("1 TEXT", printed)
        self.assertIn("2 pieces of the drawing were left out", printed)

    def test_drawings_that_are_no_domain(self):
        cases = {
            "open": (plate()[1:], "is open at", "missing part"),
            "junction": (plate() + [line((0, 0), (1, 0.2))], "ore than two curves"),
            "stub": (plate() + [line((2, 0), (2, 1))], "ends on the LINE"),
            "crossing": (plate()[:4] + [circle((0, 1), 0.5)], ""),
            "touching": (plate()[:4] + [circle((0.5, 1), 0.5)], ""),
            "nothing": ([("TEXT", 10, 0, 20, 0, 1, "x")], "1 TEXT"),
            "words of VTK": ([("A returned failure for request", 10, 0)], "no visible lines"),
            "space": ([("LINE", 10, 0, 20, 0, 30, 0, 11, 1, 21, 0, 31, 1)], "z ranges"),
        }
        for name, (rows, *parts) in cases.items():
            with self.subTest(name):
                self.refuse_text(name + ".dxf", dxf(rows), *parts)
        for ending in ("dxf", "svg", "geojson", "msh", "poly", "off", "step", "brep"):
            for text in ("", "this is no drawing\n"):
                with self.subTest(f"{text!r} as .{ending}"):
                    self.refuse_text("words." + ending, text)

    def test_parts_and_layers_are_chosen(self):
        self.write("plates.dxf", dxf(plate() + [circle((9, 9), 1), line((20, 0), (21, 0), "pin"), line((21, 0), (20, 1), "pin"),
                                                line((20, 1), (20, 0), "pin")]))
        self.refuse("check", "plates.dxf", says=["3 parts", "--part"])
        whole = json.loads(self.succeed("quads", "plates.dxf", "-o", "a.vtu", "--quads", "900", "--json", "-"))
        self.assertEqual(whole["parts"], 3)
        self.assertLess(abs(whole["quads"] - 900), 90)
        self.assertIn("pin", [side["name"] for side in whole["sides"]])
        self.refuse("quads", "plates.dxf", "-o", "b.vtu", "--count", "pin:2", "--size", "0.3",
                    says=["Part 3 of 3 (1 is the largest): ", "pin:2"])
        areas = []
        for part in ("largest", "1", "2", "3", "pin"):
            report = json.loads(self.succeed("quads", "plates.dxf", "-o", "a.vtu", "--quads", "100", "--json", "-", "--part", part))
            areas.append(report["quads"] * report["sizes"]["mean"]**2)
        self.assertEqual(areas[0], areas[1])
        self.assertEqual(areas[3], areas[4])
        self.assertGreater(areas[1], areas[2])
        self.assertGreater(areas[2], areas[3])
        self.refuse("check", "plates.dxf", "--part", "4", says=["no part 4", "3 parts"])
        self.refuse("check", "plates.dxf", "--part", "nowhere", says=["No part of the domain has a side 'nowhere'"])
        result = self.run_program("corners", "plates.dxf", "--drawing-layer", "pin", "--json", "-")
        self.assertEqual((result.returncode, result.stderr), (0, "Warning: 6 curves on other layers were left out.\n"))
        self.assertEqual(len(json.loads(result.stdout)["corners"]), 3)
        self.refuse("check", "plates.dxf", "--drawing-layer", "cut", says=["no curves on the layer 'cut'", "'pin'"])
        self.refuse("check", "builtin:disk", "--drawing-layer", "cut", says=["is no drawing"])

    def test_ends_a_hair_past_the_start(self):
        """Files of others: a closed polyline steps back to its start, and a short open line joins nothing."""
        slot = [(0, 0), (10, 0), (10, 3), (0, 3), (0, -1e-5)]
        rows = [line(a, b) for a, b in zip(slot, slot[1:] + slot[:1])]
        _, printed = self.accept(self.write("past.dxf", dxf(rows)), 1)
        self.assertIn("Gaps between the curves of the drawing were closed", printed)
        short = [line((20, 0), (20.001, 0)), line((20.001, 0), (20.002, 0))]
        _, printed = self.accept(self.write("short.dxf", dxf(rows[:3] + [line((0, 3), (0, 0))] + short)), 1, "--join-tolerance", "0.003")
        self.assertIn("about as short as the gap between their ends were left out: 1.", printed)

    def test_a_layer_that_is_closed_is_offered(self):
        self.write("scored.dxf", dxf(plate() + [line((0.1, 0.1), (0.9, 0.1), "score")]))
        self.refuse("quads", "scored.dxf", "-o", "a.vtu", says=["--drawing-layer 'hole' --drawing-layer 'wall')"])
        result = self.run_program("quads", "scored.dxf", "-o", "a.vtu", "--quads", "100", "--drawing-layer", "hole", "--drawing-layer", "wall")
        self.assertEqual((result.returncode, result.stderr), (0, "Warning: 1 curve on another layer was left out.\n"))

    def test_the_page_of_a_drawing_is_named(self):
        self.write("page.svg", """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 20">
<rect width="40" height="20"/><circle cx="10" cy="10" r="5"/></svg>""")
        result = self.run_program("quads", "page.svg", "-o", "a.vtu", "--quads", "100")
        self.assertIn("The edges of the page, the rect of line 2, are the outer boundary", result.stderr)

    def test_parts_have_one_number_of_quads(self):
        """A share of one quad is no request; sides without an edge are named."""
        self.write("two.dxf", dxf(plate() + [circle((9, 9), 0.02)]))
        report = json.loads(self.run_program("quads", "two.dxf", "-o", "a.vtu", "--quads", "400", "--json", "-").stdout)
        self.assertEqual([text for text in report.get("warnings", []) if "No number of quads" in text], [])
        chamfers = [(0, 0), (9.9, 0), (10, 0.05), (10, 5), (0, 5)]
        self.write("chamfer.dxf", dxf([line(a, b) for a, b in zip(chamfers, chamfers[1:] + chamfers[:1])]))
        report = json.loads(self.run_program("quads", "chamfer.dxf", "-o", "a.vtu", "--quads", "50", "--json", "-").stdout)
        lost = [side["name"] for side in report["sides"] if side["edges"] == 0]
        named = [text for text in report.get("warnings", []) if "have no edge" in text]
        self.assertEqual(len(named), 1 if lost else 0)

    def test_files_of_triangle_and_off(self):
        corpus = pathlib.Path(__file__).parents[1] / "fuzz/corpus"
        report = json.loads(self.succeed("quads", corpus / "poly/plate.poly", "-o", "a.vtu", "--quads", "100", "--json", "-"))
        self.assertEqual({side["name"] for side in report["sides"]}, {"1", "2"})
        report = json.loads(self.succeed("quads", corpus / "off/two.off", "-o", "a.vtu", "--quads", "100", "--json", "-"))
        self.assertEqual(report["irregular"], {})

    def damage_all(self, name, content, copies=30):
        """Expects a domain or one sentence for each damaged copy, and no crash."""
        random_numbers = random.Random(name)
        content = content if isinstance(content, bytes) else content.encode()
        self.accept(self.write(name, content), 1 if name in ("naca.dat", "two.off") else 2)
        for copy in range(copies):
            damaged = damage(content, random_numbers)
            for _ in range(copy % 3):
                damaged = damage(damaged, random_numbers) if damaged else damaged
            self.write(name, damaged)
            started = time.monotonic()
            status, report, printed = self.check(name)
            self.assertIn(status, (0, 1, 2), (copy, printed))
            if status == 2:
                self.assertIsNone(report)
                self.assertRegex(printed.splitlines()[-1] + "\n", SENTENCE, (copy, printed))
            self.assertLess(time.monotonic() - started, 30.0)

    def test_damaged_dxf(self):
        rows = plate()[:4] + [
            ("INSERT", 8, "hole", 2, "round", 10, 1, 20, 1),
            ("LWPOLYLINE", 8, "a", 90, 2, 70, 1, 10, 2.5, 20, 1, 42, 1, 10, 3, 20, 1, 42, 1),
            ("SPLINE", 8, "b", 70, 1, 71, 3, 74, 4, 11, 2.2, 21, 0.5, 11, 2, 21, 0.7, 11, 1.8, 21, 0.5, 11, 2, 21, 0.3)]
        blocks = [("BLOCK", 2, "round", 10, 0, 20, 0), circle((0, 0), 0.5, "0"), ("ENDBLK",)]
        content = dxf(rows, 4, blocks)
        status, report, _ = self.check(self.write("all.dxf", content))
        self.assertEqual((status, report["euler_characteristic"]), (1, -2))
        random_numbers = random.Random(5)
        for _ in range(40):
            self.write("all.dxf", damage(content.encode(), random_numbers))
            status, _, printed = self.check("all.dxf")
            self.assertIn(status, (0, 1, 2), printed)
            if status == 2:
                self.assertRegex(printed.splitlines()[-1] + "\n", SENTENCE)

    def test_damaged_svg(self):
        self.damage_all("plate.svg", drawing_files.SVG)

    def test_damaged_geojson(self):
        self.damage_all("plate.geojson", drawing_files.GEOJSON)

    def test_damaged_msh(self):
        self.damage_all("plate22.msh", drawing_files.msh22())
        self.damage_all("plate41.msh", drawing_files.msh41())
        self.damage_all("binary.msh", drawing_files.msh22_binary())

    def test_damaged_files_of_triangle_and_off(self):
        corpus = pathlib.Path(__file__).parents[1] / "fuzz/corpus"
        self.damage_all("plate.poly", (corpus / "poly/plate.poly").read_text())
        self.damage_all("two.off", (corpus / "off/two.off").read_text())

    def test_damaged_aerofoil(self):
        self.damage_all("naca.dat", drawing_files.naca(20))

    @unittest.skipUnless(HAS_MODELS, "built without Open CASCADE")
    def test_damaged_models(self):
        for name in ("plate.step", "plate.brep"):
            content = (DATA / name).read_bytes()
            self.write("good." + name, content)
            random_numbers = random.Random(name)
            for _ in range(30):
                self.write(name, damage(content, random_numbers))
                status, _, printed = self.check(name)
                self.assertIn(status, (0, 1, 2), printed)
                if status == 2:
                    self.assertRegex(printed.splitlines()[-1] + "\n", SENTENCE)

    @unittest.skipUnless(HAS_MODELS, "built without Open CASCADE")
    def test_models(self):
        for name in ("plate.step", "plate.brep", "tilted.step", "solid.step"):
            with self.subTest(name):
                report, printed = self.accept(DATA / name, 3)
                self.assertEqual(report["drawing"].get("unit"), "mm" if name.endswith("step") else None)
                self.assertEqual("largest planar face" in printed, name == "solid.step")
        content = (DATA / "plate.step").read_text()
        metres = content.replace("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)")
        self.assertNotEqual(metres, content)
        report, _ = self.accept(self.write("metres.step", metres), 3)
        self.assertEqual(report["drawing"]["unit"], "m")

    def test_files_of_other_programs(self):
        report, printed = self.accept(DATA / "ezdxf.dxf", 5)
        self.assertEqual(report["drawing"]["unit"], "mm")
        self.assertIn("MTEXT", printed)
        for name in ("gmsh22.msh", "gmsh41.msh", "gmsh41_binary.msh"):
            report, _ = self.accept(DATA / name, 3)


if __name__ == "__main__":
    unittest.main()
