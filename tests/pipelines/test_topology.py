"""`check` and `corners`: reports, exit statuses, proposals, and errors of bad input."""

import json
import math
import re
import unittest

import domain_files
from program import SENTENCE, ProgramTest, write_configuration

# Required sum of the interior singularities, with corners by the smallest rotation.
REQUIRED = {"disk": 4, "ring": 0, "ellipse": 4, "quarter-disk": 1, "square": 0, "rectangle": 0,
            "l-shape": 0, "hexagonal": -2, "star": -1, "angular-balanced": 0,
            "angular-negative": -2, "angular-positive": 2, "angular-hole": -2}

CHECK_KEYS = {"euler_characteristic", "valence", "tangent_turning", "required_interior_quarters",
              "given_interior_quarters", "consistent", "holonomy_defect", "corners", "loops",
              "reason"}
CORNER_KEYS = {"x", "y", "angle", "quarter_index", "quarter_index_scarce",
               "quarter_index_balanced", "quarter_index_excess", "quarter_index_conventional",
               "corner_energy", "cancellable", "tied", "overridden"}


class TopologyTest(ProgramTest):
    def check(self, domain, *arguments, status=0):
        """Returns the report of `check`; with status 1 its reason is also on standard error."""
        result = self.run_program("check", domain, *arguments, "--json", "-")
        self.assertEqual(result.returncode, status, (result.args, result.stderr))
        report = json.loads(result.stdout)
        self.assertEqual(report["consistent"], status == 0)
        self.assertEqual(result.stderr, "" if status == 0 else f"crossfield: {report['reason']}\n")
        return report

    def corners(self, domain, *arguments):
        return json.loads(self.succeed("corners", domain, *arguments, "--json", "-"))


class Check(TopologyTest):
    def test_keys_and_types(self):
        report = self.check("builtin:disk", "-s", "four.csv")
        self.assertEqual(set(report), CHECK_KEYS)
        for key in ("euler_characteristic", "required_interior_quarters",
                    "given_interior_quarters"):
            self.assertIs(type(report[key]), int, key)
        for key in ("valence", "tangent_turning"):
            self.assertIs(type(report[key]), float, key)
        self.assertEqual(report["holonomy_defect"], [])
        self.assertEqual(report["corners"], [])
        self.assertEqual(report["given_interior_quarters"], 4)
        self.assertTrue(report["reason"].endswith("."))
        corners = self.check("builtin:square")["corners"]
        self.assertEqual(len(corners), 4)
        for corner in corners:
            self.assertEqual(set(corner), {"x", "y", "angle", "quarter_index", "cancellable"})
            self.assertAlmostEqual(corner["angle"], math.pi / 2)
            self.assertEqual(corner["quarter_index"], 1)
            self.assertIs(corner["cancellable"], False)

    def test_required_sum_of_every_builtin_domain(self):
        for name, required in REQUIRED.items():
            with self.subTest(name):
                report = self.check(f"builtin:{name}", "--no-cap-corners", status=0 if required == 0 else 1)
                self.assertEqual(report["required_interior_quarters"], required)
                total = 4 * (report["valence"] + report["tangent_turning"])
                self.assertAlmostEqual(total, required)
                quarters = sum(corner["quarter_index"] for corner in report["corners"])
                self.assertEqual(4 * report["euler_characteristic"] - quarters, required)
                self.assertEqual(sum(loop["required_part"] for loop in report["loops"]), required)

    def test_very_sharp_corners_require_the_sum_of_quads(self):
        report = self.check("builtin:star", status=1)
        self.assertEqual(report["required_interior_quarters"], 4)
        self.assertIn("5 very sharp corners count as ordinary ones, with one quad; without this the sum is -1 ",
                      report["reason"])
        self.check("builtin:star", "--propose", "star.csv")
        self.succeed("quads", "builtin:star", "-s", "star.csv", "--quads", "1000", "-o", "quads.vtu")

    def test_an_inconsistent_configuration_says_what_to_do(self):
        write_configuration(self.folder / "one.csv", [(0.0, 0.0, 1, 0.1)])
        reason = self.check("builtin:disk", "-s", "one.csv", status=1)["reason"]
        for part in ("add up to 1 ", "requires 4 ", "total 3."):
            self.assertIn(part, reason)
        self.assertNotIn("remove", reason, "there are none of negative index")
        # The solver refuses it with the same sentence.
        for method in ("constrained", "unit-norm"):
            message = self.refuse_solve("builtin:disk", "--method", method,
                                        singularities="one.csv", status=1)
            self.assertEqual(message, f"crossfield: {reason}\n")
        result = self.run_program("check", "builtin:disk", "-s", "one.csv")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, SENTENCE)
        self.assertIn("required 4, given 1", result.stdout)

    def test_the_result_comes_first_and_hints_at_other_corners(self):
        for domain, hint in (("builtin:disk", False), ("builtin:hexagonal", True)):
            lines = self.run_program("check", domain).stdout.splitlines()
            self.assertTrue(lines[0].startswith("The quarter indices"), lines)
            self.assertEqual(any("cheapest quarter indices" in line for line in lines), hint)

    def test_the_penalty_accepts_what_the_check_refuses(self):
        write_configuration(self.folder / "one.csv", [(0.0, 0.0, 1, 0.1)])
        self.check("builtin:disk", "-s", "one.csv", status=1)
        self.succeed("solve", "builtin:disk", "-s", "one.csv", "--method", "ginzburg-landau",
                     "--size", "0.1", "-o", "field.vtu")
        # The field has further singularities that correct the sum.
        self.assertEqual(self.check("field.vtu")["given_interior_quarters"], 4)

    def test_holonomy(self):
        write_configuration(self.folder / "two.csv", [(0.7, 0.0, 1, 0.05), (0.2, 0.65, -1, 0.05)])
        report = self.check("builtin:ring", "-s", "two.csv")
        self.assertEqual(len(report["holonomy_defect"]), 1)
        # On a ring around 0: Σ k_j arg b_j.
        self.assertAlmostEqual(report["holonomy_defect"][0], -math.atan2(0.65, 0.2), delta=1e-3)
        self.assertIn("inner loop 1", report["reason"])

    def test_proposals_can_be_solved(self):
        for name, required in REQUIRED.items():
            for flags in ((), ("--cancel-flat",)):
                with self.subTest(f"{name} {flags}"):
                    report = self.check(f"builtin:{name}", "--no-cap-corners", "--propose", "proposal.csv", *flags)
                    self.assertEqual(report["given_interior_quarters"], required)
                    if required == 0 and name != "angular-balanced":
                        continue  # nothing is proposed
                    self.check(f"builtin:{name}", "--no-cap-corners", "-s", "proposal.csv")
                    self.succeed("solve", f"builtin:{name}", "-s", "proposal.csv", "--method",
                                 "unit-norm", "--strict", "--json", "report.json")

    def test_a_proposal_keeps_what_is_given(self):
        write_configuration(self.folder / "one.csv", [(0.25, 0.5, 3, 0.125)])
        self.check("builtin:disk", "-s", "one.csv", "--propose", "more.csv", status=1)
        lines = (self.folder / "more.csv").read_text().splitlines()
        self.assertEqual(lines[:2], ["x,y,quarter_index,radius", "0.25,0.5,3,0.125"])
        self.assertEqual(len(lines), 3)
        self.check("builtin:disk", "-s", "more.csv")

    def test_given_rows_without_radius_stay_without(self):
        (self.folder / "one.csv").write_text("x,y,quarter_index\n0.25,0.5,3\n")
        self.check("builtin:disk", "-s", "one.csv", "--propose", "more.csv", status=1)
        lines = (self.folder / "more.csv").read_text().splitlines()
        self.assertEqual(lines[:2], ["x,y,quarter_index", "0.25,0.5,3"])
        self.check("builtin:disk", "-s", "more.csv")

    def test_alternatives_are_consistent_and_compared(self):
        text = self.run_program("check", "builtin:hexagonal", "--propose", "start.csv",
                                "--alternatives", "4").stdout.splitlines()
        head = next(i for i, line in enumerate(text) if line.startswith("alternative "))
        rows = []
        for line in text[head + 1:]:
            if not re.match(r"\d", line):
                break
            rows.append(line.split())
        self.assertGreaterEqual(len(rows), 3)
        energies = [float(row[4]) for row in rows]
        self.assertEqual(energies[1:], sorted(energies[1:]))
        for i in range(len(rows)):
            name = f"start_{i}.csv" if i else "start.csv"
            self.check("builtin:hexagonal", "-s", name)

    def test_flat_angles_of_the_paper(self):
        def signs(name):
            self.check(f"builtin:{name}", "--propose", "pairs.csv", "--cancel-flat")
            rows = (self.folder / "pairs.csv").read_text().splitlines()[1:]
            return [int(row.split(",")[2]) for row in rows]
        self.assertEqual(signs("angular-balanced"), [1, -1])
        self.assertEqual(signs("angular-hole"), [1, 1, -1, -1, -1, -1])

    def test_a_solved_field_is_checked_itself(self):
        self.solve("builtin:disk", "-o", "field.vtu")
        report = self.check("field.vtu")
        self.assertEqual(report["required_interior_quarters"], 4)
        self.assertEqual(report["given_interior_quarters"], 4)

    def test_chosen_corners(self):
        self.succeed("corners", "builtin:angular-negative", "-o", "corners.vtp")
        self.assertEqual(self.check("builtin:angular-negative", "--corners", "corners.vtp")
                         ["required_interior_quarters"], 0)
        write_configuration(self.folder / "pair.csv", [(-0.5, 0.0, 1, 0.05), (0.5, 0.0, -1, 0.05)])
        self.refuse_solve("builtin:angular-negative", "--method", "unit-norm",
                          singularities="pair.csv", says=["requires -2"], status=1)
        self.solve("builtin:angular-negative", "--method", "unit-norm", "--strict", "--corners",
                   "corners.vtp", singularities="pair.csv")
        # From a table, for one corner only.
        (self.folder / "flat.csv").write_text("x,y,quarter_index\n0,0,0\n")
        report = self.check("builtin:square", "--corners", "flat.csv", status=1)
        self.assertEqual(report["required_interior_quarters"], 1)


class Corners(TopologyTest):
    def test_keys_and_types(self):
        report = self.corners("builtin:star", "-o", "corners.vtp")
        self.assertEqual(set(report), {"scenario", "energy", "interior_quarters", "scenarios",
                                       "corners", "split"})
        self.assertEqual(list(report["scenarios"]), ["scarce", "balanced", "excess"])
        for scenario in report["scenarios"].values():
            self.assertEqual(set(scenario), {"sum", "energy", "feasible"})
            self.assertIs(type(scenario["sum"]), int)
            self.assertIs(type(scenario["feasible"]), bool)
        self.assertEqual(len(report["corners"]), 10)
        for corner in report["corners"]:
            self.assertEqual(set(corner), CORNER_KEYS)
            for flag in ("cancellable", "tied", "overridden"):
                self.assertIs(type(corner[flag]), bool, flag)
        text = (self.folder / "corners.vtp").read_text()
        arrays = set(re.findall(r'<DataArray [^>]*Name="(\w+)"', text))
        self.assertLessEqual({"Angle", "QuarterIndex", "QuarterIndexScarce", "CornerEnergy",
                              "Cancellable"}, arrays)

    def test_energies_add_up(self):
        for name in REQUIRED:
            with self.subTest(name):
                report = self.corners(f"builtin:{name}")
                energy = sum(corner["corner_energy"] for corner in report["corners"])
                energy += math.pi / 16 * abs(report["interior_quarters"])
                self.assertAlmostEqual(report["energy"], energy)
                for corner in report["corners"]:
                    rest = math.pi - corner["angle"] - corner["quarter_index"] * math.pi / 2
                    self.assertAlmostEqual(corner["corner_energy"], rest**2 / 2 / corner["angle"])
                chosen = report["scenarios"][report["scenario"]]
                self.assertTrue(chosen["feasible"])
                self.assertAlmostEqual(chosen["energy"], report["energy"])
                for scenario in report["scenarios"].values():
                    self.assertGreaterEqual(scenario["energy"], report["energy"] - 1e-9)

    def test_overrides_and_options(self):
        report = self.corners("builtin:square", "--override", "0", "0", "2", "--override", "2",
                              "2", "0")
        indices = {(corner["x"], corner["y"]): corner["quarter_index"]
                   for corner in report["corners"]}
        self.assertEqual(indices[(0.0, 0.0)], 2)
        self.assertEqual(indices[(2.0, 2.0)], 0)
        domain_files.write_loop(self.folder / "sharp.vtp", [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0)])
        self.assertEqual(self.corners("sharp.vtp")["split"], [])
        split = self.corners("sharp.vtp", "--split")["split"]
        self.assertEqual([point["quarter_index"] for point in split], [1])
        plain, printed = (self.corners("builtin:disk", *flags)["energy"]
                          for flags in ((), ("--printed-coefficient",)))
        self.assertAlmostEqual(printed, 2 * plain)

    def test_a_table_without_json(self):
        text = self.succeed("corners", "builtin:angular-balanced")
        self.assertEqual(text.count("cancellable"), 2)
        self.assertRegex(text, r"balanced: sum 4, energy \S+, chosen\n")


class BadInput(TopologyTest):
    def test_check(self):
        check = ("check", "builtin:disk")
        write_configuration(self.folder / "far.csv", [(3.0, 0.0, 4, 0.1)])
        self.refuse(*check, "-s", "far.csv", "--json", "report.json", says=["outside", "(3, 0)"])
        write_configuration(self.folder / "half.csv", [(0.0, 0.0, 0.5, 0.1)])
        self.refuse(*check, "-s", "half.csv", says=["not an integer"])
        self.refuse(*check, "-s", "none.csv", says=["'none.csv'"])
        self.refuse(*check, "--corners", "four.csv", says=["not a vertex"])
        self.refuse(*check, "--propose", "proposal.txt", says=[".csv"])
        self.refuse(*check, "--propose", "no/where.csv", says=["folder"])
        self.refuse(*check, "--json", "no/report.json", says=["folder"])
        self.refuse("check", "builtin:triangle", says=["'triangle'"])
        self.refuse("check", "none.vtp", says=["'none.vtp'"])
        self.refuse("check", says=["DOMAIN"])
        domain_files.write_vtp(self.folder / "open.vtp", [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)],
                               [[0, 1, 2]])
        self.refuse("check", "open.vtp", "--json", "-", says=["open curve"])

    def test_corners(self):
        self.refuse("corners", "builtin:disk", "--override", "0", "0", "1", says=["no corners"])
        self.refuse("corners", "builtin:square", "--override", "0", "0", "0.5",
                    says=["not an integer"])
        self.refuse("corners", "builtin:square", "--override", "0", "0")
        self.refuse("corners", "builtin:square", "-o", "corners.csv", says=[".vtp"])
        self.refuse("corners", "builtin:triangle", "-o", "corners.vtp", says=["'triangle'"])


if __name__ == "__main__":
    unittest.main()
