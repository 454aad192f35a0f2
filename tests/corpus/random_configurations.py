"""Random singularities with the right sum on random domains, and their quads:

  python3 tests/corpus/random_configurations.py PROGRAM [--seeds 0-59] [--options OPTION...]

prints a table, and a summary: the share of meshes without inverted quads, of those with exactly the
requested irregular nodes, the median of the minimum scaled Jacobian, and the longest run. Seed s takes the
domain s of random_domains.py (without tilted ones) and a kind of configuration: singularities spread
over the domain, with additional pairs, in clusters, or near the boundary. Distances are lengths of quads.
"""

import argparse
import csv
import json
import math
import pathlib
import random
import statistics
import subprocess
import tempfile

import random_domains
import simple_loops
import survey

QUAD_COUNT = 1000


def distance_to(place, loops):
    return min(simple_loops.distance(place, side) for loop in loops for side in simple_loops.sides(loop))


def is_inside(place, loops):
    return sum(simple_loops.contains(loop, place) for loop in loops) == 1


def area_of(loops):
    areas = [abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(p, p[1:] + p[:1]))) / 2 for p in loops]
    return areas[0] - sum(areas[1:])


# Distances in quads: of singularities from each other, and the range of their distance to the boundary.
KINDS = {"spread": (1.5, (1.5, math.inf)), "pairs": (1.5, (1.5, math.inf)),
         "clusters": (1.5, (1.5, math.inf)), "boundary": (1.5, (0.7, 2.5))}


def configuration(seed, loops, required):
    """Returns the kind and rows x, y, quarter index; no rows if they have no place."""
    chance, kind = random.Random(seed), list(KINDS)[(seed // 3) % len(KINDS)]
    apart, (low, high) = KINDS[kind]
    quad = math.sqrt(area_of(loops) / QUAD_COUNT)
    quarters = [int(math.copysign(1, required))] * abs(required)
    pairs = chance.randint(1, 3) if kind == "pairs" else chance.randint(0, 1)
    quarters += [1, -1] * pairs
    chance.shuffle(quarters)
    rows, centre = [], None
    for quarter in quarters:
        for _ in range(2000):
            place = random_domains.place(chance, loops[0])
            if kind == "clusters" and centre:
                place = tuple(c + chance.gauss(0, 4 * quad) for c in centre)
            if (is_inside(place, loops) and low * quad <= distance_to(place, loops) <= high * quad and
                    all(math.dist(place, row[:2]) >= apart * quad for row in rows)):
                break
        else:
            return kind, []
        centre = place if centre is None or chance.random() < 0.2 else centre
        rows.append((*place, quarter))
    return kind, rows


def required_by(program, path):
    checked = subprocess.run([program, "check", path, "--json", "-"], capture_output=True, text=True)
    return json.loads(checked.stdout).get("required_interior_quarters") if checked.stdout else None


def run(program, folder, seed, options):
    """Returns the result of survey.mesh, or None if the seed gives no configuration."""
    name, loops = random_domains.domain(seed)
    if any(len(point) > 2 for loop in loops for point in loop):
        return None
    path = survey.write_loops(folder, name, loops)
    required = required_by(program, path)
    kind, rows = configuration(seed, loops, required) if required is not None else ("", [])
    if not rows:
        return None
    given = pathlib.Path(folder) / f"{name}_{kind}.csv"
    with open(given, "w", newline="") as file:
        csv.writer(file).writerows([("x", "y", "quarter_index"), *rows])
    result = survey.mesh(program, path, 100, ("-s", str(given), "--quads", str(QUAD_COUNT), *options))
    return {**result, "name": f"{name} {kind} {len(rows)}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--seeds", default="0-59")
    parser.add_argument("--keep")
    parser.add_argument("--options", nargs=argparse.REMAINDER, default=[])
    given = parser.parse_args()
    first, last = (int(number) for number in given.seeds.split("-"))
    valid, exact, minima, times, count = 0, 0, [], [], 0
    with tempfile.TemporaryDirectory(prefix="crossfield-") as folder:
        for seed in range(first, last + 1):
            result = run(given.program, given.keep or folder, seed, given.options)
            if result is None:
                continue
            count += 1
            times.append(result["seconds"])
            report = result.get("report")
            text = result.get("failure", "")
            minimum = 0.0
            if report:
                minimum = report["scaled_jacobian"]["min"]
                valid += report["inverted"] == 0
                exact += report["irregular"] == report["asked"]
                text = (f"{report['inverted']} inverted, {minimum:.3f}, sizes {report['size_variation']:.2f}, "
                        f"{len(report['moves'])} moves")
            minima.append(minimum if report and not report["inverted"] else 0.0)
            print(f"{result['name']}: {text}, {result['seconds']:.1f} s", flush=True)
    print(f"{count} configurations: {valid} without inverted quads ({100 * valid / count:.0f} %), {exact} with "
          f"exactly the requested nodes; median of the minimum scaled Jacobian {statistics.median(minima):.3f}, "
          f"longest run {max(times):.1f} s")


if __name__ == "__main__":
    main()
