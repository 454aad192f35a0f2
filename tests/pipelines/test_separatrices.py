"""crossfield separatrices: lines, faces and maps, their numbers and refusals."""
import json
import math
import pathlib
import unittest

from program import ProgramTest, write_configuration

PARTS = pathlib.Path(__file__).resolve().parents[1] / "data" / "parts"
# Positions of the chosen singularities after optimisation, rounded.
PLATE = [(22.0946, 47.969), (22.0489, 32.0739), (38.2651, 32.4271), (38.2075, 47.6329),
         (51.8762, 47.719), (51.9077, 32.2416), (68.1898, 32.3447), (68.1555, 47.6892),
         (81.8021, 47.6477), (81.85, 32.3007), (97.922, 32.04), (97.9498, 47.9262)]
BRACKET = [(6.816, 68.1787), (6.788, 61.8498), (13.2, 61.8376), (13.1694, 68.1943),
           (22.0209, 22.0679), (61.827, 13.191), (61.8298, 6.8068), (68.1736, 6.8088),
           (68.1792, 13.1846)]


class Separatrices(ProgramTest):
    def report(self, domain, *arguments):
        return json.loads(self.succeed("separatrices", domain, "--json", "-", *arguments))

    def test_the_report_has_its_numbers(self):
        # File names by which Verify.Everything finds files that belong together.
        report = self.report("builtin:disk", "-s", "four.csv", "-o", "disk.lines.vtp", "--faces",
                             "disk.faces.vtp", "--map", "disk.vtu")
        self.assertEqual(report["lines"], 12)
        self.assertEqual(report["extra_lines"], 0)
        self.assertEqual(report["flips"], 0)
        self.assertGreater(report["longest"], 0.5)
        self.assertLess(report["mismatch"], 1e-12)
        self.assertEqual(set(report["seconds"]), {"mesh", "map", "trace"})
        for name in ("disk.lines.vtp", "disk.faces.vtp", "disk.vtu"):
            self.assertTrue((self.folder / name).is_file(), name)

    def test_counts_of_reference_cases(self):
        # docs/method.md §13.4; corners alone, a pair, and a ring with one extra line.
        write_configuration(self.folder / "pair.csv", [(0.45, 0.55, 1, 0.1), (1.3, 0.5, -1, 0.1)])
        for domain, options, faces, arcs, extra in (
                ("builtin:l-shape", (), 3, 10, 0), ("builtin:ring", (), 1, 3, 1),
                ("builtin:l-shape", ("-s", "pair.csv"), 9, 26, 0)):
            with self.subTest(domain):
                report = self.report(domain, *options)
                self.assertEqual((report["faces"], report["arcs"], report["extra_lines"]),
                                 (faces, arcs, extra))

    def test_engineering_parts(self):
        # The proposal for these has no singularities. Lines - N + χ faces, 2 lines + corners arcs.
        # Both corners of a trailing edge count, which by default are one: 3 lines instead of 4.
        for part, rows, lines, faces, arcs in (
                ("plate3", [(*place, -1, 0.1) for place in PLATE], 60, 46, 124),
                ("bracket", [(*place, -1, 0.1) for place in BRACKET], 45, 35, 95),
                ("naca_blunt", [(0.0, 0.0, -2, 0.1)], 7, 7, 21),
                ("elbow", None, 0, 1, 4), ("tjunction", None, 4, 4, 13)):
            with self.subTest(part):
                given = ()
                if rows is not None:
                    write_configuration(self.folder / "given.csv", rows)
                    given = ("-s", "given.csv")
                result = self.run_program("separatrices", PARTS / f"{part}.vtp", *given, "--json", "-",
                                          "--thin-boundary", "0", "-o", f"{part}.lines.vtp", "--faces",
                                          f"{part}.faces.vtp", "--map", f"{part}.vtu")
                self.assertEqual(result.returncode, 0, result.stderr)
                report = json.loads(result.stdout)
                self.assertEqual((report["lines"], report["faces"], report["arcs"]),
                                 (lines, faces, arcs))
                self.assertEqual(report["flips"], 0)
                self.assertLess(report["mismatch"], 1e-12 * report["longest"] + 1e-12)

    def test_repair_of_the_holonomy(self):
        # A ring whose defect is Σ k arg b, 0.4 here (docs/method.md §7.3).
        rows = [(r * math.cos(0.1 + turn + i * math.pi / 2), r * math.sin(0.1 + turn + i * math.pi / 2),
                 k, 0.05) for r, turn, k in ((0.8, 0.0, 1), (0.55, -0.1, -1)) for i in range(4)]
        write_configuration(self.folder / "turned.csv", rows)
        report = self.report("builtin:ring", "-s", "turned.csv", "--repair-holonomy", "-o", "ring.lines.vtp",
                             "--faces", "ring.faces.vtp", "--map", "ring.vtu",
                             "--save-singularities", "repaired.csv")
        self.assertAlmostEqual(abs(report["repair"]["defect_before"][0]), 0.4, delta=0.01)
        self.assertGreater(report["repair"]["distance"], 0.01)
        self.assertLess(report["repair"]["distance"], 0.08)
        self.assertEqual((report["faces"], report["arcs"]), (24, 64))
        places = [tuple(map(float, line.split(",")[:2])) for line in
                  (self.folder / "repaired.csv").read_text().splitlines()[1:]]
        self.assertEqual([(one["x"], one["y"]) for one in report["singularities"]], places)
        farthest = max(math.dist(place, row[:2]) for place, row in zip(places, rows))
        self.assertAlmostEqual(farthest, report["repair"]["distance"], delta=1e-12)
        # After the repair there is no warning.
        self.succeed("separatrices", "builtin:ring", "-s", "repaired.csv", "-o", "again.vtp")

    def test_grid_lines_that_do_not_close_up_stretch_the_map(self):
        opposite = [(r * math.cos(turn + i * math.pi / 2), r * math.sin(turn + i * math.pi / 2), k, 0.05)
                    for r, turn, k in ((0.8, 0.0, 1), (0.55, 0.6, -1)) for i in range(4)]
        write_configuration(self.folder / "far.csv", opposite)
        report = self.report("builtin:ring", "-s", "far.csv", "-o", "far.vtp")
        self.assertEqual(report["flips"], 0)
        self.assertGreater(report["stretch"]["predicted"], 1.5)
        self.assertLess(report["stretch"]["predicted"], 2.5)
        self.assertRegex(report["stretch"]["reason"],
                         r"^Quads are stretched by about [0-9.]+ : 1, because the grid lines around "
                         r"inner loop 1 do not close up by [0-9]+°\.$")
        printed = self.succeed("quads", "builtin:ring", "-s", "far.csv", "-o", "far.vtu")
        self.assertIn(report["stretch"]["reason"], printed)

    def test_the_same_bytes_twice(self):
        for name in ("first", "second"):
            self.succeed("separatrices", "builtin:disk", "-s", "four.csv", "-o", f"{name}.vtp",
                         "--map", f"{name}.vtu")
        self.assertEqual(self.digest("first.vtp"), self.digest("second.vtp"))
        self.assertEqual(self.digest("first.vtu"), self.digest("second.vtu"))

    def test_streamlines_from_seeds(self):
        write_configuration(self.folder / "seeds.csv", [(0.1, 0.2, 1, 0.1)])
        self.succeed("separatrices", "builtin:disk", "-s", "four.csv", "--seeds", "seeds.csv",
                     "-o", "lines.vtp")

    def test_what_cannot_be_mapped_is_refused(self):
        write_configuration(self.folder / "three.csv", [(0.4, 0.1, 3, 0.1), (-0.4, 0.1, 1, 0.1)])
        self.refuse("separatrices", "builtin:disk", "-s", "three.csv", "-o", "lines.vtp",
                    says=("quarter index 3", "split it"))
        self.refuse("separatrices", "builtin:disk", "-s", "four.csv", "-o", "lines.vtu",
                    says=(".vtp",))


if __name__ == "__main__":
    unittest.main()
