"""Writes plates with many round holes on a jittered grid, the same for the same number of holes:

  python3 tests/corpus/many_holes.py FOLDER [COUNT...]

The files are for survey.py --files. docs/speed.md has the times of `crossfield quads` on them.
"""

import math
import random
import sys

import survey
from random_domains import box, circle


def plate(count):
    """Returns the closed curves of a plate with `count` holes."""
    chance = random.Random(1)
    columns = math.ceil(math.sqrt(count))
    loops = [box(0, 0, columns, math.ceil(count / columns))]
    for i in range(count):
        x, y = i % columns + 0.5, i // columns + 0.5
        loops.append(circle(x + chance.uniform(-0.15, 0.15), y + chance.uniform(-0.15, 0.15),
                            chance.uniform(0.12, 0.25), 32))
    return loops


if __name__ == "__main__":
    for number in map(int, sys.argv[2:] or ("20", "40", "100")):
        print(survey.write_loops(sys.argv[1], f"plate{number}", plate(number)))
