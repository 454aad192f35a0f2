"""Tests of verified.py: it finds errors in fields."""

import unittest
from unittest import mock

import numpy as np

import verified
from corpus import CorpusTest


class Verified(CorpusTest):
    def test_finds_corrupted_values(self):
        self.solves("builtin:disk", "four.csv", ("unit-norm",))
        path = self.folder / "unit.vtu"
        line = np.flatnonzero(verified.read(path)["CellData", "BoundaryKind"] == 1)[0]
        hole = verified.read(path)["CellData", "BoundaryId"] == 2
        hole &= verified.read(path)["CellData", "BoundaryKind"] == 3
        u = verified.read(path)["CellData", "CrossFieldCR"]
        for name, where, value, word in (
                ("CrossFieldCR", line, -u[line], "alignment"), ("CrossNorm", 0, np.nan, "finite"),
                ("QuarterIndex", hole, 2, "degree 1 instead of 2"),
                ("CrossFieldCR", hole, u[hole] * [[1, -1] * 3], "degree -1 instead of 1")):
            arrays = {key: values.copy() for key, values in verified.read(path).items()}
            arrays["CellData", name][where] = value
            with mock.patch.object(verified, "read", return_value=arrays):
                self.assertIn(word, verified.verified(path))
        # Holes that are consistent, but do not fit the domain.
        arrays = {key: values.copy() for key, values in verified.read(path).items()}
        arrays["CellData", "CrossFieldCR"][hole] = 1.0, 0.0, 1.0, 0.0, 1.0, 0.0
        arrays["CellData", "QuarterIndex"][hole] = 0
        with mock.patch.object(verified, "read", return_value=arrays):
            self.assertIn("add up to 3", verified.verified(path))


if __name__ == "__main__":
    unittest.main()
