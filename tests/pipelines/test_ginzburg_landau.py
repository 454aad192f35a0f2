"""The reference method: `crossfield solve --method ginzburg-landau`."""

import json
import math

from program import ProgramTest


class GinzburgLandau(ProgramTest):
    def reference(self, domain, *arguments):
        """Returns the report of the method as a dictionary."""
        return json.loads(self.succeed(
            "solve", domain, "--method", "ginzburg-landau", "--json", "-", *arguments))

    def test_ring_depends_on_the_start(self):
        options = ("--epsilon", 0.01, "--size", 0.04)
        radial = self.reference("builtin:ring", *options)  # r1 / r2 = 0.4
        self.assertAlmostEqual(radial["energy"], 45.9, delta=0.3)
        self.assertEqual(radial["singularities"], [])
        self.assertEqual(radial["unwanted_singularities"], 0)
        broken = self.reference("builtin:ring", *options, "--start", "constant")
        self.assertAlmostEqual(broken["energy"], 99.8, delta=4.0)
        self.assertEqual(sorted(one["quarter_index"] for one in broken["singularities"]),
                         [-1] * 4 + [1] * 4)
        self.assertEqual(broken["unwanted_singularities"], 8)
        for report in (radial, broken):
            self.assertIs(report["converged"], True)
            self.assertIs(report["consistent"], True)
            self.assertAlmostEqual(report["gradient_energy"] + report["penalty_energy"],
                                   report["energy"], places=9)
            self.assertEqual(report["epsilon"], 0.01)
            self.assertEqual(report["hole_degree"], [])
            self.assertEqual(report["hole_norm_range"], [])
            self.assertEqual(set(report["seconds"]),
                             {"mesh", "assemble", "factor", "solve", "write"})

    def test_four_in_the_disk_without_a_configuration(self):
        report = self.reference("builtin:disk", "-o", "field.vtu", "--strict")
        self.assertEqual([one["quarter_index"] for one in report["singularities"]], [1] * 4)
        for one in report["singularities"]:
            self.assertAlmostEqual(math.hypot(one["x"], one["y"]), 0.85, delta=0.04)
        self.assertEqual(report["required_interior_quarters"], 4)
        self.assertEqual(report["given_interior_quarters"], 4)
        self.assertGreater((self.folder / "field.vtu").stat().st_size, 0)

    def test_a_configuration_changes_nothing(self):
        without = self.reference("builtin:disk", "--size", 0.15)
        given = self.reference("builtin:disk", "--size", 0.15, "-s", "four.csv")
        del without["seconds"], given["seconds"]
        self.assertEqual(given, without)
        self.refuse("solve", "builtin:disk", "-s", "none.csv", "--method", "ginzburg-landau",
                    says=["'none.csv'"])

    def test_zero_start_and_summary(self):
        text = self.succeed("solve", "builtin:disk", "--method", "ginzburg-landau",
                            "--start", "zero", "--size", 0.15)
        self.assertRegex(text, r"\Aenergy \d+\.\d+ \(gradient \d.*, penalty \d.*\), converged")
        self.assertEqual(text.count("quarter index 1 at "), 4)

    def test_unwanted_singularities_and_strict(self):
        result = self.run_program("solve", "builtin:ring", "--method", "ginzburg-landau",
                                  "--start", "constant", "--epsilon", 0.02, "--size", 0.1,
                                  "--strict")
        self.assertEqual((result.returncode, result.stderr), (1, ""))

    def test_options_of_another_method_are_refused(self):
        self.refuse("solve", "builtin:disk", "--method", "ginzburg-landau", "--start", "unit-norm",
                    says=["--start unit-norm", "ginzburg-landau"])
        self.refuse("solve", "builtin:disk", "-s", "four.csv", "--start", "constant",
                    "--method", "constrained", says=["--start constant", "constrained"])
        self.refuse("solve", "builtin:disk", "--method", "ginzburg-landau", "--epsilon", -1,
                    says=["--epsilon"])
