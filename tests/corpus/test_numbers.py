"""Coordinates of all magnitudes and offsets: lengths have no unit, and digits are limited."""

import math
import unittest

import domain_files
import verify
from corpus import SOLVES, CorpusTest, box

PAIR = [(0.25, 0.25, 1, 0.05), (0.75, 0.75, -1, 0.05)]
# Products of their distances are the twelfth power of a length.
TWELVE = [(0.2 + 0.2 * i, 0.25 + 0.25 * j, 1 if (i + j) % 2 else -1, 0.05)
          for i in range(4) for j in range(3)]


class Numbers(CorpusTest):
    def square(self, scale=1.0, place=0.0, rows=PAIR):
        domain_files.write_loop(self.folder / "square.vtp",
                                [(place + scale * x, place + scale * y) for x, y in box(0, 0, 1, 1)])
        return [(place + scale * x, place + scale * y, quarter, scale * radius)
                for x, y, quarter, radius in rows]

    def test_scales(self):
        # Energies of fields have no unit. W grows by π Σ k² log(scale), also at the optimum.
        rows = [(0.25, 0.25, 2, 0.05), (0.75, 0.7, 1, 0.05), (0.3, 0.75, -2, 0.05), (0.7, 0.2, -1, 0.05)]
        commands = ("check", "drill", "hfield", "energy", *SOLVES)
        expected = self.solves("square.vtp", self.square(rows=rows), commands)
        for scale in (1e-50, 1e-12, 1e-8, 1e8, 1e12, 1e50):
            reports = self.solves("square.vtp", self.square(scale, rows=rows), commands)
            for method in SOLVES:
                self.assertAlmostEqual(
                    reports[method]["energy"] / expected[method]["energy"], 1.0, delta=0.02)
            shift = 10 * math.pi * math.log(scale)
            row, = reports["energy"]["configurations"]
            plain, = expected["energy"]["configurations"]
            for found, given in ((reports["hfield"], expected["hfield"]), (row, plain)):
                self.assertAlmostEqual(
                    found["renormalized_energy"] - shift, given["renormalized_energy"], delta=0.1)
            for key in ("energy", "energy_degree_only"):
                self.assertAlmostEqual(row[key] / plain[key], 1.0, delta=0.005)
            self.assertLess(row["energy_lower_bound"], plain["energy_upper_bound"])
            self.assertLess(plain["energy_lower_bound"], row["energy_upper_bound"])
            self.assertAlmostEqual(row["logarithm_coefficient"], 10 * math.pi, delta=1e-9)

    def test_optima_at_all_scales(self):
        # Four singularities in a disk: the exact radius (3/11)^(1/8), W = -7.2962.
        for scale in (1e-50, 1e-12, 1e12, 1e50):
            domain_files.write_loop(self.folder / "disk.vtp", [
                (scale * math.cos(math.pi * i / 40), scale * math.sin(math.pi * i / 40))
                for i in range(80)])
            rows = [(scale * x, scale * y, 1, 0.05 * scale)
                    for x, y in ((0.1, 0.2), (-0.3, 0.5), (-0.5, -0.6), (0.3, 0.05))]
            report = self.solves("disk.vtp", rows, ("optimize",))["optimize"]
            self.assertAlmostEqual(
                report["renormalized_energy_after"] - 4 * math.pi * math.log(scale), -7.2962, delta=0.03)
            for point in report["singularities"]:
                self.assertAlmostEqual(
                    math.hypot(point["x"], point["y"]) / scale, (3 / 11) ** 0.125, delta=2e-3)

    def test_many_singularities_at_all_scales(self):
        # W grows by π Σ k² log(scale), H is the same.
        expected = self.solves("square.vtp", self.square(rows=TWELVE), ("hfield",))["hfield"]
        for scale in (1e-59, 1e-50, 1e-35, 1e35, 1e50, 1e59):
            report = self.solves("square.vtp", self.square(scale, rows=TWELVE), ("hfield",))["hfield"]
            self.assertAlmostEqual(
                report["renormalized_energy"] - len(TWELVE) * math.pi * math.log(scale),
                expected["renormalized_energy"], delta=0.1)
            verified = verify.verify(self.folder / "h.vtu")
            self.assertTrue(verified.checks)
            self.assertFalse(verified.failures(), verified.text(everything=False))

    def test_scales_beyond_the_limits(self):
        for scale in (1e-300, 1e-61, 1e61, 1.7e308):
            self.refuses("square.vtp", self.square(scale), "in another unit of length",
                         ("check", "corners", "drill", "unit-norm", "hfield", "energy", "optimize"))

    def test_places(self):
        self.verify_all = False
        commands = ("check", "drill", "hfield", "energy", *SOLVES)
        expected = self.solves("square.vtp", self.square(), commands)
        for place in (1e5, 1e8, -1e8, 1e9):
            reports = self.solves("square.vtp", self.square(place=place), commands)
            for method in SOLVES:
                self.assertAlmostEqual(
                    reports[method]["energy"] / expected[method]["energy"], 1.0, delta=0.02)

    def test_places_where_too_few_digits_are_left(self):
        for place in (1e12, -1e14):
            self.refuses("square.vtp", self.square(place=place), "move the domain to the origin",
                         ("drill", *SOLVES, "hfield", "energy", "optimize", "compare"))
        # Here the corners coincide.
        self.refuses("square.vtp", self.square(place=1e17), "shrink to a point")


if __name__ == "__main__":
    unittest.main()
