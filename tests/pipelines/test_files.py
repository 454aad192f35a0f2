"""Input and output files of successful runs: formats, repeatable output, output that is read
again."""

import json
import math
import os
import random
import unittest

import domain_files
from program import FOUR, ProgramTest, write_configuration


class Files(ProgramTest):
    SQUARE = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]

    def test_two_runs_write_the_same_bytes(self):
        for name in ("first.vtu", "second.vtu"):
            self.solve("builtin:disk", "-o", name)
        self.assertEqual(self.digest("first.vtu"), self.digest("second.vtu"))
        self.solve("builtin:disk", "-o", "third.vtu", "--size", "0.1")
        self.assertNotEqual(self.digest("first.vtu"), self.digest("third.vtu"))

    def test_the_number_of_threads_changes_no_byte(self):
        for name, limits in (("many.vtu", {}), ("one.vtu", {
                "OMP_THREAD_LIMIT": "1", "OPENBLAS_NUM_THREADS": "1"})):
            result = self.run_program("solve", "builtin:disk", "-s", "four.csv", "--size", "0.03",
                                      "-o", name, env={**os.environ, **limits})
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.digest("many.vtu"), self.digest("one.vtu"))

    def test_singularities_may_be_a_vtp_file(self):
        domain_files.write_singularities(self.folder / "four.vtp", FOUR)
        for command, ending, *more in (
                ("solve", "vtu"), ("drill", "vtu"), ("hfield", "vtu"), ("optimize", "csv"),
                ("solve", "vtu", "--method", "ginzburg-landau", "--size", "0.2")):
            for source in ("csv", "vtp"):
                self.succeed(command, "builtin:disk", "-s", f"four.{source}", *more,
                             "-o", f"{source}.{ending}")
            with self.subTest(command):
                self.assertEqual(self.digest(f"csv.{ending}"), self.digest(f"vtp.{ending}"))
        for source in ("csv", "vtp"):
            self.succeed("compare", "builtin:disk", "-s", f"four.{source}", "--methods", "unit-norm",
                         "-o", f"{source}.vtm")
        self.assertEqual(self.digest("csv/unit-norm.vtu"), self.digest("vtp/unit-norm.vtu"))

    def test_untidy_segments_write_the_same_bytes(self):
        curves = [[(radius * math.cos(i * math.pi / 32), radius * math.sin(i * math.pi / 32))
                   for i in range(64)] for radius in (1.0, 0.4)]
        points = curves[0] + curves[1]
        domain_files.write_vtp(self.folder / "tidy.vtp", points,
                               [[*range(64), 0], [*range(64, 128), 64]])
        segments = [(curve[i], curve[i - 1]) for curve in curves for i in range(64)]  # clockwise
        random.Random(5).shuffle(segments)
        domain_files.write_vtp(self.folder / "untidy.vtp",
                               [end for pair in segments for end in pair],
                               [[2 * i, 2 * i + 1] for i in range(len(segments))])
        write_configuration(self.folder / "two.csv", [(0.7, 0.0, 1, 0.05), (-0.7, 0.0, -1, 0.05)])
        for name in ("tidy", "untidy"):
            self.solve(f"{name}.vtp", "-o", f"{name}.vtu", singularities="two.csv")
        self.assertEqual(self.digest("tidy.vtu"), self.digest("untidy.vtu"))

    def check_formats(self, corners):
        """Solves on files of one quadrilateral in all formats."""
        points = corners + [(0.75, 1.25)]  # meshes have an inner point
        triangles = [(i, (i + 1) % 4, 4) for i in range(4)]
        for ending in ("vtu", "vtk", "stl", "obj", "ply"):
            writer = getattr(domain_files, f"write_{ending}")
            writer(self.folder / f"domain.{ending}", points, triangles)
        domain_files.write_loop(self.folder / "domain.vtp", corners)
        domain_files.write_csv(self.folder / "domain.csv", corners)
        write_configuration(self.folder / "pair.csv", [(1.5, 1.0, 1, 0.1), (0.5, 1.0, -1, 0.1)])
        expected = self.solve("domain.csv", singularities="pair.csv")
        for ending in ("vtp", "vtu", "vtk", "stl", "obj", "ply"):
            with self.subTest(ending):
                report = self.solve(f"domain.{ending}", singularities="pair.csv")
                self.assertEqual(report["required_interior_quarters"], 0)
                self.assertLess(abs(report["energy"] / expected["energy"] - 1.0), 1e-6)
        return expected["energy"]

    def test_every_format_of_a_square_gives_the_same_field(self):
        energy = self.check_formats(self.SQUARE)
        builtin = self.solve("builtin:square", singularities="pair.csv")["energy"]
        self.assertLess(abs(energy / builtin - 1.0), 1e-6)

    def test_every_format_of_a_trapezium_gives_the_same_field(self):
        # Corners that are exact in single precision, which some formats use.
        self.check_formats([(0.0, 0.0), (2.0, 0.0), (1.75, 2.0), (0.25, 2.0)])

    def test_loops_in_formats_of_meshes(self):
        write_configuration(self.folder / "pair.csv", [(1.5, 1.0, 1, 0.1), (0.5, 1.0, -1, 0.1)])
        expected = self.solve("builtin:square", singularities="pair.csv")["energy"]
        for ending in ("obj", "vtk"):
            name = f"loop.{ending}"
            getattr(domain_files, f"write_loop_{ending}")(self.folder / name, self.SQUARE)
            energy = self.solve(name, singularities="pair.csv")["energy"]
            self.assertLess(abs(energy / expected - 1.0), 1e-6)

    def test_a_csv_loop_may_repeat_its_first_point(self):
        domain_files.write_csv(self.folder / "open.csv", self.SQUARE)
        domain_files.write_csv(self.folder / "closed.csv", self.SQUARE + self.SQUARE[:1])
        write_configuration(self.folder / "none.csv", [])
        for name in ("open", "closed"):
            self.solve(f"{name}.csv", "-o", f"{name}.vtu", singularities="none.csv")
        self.assertEqual(self.digest("open.vtu"), self.digest("closed.vtu"))

    def test_the_program_reads_what_it_writes(self):
        self.succeed("domain", "ring", "-o", "ring.vtp")
        self.succeed("domain", "ring", "-o", "again.vtp")
        self.assertEqual(self.digest("ring.vtp"), self.digest("again.vtp"))
        write_configuration(self.folder / "two.csv", [(0.7, 0.0, 1, 0.05), (-0.7, 0.0, -1, 0.05)])
        fromFile = self.solve("ring.vtp", singularities="two.csv")
        self.assertEqual(fromFile["energy"],
                         self.solve("builtin:ring", singularities="two.csv")["energy"])
        # A drilled mesh is also a domain, whose holes are inner loops.
        self.succeed("drill", "builtin:disk", "-s", "four.csv", "-o", "mesh.vtu")
        write_configuration(self.folder / "none.csv", [])
        result = self.run_program("solve", "mesh.vtu", "-s", "none.csv", "--json", "-")
        self.assertEqual(result.returncode, 1)
        self.assertIn("requires -12", result.stderr)

    def test_options_of_the_domain(self):
        for name in ("disk", "ring", "ellipse", "quarter-disk", "square", "rectangle", "l-shape"):
            self.succeed("domain", name, "-o", f"{name}.vtp")
        self.succeed("domain", "ring", "--inner-radius", "0.6", "--radius", "2", "--size", "0.5",
                     "-o", "other.vtp")
        self.assertNotEqual(self.digest("ring.vtp"), self.digest("other.vtp"))

    def test_an_old_output_is_replaced(self):
        (self.folder / "field.vtu").write_text("old")
        (self.folder / "report.json").write_text("old")
        self.succeed("solve", "builtin:disk", "-s", "four.csv", "-o", "field.vtu", "--json",
                     "report.json")
        self.assertIn("CrossFieldCR", (self.folder / "field.vtu").read_text())
        json.loads((self.folder / "report.json").read_text())
        self.assertEqual(sorted(os.listdir(self.folder)), ["field.vtu", "four.csv", "report.json"])

    def test_radii_are_optional(self):
        rows = [row[:3] for row in FOUR]
        lines = ["x,y,quarter_index"] + [",".join(map(str, row)) for row in rows]
        (self.folder / "bare.csv").write_text("\n".join(lines) + "\n")
        bare = self.solve("builtin:disk", "--size", "0.1", singularities="bare.csv")
        # Without a radius a hole has the size of a triangle.
        self.assertEqual(bare["energy"], self.solve("builtin:disk", "--size", "0.1")["energy"])


if __name__ == "__main__":
    unittest.main()
