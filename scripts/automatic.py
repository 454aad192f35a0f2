"""Chooses singularities for domains and writes the page: pvpython automatic.py PROGRAM FOLDER [NAME...]

Writes into FOLDER: NAME.csv, the singularities; NAME.vtu, their size field; names.txt;
automatic.md.
"""
import json
import math
import pathlib
import random
import resource
import subprocess
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import quads_gallery

STARTS = 3
MAXIMUM_SINGULARITIES = 20  # with more, random starts find too many different minima
FINER = 4
DEFAULT_SIZE = 1 / 40  # relative to the diagonal
THINNING = 0.02 * DEFAULT_SIZE  # the default; finer meshes use the same boundary

PAGE = """# Singularities chosen from the boundary alone

The domain is the only input: `crossfield optimize DOMAIN` proposes singularities from a coarse Ginzburg-Landau field and moves them
to positions of minimum renormalised energy W ([the method](method.md), sections 5.5 and 5.6). `scripts/automatic.sh` makes this
page.

The column *finer* is W after continuing to convergence on a mesh with a quarter of the edge length; *changes by* is the difference,
relative to the energy at a core radius of 1/100 of the diagonal, which, unlike W, does not depend on the unit of length. *Random
starts* are three starts with the same number of singularities of the same indices at random positions: the column gives how many
converge to within 1 %% of 1 + |W| with the same singularities, and the results of the others. Seconds are processor seconds of whole
runs, including files. Indices after a bar are on the boundary. In the pictures red is positive and blue is negative; dark areas have
small quads.

| domain | singularities | W of the proposal | W of the optimum | steps | seconds | finer | changes by | random starts |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
%s

Where singularities have become part of the boundary, W before and after belong to different coefficients of the logarithm and
cannot be compared.

%s
"""


def loops_of(file):
    """Returns the closed curves of a .vtp file."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    data = reader.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())[:, :2]
    lines = data.GetLines()
    ids, starts = vtk_to_numpy(lines.GetConnectivityArray()), vtk_to_numpy(lines.GetOffsetsArray())
    return [[tuple(points[i]) for i in ids[begin:end]] for begin, end in zip(starts[:-1], starts[1:])]


def segments_of(loops):
    return [(a, b) for loop in loops for a, b in zip(loop, loop[1:] + loop[:1]) if a != b]


def is_inside(place, segments):
    x, y = place
    return sum((a[1] > y) != (b[1] > y) and x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
               for a, b in segments) % 2 == 1


def distance(place, segment):
    (ax, ay), (bx, by) = segment
    along = (bx - ax, by - ay)
    t = ((place[0] - ax) * along[0] + (place[1] - ay) * along[1]) / (along[0] ** 2 + along[1] ** 2)
    t = min(1.0, max(0.0, t))
    return math.hypot(place[0] - ax - t * along[0], place[1] - ay - t * along[1])


def boundary_distance(place, segments):
    return min(distance(place, segment) for segment in segments)


class Domain:
    def __init__(self, program, folder, name, file):
        self.program, self.folder, self.name, self.file = program, folder, name, file
        self.segments = segments_of(loops_of(file))
        self.x, self.y = ([point[i] for segment in self.segments for point in segment] for i in (0, 1))
        self.diagonal = math.hypot(max(self.x) - min(self.x), max(self.y) - min(self.y))

    def run(self, *words):
        done = subprocess.run([self.program, *words], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True)
        if done.returncode not in (0, 1):
            sys.exit("%s of %s ended with %s" % (" ".join(words), self.name, done.stderr))
        return done.stdout

    def optimize(self, *options):
        return json.loads(self.run("optimize", self.file, "--json", "-", *options))

    def random_start(self, indices, chance):
        """Writes singularities with these indices at random positions, at least a hundredth of the
        diagonal from the boundary."""
        rows = []
        while len(rows) < len(indices):
            place = (chance.uniform(min(self.x), max(self.x)), chance.uniform(min(self.y), max(self.y)))
            if is_inside(place, self.segments) and boundary_distance(place, self.segments) > 0.01 * self.diagonal:
                rows.append("%.9g,%.9g,%d" % (*place, indices[len(rows)]))
        path = self.folder / (self.name + ".start.csv")
        path.write_text("\n".join(["x,y,quarter_index", *rows]) + "\n", encoding="utf-8")
        return path.name

    def indices(self, report):
        """Returns the quarter indices inside and on the boundary."""
        reach = 1e-6 * self.diagonal
        inside, boundary = [], []
        for row in report["singularities"]:
            held = boundary_distance((row["x"], row["y"]), self.segments) < reach
            (boundary if held else inside).append(row["quarter_index"])
        return sorted(inside, reverse=True), sorted(boundary, reverse=True)


def count(indices):
    return ", ".join("%d × %+d" % (indices.count(k), k) for k in sorted(set(indices), reverse=True)) or "none"


def describe(inside, boundary):
    return count(inside) + (" \\| " + count(boundary) if boundary else "")


def compare_starts(domain, proposed, best):
    """Returns how many runs from random positions converge to the best result."""
    if not proposed[0] or len(proposed[0]) > MAXIMUM_SINGULARITIES:
        return "–"
    chance = random.Random(1)
    others, same = [], 0
    for _ in range(STARTS):
        report = domain.optimize("-s", domain.random_start(proposed[0], chance))
        energy, found = report["renormalized_energy_after"], domain.indices(report)
        if found == domain.indices(best) and (
                abs(energy - best["renormalized_energy_after"]) < 0.01 * (1 + abs(energy))):
            same += 1
        else:
            others.append("%s%.2f" % ("" if found == domain.indices(best) else describe(*found) + ": ", energy))
            if not report["converged"]:
                others[-1] += " (not converged)"
    return "; ".join(["%d of %d" % (same, STARTS), *others])


def row(domain):
    proposed = domain.optimize("--iterations", "0")
    started = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    best = domain.optimize("-o", domain.name + ".csv")
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - started
    finer = domain.optimize("-s", domain.name + ".csv", "--size", repr(DEFAULT_SIZE * domain.diagonal / FINER),
                            "--thin-boundary", repr(THINNING * domain.diagonal))
    energy, other = best["renormalized_energy_after"], finer["renormalized_energy_after"]
    printed = domain.run("energy", domain.file, "-s", domain.name + ".csv", "--json", "-")
    core = json.loads(printed)["configurations"][0]["energy_at_core_radius"]
    domain.run("hfield", domain.file, "-s", domain.name + ".csv", "-o", domain.name + ".vtu")
    return "| %s | %s | %.2f | %.2f | %d%s | %.1f | %.2f | %.2f %% | %s |" % (
        domain.name.replace("_", " "), describe(*domain.indices(best)), best["renormalized_energy_before"], energy,
        best["iterations"], "" if best["converged"] else " (not converged)", seconds, other,
        100 * abs(other - energy) / abs(core) if core else 0.0,
        compare_starts(domain, domain.indices(proposed), best))


def main(program, folder, wanted):
    parts = {name: str(quads_gallery.TESTS / "data" / "parts" / (name + ".vtp")) for name in quads_gallery.PARTS}
    files = {**parts, **{name: None for name in quads_gallery.engineering.DOMAINS}}
    rows, pictures = [], []
    for name in wanted or files:
        domain = Domain(program, folder, name, files[name] or quads_gallery.loops_of(folder, name))
        rows.append(row(domain))
        print(rows[-1], flush=True)
        title = name.replace("_", " ")
        pictures.append("## %s\n\n![%s](automatic/%s.png)" % (title.capitalize(), title, name))
    (folder / "automatic.md").write_text(PAGE % ("\n".join(rows), "\n\n".join(pictures)), encoding="utf-8")
    (folder / "names.txt").write_text("\n".join(wanted or files) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:])
