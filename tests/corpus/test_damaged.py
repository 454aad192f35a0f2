"""Damages correct files: truncates them or changes single bytes, always at the same positions."""

import json
import random
import unittest

import domain_files
from corpus import CorpusTest, box
from program import SENTENCE
from verified import verified

SQUARE = box(0.0, 0.0, 1.0, 1.0)
TRIANGLES = [(0, 1, 2), (0, 2, 3)]
LOOPS = {"vtp": domain_files.write_loop, "csv": domain_files.write_csv}
CUTS = 12
CHANGES = 16
#: Formats without counts of points and cells: a truncated file may be another valid domain.
COUNTLESS = ("csv", "obj", "stl")


class Damaged(CorpusTest):
    def good(self, ending):
        path = self.folder / f"good.{ending}"
        if ending in LOOPS:
            LOOPS[ending](path, SQUARE)
        else:
            getattr(domain_files, f"write_{ending}")(path, SQUARE, TRIANGLES)
        return path.read_bytes()

    def go_through(self, ending, data):
        """Runs `check` and, if the file is a valid domain, a solve with the required sum of
        indices."""
        name = f"bad.{ending}"
        (self.folder / name).write_bytes(data)
        self.lay_out_old_files()
        before = self.snapshot()
        result = self.run_program("check", name, "--json", "-")
        self.assertIn(result.returncode, (0, 1, 2), result)
        self.assertEqual(self.snapshot(), before)
        if result.returncode == 2:
            # A reader of VTK may print warnings first.
            self.assertRegex(result.stderr.splitlines(True)[-1], SENTENCE)
            self.refused += 1
            return False
        report = json.loads(result.stdout)
        rows = self.configuration([])
        solve = self.run_program("solve", name, "-s", rows, "-o", "unit.vtu", "--method", "unit-norm")
        if "total_curvature" in report:  # a surface in space, for which solve has no field
            self.assertEqual(solve.returncode, 2, solve)
            self.assertRegex(solve.stderr, SENTENCE)
            self.refused += 1
            return False
        if report["required_interior_quarters"] == 0:
            self.assertEqual(solve.returncode, 0, solve)
            self.assertIsNone(verified(self.folder / "unit.vtu"))
            self.solved += 1
        else:
            self.assertEqual(solve.returncode, 1, solve)
            self.assertRegex(solve.stderr, SENTENCE)
            self.answered += 1
        return True

    def cut(self, ending):
        good = self.good(ending)
        whole = len(good.rstrip())
        taken = [size for size in sorted({whole * i // CUTS for i in range(CUTS)} | {whole - 1})
                 if self.go_through(ending, good[:size])]
        self.assertTrue(self.go_through(ending, good))
        if ending not in COUNTLESS:
            # The last digit of the last number may be missing, but no number.
            self.assertLessEqual(len(taken), 1, taken)

    def change(self, ending):
        good = self.good(ending)
        chance = random.Random(ending)
        for _ in range(CHANGES):
            data = bytearray(good)
            data[chance.randrange(len(data))] = chance.choice(b"\0\n -9.eEx<>\"\x80\xff")
            self.go_through(ending, bytes(data))

    def test_cut_vtp(self):
        self.cut("vtp")

    def test_cut_vtu(self):
        self.cut("vtu")

    def test_cut_vtk(self):
        self.cut("vtk")

    def test_cut_stl(self):
        self.cut("stl")

    def test_cut_obj(self):
        self.cut("obj")

    def test_cut_ply(self):
        self.cut("ply")

    def test_cut_csv(self):
        self.cut("csv")

    def test_change_vtp(self):
        self.change("vtp")

    def test_change_vtu(self):
        self.change("vtu")

    def test_change_vtk(self):
        self.change("vtk")

    def test_change_stl(self):
        self.change("stl")

    def test_change_obj(self):
        self.change("obj")

    def test_change_ply(self):
        self.change("ply")

    def test_change_csv(self):
        self.change("csv")


if __name__ == "__main__":
    unittest.main()
