"""One random domain of each kind becomes quads. `survey.py` meshes hundreds."""

import json
import math
import os
import tempfile
import unittest

import random_domains
import survey
from random_domains import KINDS

#: One seed of each kind, chosen because it takes less than half a second.
SEEDS = (23, 1, 140, 141, 4, 28, 52, 99, 192, 78, 79, 11, 12, 13, 129, 38, 85, 86, 41, 65, 20, 21, 22)


def turning_angles(loop):
    """Returns the turning angle at each vertex of a closed curve in a plane, in degrees; positive
    ones prevail."""
    points = [(*p, 0.0)[:3] for p in loop]
    along = [[b - a for a, b in zip(p, q)] for p, q in zip(points, points[1:] + points[:1])]

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def dot(a, b):
        return sum(x * y for x, y in zip(a, b))
    first = points[0]
    fans = [cross([b - a for a, b in zip(first, p)], [b - a for a, b in zip(first, q)])
            for p, q in zip(points[1:], points[2:])]
    normal = [sum(fan[i] for fan in fans) for i in range(3)]
    length = math.sqrt(dot(normal, normal))
    return [math.degrees(math.atan2(dot(normal, cross(a, b)) / length, dot(a, b)))
            for a, b in zip(along[-1:] + along[:-1], along)]


def corner_index(turning):
    """Returns the quarter index of a vertex (docs/method.md §2): the nearest multiple of 90°, the
    lower one at a tie, at most 1; 0 where the boundary is a curve."""
    return 0 if abs(turning) <= 30 else min(1, math.ceil((turning - 1e-6) / 90 - 0.5))


def required_sum(loops):
    """Returns the sum of the quarter indices of all singularities, by Poincaré-Hopf."""
    corners = sum(corner_index(t) for t in turning_angles(loops[0]))
    corners += sum(corner_index(-t) for loop in loops[1:] for t in turning_angles(loop))
    return 4 * (2 - len(loops)) - corners


class Survey(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="crossfield-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def result(self, seed):
        return survey.mesh(os.environ["CROSSFIELD_PROGRAM"], survey.write_domain(self.folder, seed))

    def test_every_kind_becomes_quads(self):
        self.assertEqual(sorted(seed % len(KINDS) for seed in SEEDS), list(range(len(KINDS))))
        results = []
        for seed in SEEDS:
            name, loops = random_domains.domain(seed)
            with self.subTest(name):
                results.append(self.result(seed))
                self.assertEqual(survey.problem(results[-1]), "")
                report = results[-1]["report"]
                self.assertEqual(sum(row["quarter_index"] for row in report["singularities"]),
                                 required_sum(loops), report["singularities"])
        print("\n".join(survey.summary(results)))

    def test_steps_that_overflow(self):
        """Three slits with two singularities: the optimiser stepped to positions that were not
        finite."""
        for seed in (155, 178):
            self.assertEqual(survey.problem(self.result(seed)), "")

    def test_a_seed_always_gives_the_same_domain(self):
        for seed in SEEDS:
            self.assertEqual(json.dumps(random_domains.domain(seed)),
                             json.dumps(random_domains.domain(seed)))
            self.assertNotEqual(random_domains.domain(seed)[1],
                                random_domains.domain(seed + len(KINDS))[1])

    def test_failures_are_found(self):
        path = survey.write_loops(self.folder, "bow_tie", [[(0, 0), (1, 0), (0, 1), (1, 1)]])
        result = survey.mesh(os.environ["CROSSFIELD_PROGRAM"], path)
        self.assertRegex(survey.problem(result), "^crossfield: .*\\.$")
        self.assertIn("1 failures", survey.summary([result])[0])
        for wrong in ({"inverted": 1}, {"inverted": 0, "irregular": {"3": 1}, "asked": {"3": 2}}):
            self.assertNotEqual(survey.problem({"name": "any", "report": wrong}), "")


if __name__ == "__main__":
    unittest.main()
