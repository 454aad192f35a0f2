"""Coordinates of every size and place: lengths have no unit, and digits are limited."""

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
        # The energies of the field have no unit: they are those of the unit square.
        commands = ("check", "drill", "hfield", "energy", *SOLVES)
        expected = self.solves("square.vtp", self.square(), commands)
        for scale in (1e-50, 1e-12, 1e-8, 1e8, 1e12, 1e50):
            reports = self.solves("square.vtp", self.square(scale), commands)
            for method in SOLVES:
                self.assertAlmostEqual(
                    reports[method]["energy"] / expected[method]["energy"], 1.0, delta=0.02)

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
        # Here the corners fall together.
        self.refuses("square.vtp", self.square(place=1e17), "shrink to a point")


if __name__ == "__main__":
    unittest.main()
