"""Singularities at the limits: holes very close to other features, large quarter indices, many
holes."""

import math
import unittest

import domain_files
from corpus import DRILLS, SOLVES, CorpusTest, box

HAIRS = (1e-2, 1e-4, 1e-6, 1e-9, 1e-12)


class Configurations(CorpusTest):
    def setUp(self):
        super().setUp()
        domain_files.write_loop(self.folder / "square.vtp", box(-1, -1, 1, 1))

    def test_holes_very_close_to_the_boundary(self):
        for hair in HAIRS:
            rows = [(0.0, -0.875 + hair, 1, 0.125), (0.5, 0.5, -1, 0.125)]
            self.solves("square.vtp", rows, ("drill", *SOLVES))
        self.verify_all = False
        # At the rounding of the coordinates the constrained method reports that it did not
        # converge.
        self.solves("square.vtp", [(0.0, -0.875 + 1e-15, 1, 0.125), (0.5, 0.5, -1, 0.125)],
                    ("drill", "unit-norm"))
        rows = [(0.0, -0.875, 1, 0.125), (0.5, 0.5, -1, 0.125)]
        self.refuses("square.vtp", rows, "cuts the boundary", DRILLS)

    def test_holes_very_close_to_each_other(self):
        for hair in HAIRS:
            rows = [(-0.125 - hair, 0.0, 1, 0.125), (0.125, 0.0, -1, 0.125)]
            self.solves("square.vtp", rows, ("drill", *SOLVES))
        rows = [(-0.125, 0.0, 1, 0.125), (0.125, 0.0, -1, 0.125)]
        self.refuses("square.vtp", rows, "overlap", DRILLS)

    def test_quarter_indices(self):
        for quarter in (1, 2, 4, 8):
            rows = [(-0.4, 0.0, quarter, 0.1), (0.4, 0.0, -quarter, 0.1)]
            self.solves("square.vtp", rows, ("check", "drill", "hfield", *SOLVES))
        # Beyond that the crosses turn too fast for the triangles beside the holes: single triangles
        # have indices of both signs, which add up to zero. The degrees are still correct.
        rows = [(-0.4, 0.0, 30, 0.1), (0.4, 0.0, -30, 0.1)]
        self.verify_all = False
        self.solves("square.vtp", rows, ("unit-norm",))
        self.solves("square.vtp", rows, ("unit-norm",), more=("--size", "0.015"))

    def test_quarter_indices_beyond_the_limit(self):
        for quarter in (1001, -1001, 2 ** 28, 2 ** 31 - 1, -2 ** 31, 2 ** 31, 2 ** 63, 10 ** 300):
            rows = [(-0.4, 0.0, quarter, 0.1), (0.4, 0.0, -quarter, 0.1)]
            self.refuses("square.vtp", rows, "beyond 1000",
                         ("check", *DRILLS, "hfield", "energy", "optimize"))

    def test_quarter_indices_of_corners_beyond_the_limit(self):
        for quarter in (1001, 2 ** 31, 10 ** 300):
            (self.folder / "corners.csv").write_text(f"x,y,quarter_index\n1,1,{quarter}\n")
            self.refuses("square.vtp", [], "beyond 1000", ("unit-norm", "hfield"),
                         more=("--corners", "corners.csv"))

    def grid(self, count):
        """Returns alternating holes whose gaps are half of their distances."""
        side = math.isqrt(count - 1) + 1
        step = 1.8 / side
        return [(-0.9 + step * (0.5 + i % side), -0.9 + step * (0.5 + i // side),
                 1 if (i // side + i % side) % 2 == 0 else -1, 0.25 * step) for i in range(count)]

    def test_many_holes(self):
        self.solves("square.vtp", self.grid(100), ("check", "drill", "hfield", "unit-norm"))
        self.solves("square.vtp", self.grid(16), ("constrained",))

    def test_a_thousand_points_and_holes(self):
        # The mesh and H are sparse; only the solver on holes is dense in their edges.
        self.solves("square.vtp", self.grid(1024), ("check", "drill", "hfield"))


if __name__ == "__main__":
    unittest.main()
