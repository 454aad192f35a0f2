"""`crossfield figures`: every figure of the paper is computed and agrees with the table."""

import csv
import pathlib
import re
import subprocess
import sys

from program import ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Expected singularities, including holes and circles.
FOUND = {
    "ring_040": "4 x +1, 4 x -1", "ring_046": "none", "disk_holes": "4 x +1",
    # |u| also vanishes at two points that the paper does not mention.
    "disk_moved": "5 x +1, 1 x -1",
    "ellipse_reference": "4 x +1", "ellipse_holes": "4 x +1", "disk_triangles": "4 x +1",
    "quarter_disk": "2 x +1, 1 x -1", "disk_reference": "4 x +1",
    "disk_wrong_sum": "8 x +1, 4 x -1", "angular_balanced": "none", "angular_negative": "2 x -1",
    "angular_positive": "2 x +1", "angular_hole": "2 x +1, 4 x -1", "h_field": "4 x +1, 4 x -1"}


class Figures(ProgramTest):
    def table(self, folder):
        with open(self.folder / folder / "summary.csv", encoding="utf-8") as file:
            return {row["figure"]: row for row in csv.DictReader(file)}

    def test_all_of_them(self):
        result = self.run_program("figures", "-o", "all")
        self.assertEqual(result.returncode, 0, result)
        for line in result.stderr.splitlines():  # fields of the paper that vanish elsewhere, too
            self.assertTrue(line.startswith("Warning: The field has "), line)
        output = result.stdout
        rows = self.table("all")
        self.assertEqual({name: row["singularities"] for name, row in rows.items()}, FOUND)
        for name, row in rows.items():
            self.assertEqual(row["converged"], "1", name)
            self.assertTrue((self.folder / "all" / (name + ".vtu")).stat().st_size > 10000, name)
            self.assertIn(row["paper_says"], output)
        self.check_gallery()
        # docs/method.md §9; at most 30 iterations, as in the paper.
        self.assertAlmostEqual(float(rows["disk_holes"]["energy"]), 20.71, delta=0.1)
        for name in ("disk_holes", "disk_moved"):
            self.assertLessEqual(int(rows[name]["iterations"]), 30)

    def check_gallery(self):
        """The page equals the output of scripts/gallery.py, except for the last digits of
        energies."""
        page = subprocess.run(
            [sys.executable, ROOT / "scripts/gallery.py", self.folder / "all" / "summary.csv"],
            stdout=subprocess.PIPE, text=True, check=True).stdout
        number = re.compile(r"(?<=energy )[0-9.]+")
        written = (ROOT / "docs/gallery.md").read_text(encoding="utf-8")
        self.assertEqual(number.sub("", page), number.sub("", written))
        for new, old in zip(number.findall(page), number.findall(written)):
            self.assertAlmostEqual(float(new.rstrip(".")) / float(old.rstrip(".")), 1.0, delta=0.01)

    def test_some_of_them(self):
        self.succeed("figures", "--only", "disk_holes,angular_negative", "-o", "some/deeper")
        self.assertEqual(list(self.table("some/deeper")), ["disk_holes", "angular_negative"])

    def test_bad_usage(self):
        for arguments in (["figures"], ["figures", "--only", "no_such", "-o", "x"]):
            self.assertEqual(self.run_program(*arguments).returncode, 2)
        self.refuse("figures", "-o", "four.csv")
        self.assertFalse((self.folder / "x").exists())
