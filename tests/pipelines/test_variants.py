"""Imprinted circles, single triangles and the other variants: `crossfield drill` and `solve`."""

import json
import math
import pathlib
import re

from program import FOUR, ProgramTest, write_configuration

ON_CIRCLE = [math.pi / 4 + i * math.pi / 2 for i in range(4)]


class Variants(ProgramTest):
    def test_quarter_disk_with_an_imprinted_minus_one(self):
        write_configuration(self.folder / "minus.csv", [(0.42, 0.42, -1, 0.15)])
        report = self.solve("builtin:quarter-disk", "--method", "constrained", "--mode", "imprint",
                            "--unit-holes", "-o", "field.vtu", singularities="minus.csv")
        self.assertEqual(report["hole_degree"], [-1])
        for norm in report["hole_norm_range"][0]:
            self.assertAlmostEqual(norm, 1, places=9)
        self.assertIs(report["degrees_reached"], True)
        self.assertIs(report["converged"], True)
        self.assertIs(report["consistent"], False)
        self.assertEqual(report["unwanted_singularities"], 2)
        self.assertEqual(sorted(one["quarter_index"] for one in report["singularities"]),
                         [-1, 1, 1])
        self.assertEqual(sum(one["quarter_index"] for one in report["singularities"]),
                         report["required_interior_quarters"])
        # The field passes the check of its sum.
        check = self.run_program("check", "field.vtu", "--json", "-")
        checked = json.loads(check.stdout)
        self.assertEqual(checked["given_interior_quarters"],
                         checked["required_interior_quarters"])
        # With --mode perforate the configuration is refused; with --strict two singularities are
        # unwanted.
        self.refuse_solve("builtin:quarter-disk", singularities="minus.csv", status=1,
                          says=["add up to -1", "requires 1"])
        strict = self.run_program("solve", "builtin:quarter-disk", "-s", "minus.csv", "--method",
                                  "constrained", "--mode", "imprint", "--unit-hole", 0, "--strict")
        self.assertEqual((strict.returncode, strict.stderr), (1, ""))

    def test_drill_modes(self):
        for mode in ("perforate", "imprint", "triangle"):
            text = self.succeed("drill", "builtin:disk", "-s", "four.csv", "--mode", mode,
                                "-o", mode + ".vtu")
            self.assertRegex(text, r"\d+ triangles")
        self.refuse("drill", "builtin:disk", "-s", "four.csv", "--mode", "cut", "-o", "x.vtu",
                    says=["--mode"])
        write_configuration(self.folder / "two.csv", [(0, 0, 2, 0.1)])
        self.refuse("drill", "builtin:disk", "-s", "two.csv", "--mode", "triangle", "-o", "x.vtu",
                    says=["quarter index 2", "1 or -1"])

    def test_single_triangles_near_and_far(self):
        for distance, reached in ((0.85, True), (0.3, False)):
            write_configuration(
                self.folder / "t.csv",
                [(distance * math.cos(a), distance * math.sin(a), 1, 0.1) for a in ON_CIRCLE])
            arguments = ("solve", "builtin:disk", "-s", "t.csv", "--method", "constrained",
                         "--mode", "triangle", "--epsilon", 0.05, "--size", 0.05)
            result = self.run_program(*arguments, "--json", "-")
            self.assertEqual((result.returncode, result.stderr.count("unwanted")),
                             (0, 0 if reached else 1))
            report = json.loads(result.stdout)
            self.assertIs(report["degrees_reached"], reached)
            self.assertEqual(report["hole_degree"] == [1] * 4, reached)
            self.assertEqual(report["unwanted_singularities"] == 0, reached)
        self.assertIn("NOT the requested ones", self.run_program(*arguments).stdout)

    def test_five_with_the_penalty(self):
        rows = [(0.6 * math.cos(0.3 + i * 0.4 * math.pi), 0.6 * math.sin(0.3 + i * 0.4 * math.pi),
                 1, 0.1) for i in range(5)]
        write_configuration(self.folder / "five.csv", rows)
        self.refuse_solve("builtin:disk", singularities="five.csv", status=1,
                          says=["add up to 5", "requires 4"])
        report = self.solve("builtin:disk", "--method", "constrained", "--epsilon", 0.07,
                            "-o", "five.vtu", singularities="five.csv")
        self.assertEqual(report["hole_degree"], [1] * 5)
        self.assertEqual(report["unwanted_singularities"], 1)
        self.assertEqual([one["quarter_index"] for one in report["singularities"]], [-1])
        self.assertAlmostEqual(report["gradient_energy"] + report["penalty_energy"],
                               report["energy"], places=9)
        self.assertEqual(report["epsilon"], 0.07)
        text = self.succeed("solve", "builtin:disk", "-s", "five.csv", "--method",
                            "constrained", "--epsilon", 0.07)
        self.assertEqual(len(re.findall("quarter index -1 at ", text)), 1)

    def test_global_constraint_and_chosen_unit_holes(self):
        each = self.solve("builtin:disk", "--method", "constrained")
        together = self.solve("builtin:disk", "--method", "constrained", "--global-constraint")
        self.assertLessEqual(together["energy"], each["energy"] * (1 + 1e-9))
        self.assertEqual(together["hole_degree"], [1] * 4)
        chosen = self.solve("builtin:disk", "--method", "constrained", "--unit-hole", 1,
                            "--unit-hole", 3)
        self.assertIs(chosen["unit_holes"], True)
        unit = [abs(low - 1) < 1e-9 and abs(high - 1) < 1e-9
                for low, high in chosen["hole_norm_range"]]
        self.assertEqual(unit, [False, True, False, True])
        self.assertGreater(chosen["energy"], each["energy"])

    def test_options_that_do_not_belong_together(self):
        constrained = ("--method", "constrained")
        self.refuse_solve("builtin:disk", *constrained, "--unit-hole", 7,
                          says=["hole 7", "does not have"])
        self.refuse_solve("builtin:disk", *constrained, "--unit-holes", "--epsilon", 0.1,
                          says=["cannot be combined"])
        self.refuse_solve("builtin:disk", "--method", "unit-norm", "--start", "harmonic",
                          says=["--start harmonic", "unit-norm"])
        self.refuse_solve("builtin:disk", "--method", "unit-norm", "--epsilon", 0.1,
                          says=["--epsilon", "constrained"])
        self.refuse_solve("builtin:disk", "--method", "unit-norm", "--mode", "imprint",
                          says=["needs holes"])
        self.refuse_solve("builtin:disk", "--method", "ginzburg-landau", "--mode", "imprint",
                          says=["do not belong to"])

    def test_options_of_the_constrained_method_choose_it(self):
        for option in (("--unit-hole", 1), ("--unit-holes",), ("--global-constraint",), ("--epsilon", 0.1),
                       ("--mode", "imprint"), ("--start", "harmonic")):
            digests = set()
            for method in ((), ("--method", "constrained")):
                result = self.run_program("solve", "builtin:disk", "-s", "four.csv", "--size", 0.1,
                                          "-o", "field.vtu", *option, *method)
                self.assertEqual(result.returncode, 0, result.stderr)
                digests.add(self.digest("field.vtu"))
            self.assertEqual(len(digests), 1, option)


class Compare(ProgramTest):
    METHODS = ["constrained", "unit-norm", "unit-holes", "global-constraint", "imprint", "penalty",
               "ginzburg-landau"]

    def test_every_default_method_has_a_row_and_a_block(self):
        text = self.succeed("compare", "builtin:disk", "-s", "four.csv", "--size", 0.1,
                            "-o", "all.vtm", "--csv", "all.csv", "--json", "all.json")
        table = json.loads((self.folder / "all.json").read_text())["methods"]
        self.assertEqual([row["method"] for row in table], self.METHODS)
        self.assertEqual(text, "")
        text = self.succeed("compare", "builtin:disk", "-s", "four.csv", "--size", 0.1)
        self.assertEqual(len(text.splitlines()), 1 + len(table))
        lines = (self.folder / "all.csv").read_text().splitlines()
        self.assertEqual(lines[0].split(","), list(table[0]))
        self.assertEqual(len(lines), 1 + len(table))
        for row in table:
            self.assertIs(row["converged"], True)
            self.assertEqual((row["wanted"], row["reached"], row["unwanted"]), (4, 4, 0),
                             row["method"])
            self.assertLessEqual(row["gradient_energy"], row["energy"])
            self.assertLessEqual(0, row["norm_minimum"])
            self.assertLess(row["norm_minimum"], row["norm_maximum"] + 1e-9)
            self.assertGreater(row["seconds"], 0)
            self.assertEqual(row["note"], "")
        by_name = {row["method"]: row for row in table}
        self.assertLess(by_name["constrained"]["energy"], by_name["unit-holes"]["energy"])
        self.assertLess(by_name["unit-holes"]["energy"], by_name["unit-norm"]["energy"])
        index = (self.folder / "all.vtm").read_text()
        for name in self.METHODS:
            self.assertIn(f'name="{name}" file="all/{name}.vtu"', index)
            data = (self.folder / "all" / f"{name}.vtu").read_bytes()
            self.assertNotIn(b"appended", data)
            self.assertIn(b"vtkZLibDataCompressor", data)
            self.assertIn(b'type="Float64" Name="Points"', data)

    def test_it_agrees_with_solve(self):
        solved = self.solve("builtin:disk", "--method", "constrained")
        report = json.loads(self.succeed("compare", "builtin:disk", "-s", "four.csv", "--methods",
                                         "constrained", "--json", "-"))
        self.assertEqual(report["methods"][0]["energy"], solved["energy"])
        self.assertEqual(report["methods"][0]["iterations"], solved["iterations"])

    def test_a_refusal_is_a_row(self):
        write_configuration(self.folder / "three.csv", FOUR[:3])
        result = self.run_program("compare", "builtin:disk", "-s", "three.csv", "--size", 0.1,
                                  "--methods", "constrained,penalty", "--json", "-")
        self.assertEqual((result.returncode, result.stderr), (1, ""))
        refused, penalty = json.loads(result.stdout)["methods"]
        self.assertIn("add up to 3", refused["note"])
        self.assertIs(refused["converged"], False)
        self.assertEqual((penalty["reached"], penalty["unwanted"]), (3, 1))
        self.refuse("compare", "builtin:disk", "-s", "three.csv", "--methods", "constrained",
                    "-o", "none.vtm", status=1, says=["add up to 3"])

    def test_bad_usage(self):
        self.refuse("compare", "builtin:disk", "-s", "four.csv", "-o", "x.vtu", says=[".vtm"])
        self.refuse("compare", "builtin:disk", "-s", "four.csv", "--methods", "guess",
                    says=["--methods"])
        self.refuse("compare", "builtin:disk", "-s", "none.csv", "-o", "x.vtm", says=["'none.csv'"])
        self.refuse("compare", "builtin:disk", "-s", "four.csv", "--csv", "t", "--json", "t",
                    says=["two names"])
        self.refuse("compare", "builtin:nowhere", "-s", "four.csv", "-o", "x.vtm",
                    says=["nowhere"])
        write_configuration(self.folder / "outside.csv", [(3, 0, 1, 0.1)])
        self.refuse("compare", "builtin:disk", "-s", "outside.csv", "-o", "x.vtm",
                    "--methods", "constrained,ginzburg-landau", says=["outside the domain"])
        # A refusal of a single method is a row.
        write_configuration(self.folder / "half.csv", [(0.3, 0, 2, 0.1), (-0.3, 0, 2, 0.1)])
        result = self.run_program("compare", "builtin:disk", "-s", "half.csv", "--methods",
                                  "triangle,unit-norm", "--json", "-")
        self.assertEqual((result.returncode, result.stderr), (1, ""))
        triangle, unit_norm = json.loads(result.stdout)["methods"]
        self.assertIn("1 or -1 only", triangle["note"])
        self.assertEqual((unit_norm["reached"], unit_norm["unwanted"]), (4, 0))


class Page(ProgramTest):
    """The energies in the tables of docs/variants.md, by the first cell of a row."""

    def setUp(self):
        super().setUp()
        text = (pathlib.Path(__file__).resolve().parents[2] / "docs/variants.md").read_text(encoding="utf-8")
        self.rows = {}
        for line in (line for line in text.splitlines() if line.startswith("| ")):
            cells = [cell.strip() for cell in line.strip("| ").split(" | ")]
            self.rows.setdefault(cells[0], cells[1:])
        self.printed = {words[0]: words for words in map(str.split, text.splitlines()) if len(words) == 7}

    def check(self, written, found):
        """Equal up to the rounding of different kernels of OpenBLAS."""
        self.assertAlmostEqual(float(written) / found, 1, delta=0.005)

    def energy(self, domain, rows, *options, method="constrained", status=0):
        write_configuration(self.folder / "rows.csv", rows)
        result = self.run_program("solve", domain, "-s", "rows.csv", "--method", method, *options, "--json", "-")
        self.assertEqual(result.returncode, status, result.stderr)
        return json.loads(result.stdout)["energy"]

    def compare(self, domain, rows, *options):
        write_configuration(self.folder / "rows.csv", rows)
        result = self.run_program("compare", domain, "-s", "rows.csv", *options, "--json", "-")
        return {row["method"]: row for row in json.loads(result.stdout)["methods"]}

    def test_the_methods(self):
        for name, row in self.compare("builtin:disk", FOUR).items():
            words = self.printed[name]
            self.check(words[1], row["energy"])
            for written, key in ((words[2], "norm_minimum"), (words[4], "norm_maximum")):
                self.assertAlmostEqual(float(written), row[key], delta=0.002)
            self.assertEqual(words[5:], [f"{row['reached']}/{row['wanted']}", str(row["unwanted"])])

    def test_imprinted_circles(self):
        for radius in ("0.06", "0.2"):
            self.check(self.rows[radius][-1], self.energy(
                "builtin:quarter-disk", [(0.42, 0.42, -1, radius)], "--mode", "imprint", "--unit-holes",
                "--size", 0.02))

    def test_single_triangles(self):
        for name in ("0.85 (the natural position)", "0.7", "0.5", "0.3"):
            distance = float(name.split()[0])
            rows = [(distance * math.cos(a), distance * math.sin(a), 1, 0.1) for a in ON_CIRCLE]
            self.check(self.rows[name][-1], self.energy(
                "builtin:disk", rows, "--mode", "triangle", "--epsilon", 0.05, "--size", 0.05))

    def test_rings(self):
        for column, ratio in enumerate((0.4, 0.46)):
            ring = f"ring-{ratio}.vtp"
            self.succeed("domain", "ring", "--inner-radius", ratio, "--size", 0.02, "-o", ring)
            for start in ("harmonic", "constant"):
                report = json.loads(self.succeed(
                    "solve", ring, "--method", "ginzburg-landau", "--epsilon", 0.01, "--size", 0.02,
                    "--start", start, "--json", "-"))
                self.check(self.rows[f"reference, {start} start"][column], report["energy"])
            eight = [(one["x"], one["y"], one["quarter_index"], 0.02) for one in report["singularities"]]
            table = self.compare(ring, eight, "--size", 0.02, "--epsilon", 0.01, "--in-place",
                                 "--methods", "constrained,unit-holes,unit-norm,penalty")
            for name, method in (("penalty", "penalty"), ("\\|u\\| = 1", "unit-norm"),
                                 ("unit holes", "unit-holes"), ("one constraint each", "constrained")):
                self.check(self.rows[f"the eight imposed, {name}"][column], table[method]["energy"])

    def test_the_flat_ellipse(self):
        self.succeed("domain", "ellipse", "--width", 6, "--height", 1.2, "--size", 0.06, "-o", "ellipse.vtp")
        rectangle = [(x, y, 1, 0.06) for x in (-2.1, 2.1) for y in (-0.2, 0.2)]
        table = self.compare("ellipse.vtp", rectangle, "--size", 0.06, "--epsilon", 0.06, "--in-place",
                             "--methods", "ginzburg-landau,constrained,unit-norm,penalty")
        for name, method in (("reference, ε = 0.06", "ginzburg-landau"), ("constrained", "constrained"),
                             ("penalty, ε = 0.06", "penalty"), ("unit norm", "unit-norm")):
            self.check(self.rows[name][0], table[method]["energy"])

    def test_wrong_sums(self):
        five = [(0.6 * math.cos(a), 0.6 * math.sin(a), 1, 0.1)
                for a in (math.radians(17 + 72 * i) for i in range(5))]
        seven = [(-0.6, 0.6, 1, 0.1), (-0.6, -0.6, 1, 0.1), (0.6, -0.35, 1, 0.1), (-0.2, 0.2, -1, 0.1),
                 (-0.2, -0.2, -1, 0.1), (0.5, -0.62, -1, 0.05), (0.6, 0.6, -1, 0.1)]
        for name, rows in (("five +1 at r = 0.6", five), ("three +1, four −1, as the paper's figure", seven)):
            self.check(self.rows[name][-1], self.energy(
                "builtin:disk", rows, "--epsilon", 0.05, "--size", 0.05))
