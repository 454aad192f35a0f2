"""crossfield.separatrices: python3 test_separatrices.py

Its faces are rectangles of the map that cover the domain once, its lines end where `ends_at`
indicates, and singularities are chosen and moved as for the other functions.
"""
import sys
import unittest

import numpy as np

import crossfield

FOUR = [(0.6 * np.cos(t), 0.6 * np.sin(t), 1) for t in np.pi / 4 + np.pi / 2 * np.arange(4)]


def area(polygon):
    x, y = polygon[:, 0], polygon[:, 1]
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def on_circle(radius, first, quarters):
    return [(radius * np.cos(t), radius * np.sin(t), quarters) for t in first + np.pi / 2 * np.arange(4)]


class Separatrices(unittest.TestCase):
    def test_faces_cover_the_disk_once(self):
        found = crossfield.separatrices("builtin:disk", FOUR, size=0.05)
        # A square in the middle and four strips: 9 minus the lines that meet head-on.
        self.assertEqual(found.report["faces"], 9 - found.report["head_on"])
        self.assertEqual(found.report["faces"], len(found.faces))
        areas = [area(face) for face in found.faces]
        self.assertGreater(min(areas), 0)
        boundary = 0.5 * 126 * np.sin(2 * np.pi / 126)  # approximately the area of the polygon
        self.assertAlmostEqual(sum(areas), boundary, delta=1e-3)
        self.assertAlmostEqual(np.prod(found.face_sizes, axis=1).sum(), sum(areas), delta=2e-3)
        self.assertLessEqual(set(found.ends_at.tolist()), {1, 2, 3})
        for line, end in zip(found.lines, found.ends_at):
            if end == 2:
                self.assertAlmostEqual(np.hypot(*line[-1, :2]), 1, delta=2e-3)

    def test_streamlines_start_at_the_seeds(self):
        found = crossfield.separatrices("builtin:disk", FOUR, seeds=[(0.1, 0.2, 0), (-0.3, 0, 0)])
        for seed, place in enumerate(((0.1, 0.2), (-0.3, 0))):
            lines = [line for line, of in zip(found.lines, found.seed) if of == seed]
            self.assertEqual(len(lines), 4)
            for line in lines:
                np.testing.assert_allclose(line[0, :2], place, atol=1e-12)

    def test_singularities_are_chosen(self):
        found = crossfield.separatrices("builtin:disk", size=0.1)
        self.assertEqual([row["quarter_index"] for row in found.report["singularities"]], [1] * 4)
        # By symmetry, all radii are equal at the minimum of W.
        radii = [np.hypot(row["x"], row["y"]) for row in found.report["singularities"]]
        np.testing.assert_allclose(radii, np.mean(radii), rtol=1e-3)
        self.assertTrue(found.report["events"])
        self.assertNotIn("singularities", crossfield.separatrices("builtin:disk", FOUR).report)

    def test_holonomy_is_repaired(self):
        # The phase 4 theta turns by the sum of k_j arg b_j: 0.6.
        rows = on_circle(0.8, 0.25, 1) + on_circle(0.55, 0.1, -1)
        found = crossfield.separatrices("builtin:ring", rows, size=0.08, repair_holonomy=True)
        self.assertAlmostEqual(abs(found.report["repair"]["defect_before"][0]), 0.6, delta=0.01)
        self.assertGreater(found.report["repair"]["distance"], 0.03)
        ring = np.pi * (1 - 0.4**2)
        self.assertAlmostEqual(sum(map(area, found.faces)), ring, delta=0.02)

    def test_refusals(self):
        for word, arguments in (("split it", ("builtin:disk", [(0.4, 0, 3), (-0.4, 0, 1)])),
                                ("add singularities of total -3", ("builtin:star", [(0, 0, 2)]))):
            with self.assertRaisesRegex(crossfield.Error, word):
                crossfield.separatrices(*arguments)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
