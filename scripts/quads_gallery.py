"""Meshes the domains of the gallery of quads and writes the page: python3 quads_gallery.py PROGRAM FOLDER [NAME...]

The domain is the only input and the number of quads the only option. Writes into FOLDER: NAME.vtu,
NAME.vtp (the layout) and quads.md.
"""
import json
import math
import pathlib
import subprocess
import sys
import time

TESTS = pathlib.Path(__file__).resolve().parent.parent / "tests"
sys.path[:0] = [str(TESTS / "corpus"), str(TESTS / "pipelines")]
import domain_files  # noqa: E402
import engineering  # noqa: E402
import survey  # noqa: E402

PARTS = ("plate3", "bracket", "elbow", "naca_blunt", "tjunction")
BUILT_IN = ("disk", "ring", "ellipse", "quarter-disk", "l-shape", "star")

PAGE = """# Gallery of quads: meshes made from the boundary alone

The domain is the only input: `crossfield quads DOMAIN --quads %d` proposes singularities from a coarse Ginzburg-Landau field, moves
them to positions of minimum renormalised energy, and makes quads with these irregular nodes. `scripts/quads.sh` makes this page.

In the pictures blocks have pale colours; nodes of valence 3 are red, nodes of valence 5 blue. Every mesh has exactly the requested
nodes. The scaled Jacobian of a quad is the minimum sine of its angles. It is at most 0.951 at a node of valence 5, at most 0.866 at a
node of valence 3, and at a corner of the domain at most the sine of the angle that each quad has there. Seconds are the time of whole
runs on 2 cores, including files.

| domain | quads | irregular nodes | blocks | scaled Jacobian: minimum, attainable, mean | seconds |
| --- | --- | --- | --- | --- | --- |
%s

## Difficult domains

The files of `tests/data/hard` and `tests/data/parts` as the only input: ragged, thin, sharp and crowded domains, and parts. *Ratio* is
the minimum scaled Jacobian by the attainable one, *sizes* the standard deviation of edge length by its mean, *seconds* the processor
time of the whole run. `tests/corpus/survey.py` makes this table for any files ([testing](testing.md#random-domains)).

%s

`heart` and `teardrop` end in cusps, where the sides meet with an angle of 0. The message offers a length with which
`--smooth-boundary` rounds the cusp, and the domain then has quads.

## Configurations chosen by hand

`-s FILE.csv` replaces the proposed singularities by your own (port 1 of [Quad Mesher](filters/QuadMesher.md)). Their quarter
indices must have the total that the domain needs ([why](choosing_singularities.md#why-the-sum-is-fixed)). Their positions are free,
also in a part with holes.

In general, grid lines around a hole then do not close up: they have a *holonomy defect* ([glossary](glossary.md)). The mesh
nevertheless has exactly these irregular nodes. It is stretched until its grid lines close up, so that quads are rectangles or
rhombi instead of squares, spread over the part.

![Ring with eight singularities chosen by hand](quads/ring_by_hand.png)

Here four singularities of quarter index 1 and four of −1 are placed in a ring without regard to each other (`builtin:ring`; radii 0.8
and 0.55, turned by 34°).

The *predicted stretch* is the ratio of the sides of these rectangles. It is computed before the quads are made:
(1 + |μ|) / (1 − |μ|), where |μ| is the smallest strain that closes the grid lines ([method](method.md) §12.5). About 1.5 is usual for
singularities placed at random. Up to 2 is fine. Above 3, look at the mesh. If grid lines miss by a few degrees only, the quads hardly
change and no stretch is predicted.

Two options lower the stretch. Neither is necessary:

- `--repair-holonomy` moves the singularities by the smallest distances after which the grid lines close up without stretch;
  `--repair-part 0.5` moves them half of the way.
- `crossfield optimize` moves them to a minimum of the energy, where the grid lines close up as well and the crosses turn as little
  as possible. The distances may be large.

What remains refused:

- a wrong total of quarter indices, and a singularity of quarter index 3 or more, for which there is no node
- a singularity outside the domain
- a configuration for which no map that closes the grid lines was found, which is possible with a single pair of 1 and −1 in a ring.
  The message names the hole, the angle by which grid lines miss, and the predicted stretch. It offers `--repair-holonomy` if a mesh was
  found with it. Otherwise choose other positions, or add a pair.

Singularities closer to each other than the side of a quad may give inverted quads. The warning names a smaller size with which there
are none, if one was found.

A singularity of quarter index 2 is a node of valence 2, whose quads have an angle of 180°; one of −2 is a node of valence 6. `--split`
replaces each by two of index 1 or −1, about 1.5 quads apart.

Where quads would be inverted with fixed singularities, the nodes move. Every move by more than a tenth of a quad is printed; the
report and `--save-singularities` have the positions of the nodes.

## Fewer blocks

Separatrices that start at different singularities often run side by side, with narrow blocks between them. For a structured solver,
request fewer blocks:

```sh
crossfield quads part.vtp --merge clean -o quads.vtu --blocks blocks.vtm
```

`--merge clean` moves singularities by a fraction of a quad to a few quads, until these separatrices meet
([method](method.md) §14.10). Where round holes are equal or on a grid, it also tries four singularities at 45° around every hole. A
mesh is accepted only if it has fewer blocks and its quads are as good as before:

- the minimum scaled Jacobian is at most 0.02 lower, the mean at most 0.002
- the variation of sizes is at most 1.35 times as large, or at most 0.05 larger
- no quad is inverted

If no mesh fulfils this, you get the mesh without merging. An event in the report gives the largest move, and `blocks_by_merge` the numbers
of blocks. Singularities given with `-s` are moved as well.

`--merge coarse`, or `--coarse` for short, starts from the result of `clean` and merges the separatrices that remain without moving
singularities. It accepts a worst quad that is half as good, and takes as long as `clean`.

Table: number of blocks, and minimum scaled Jacobian of about 1,000 quads, with each kind of merging.

| domain | singularities | blocks: none, clean, coarse | minimum scaled Jacobian: none, clean, coarse |
| --- | --- | --- | --- |
| bracket | 9 | 39, 28, 28 | 0.920, 0.916, 0.558 |
| ellipse with four circles | 16 | 120, 40, 37 | 0.861, 0.861, 0.566 |
| twenty holes | 80 | 369, 159, 165 | 0.871, 0.903, 0.500 |
| blob with three lobes | 8 | 53, 14, 14 | 0.853, 0.859, 0.491 |
| plate with 10 holes | 40 | 251, 162, 100 | 0.875, 0.864, 0.580 |
| plate with 2 holes | 8 | 29, 24, 24 | 0.929, 0.923, 0.555 |
| plate with 3 holes | 12 | 53, 33, 33 | 0.909, 0.897, 0.586 |
| plate with 4 holes | 16 | 69, 48, 46 | 0.911, 0.906, 0.524 |
| plate with 4 other holes | 16 | 78, 53, 53 | 0.903, 0.889, 0.676 |
| plate with 6 holes | 24 | 123, 76, 71 | 0.878, 0.914, 0.777 |
| plate with 8 holes | 32 | 178, 102, 84 | 0.878, 0.871, 0.666 |
| plate with 9 holes | 36 | 212, 126, 108 | 0.876, 0.866, 0.532 |
| plate with 11 holes | 44 | 252, 215, 202 | 0.876, 0.857, 0.754 |
| random blob 1 | 4 | 15, 5, 5 | 0.768, 0.856, 0.544 |
| random blob 2 | 4 | 18, 5, 5 | 0.851, 0.863, 0.694 |
| random blob 3 | 4 | 10, 5, 5 | 0.790, 0.859, 0.657 |
| random blob 4 | 4 | 18, 5, 5 | 0.854, 0.860, 0.593 |

The first five domains were used while the method was developed, the others were not. *bracket* is in this gallery. *twenty holes* are
of radius 0.22, one in every unit square of a rectangle 5 × 4. Plates have holes of random radii at random positions. `clean` takes 0.1 to 0.4 s
with up to 12 singularities and 1 to 3 s with 16 to 24; with 32 to 48 it takes 6 to 13 s, more than everything else, and so it is not
the default.

%s
"""


# Singularities whose grid lines do not close up around the hole of builtin:ring: radius, turn, index.
BY_HAND = ((0.8, 0.0, 1), (0.55, 0.6, -1))


def write_by_hand(file):
    """Writes four singularities for each row of BY_HAND."""
    lines = ["x,y,quarter_index"]
    for radius, turn, index in BY_HAND:
        for angle in (turn + i * math.pi / 2 for i in range(4)):
            lines.append("%.9g,%.9g,%d" % (radius * math.cos(angle), radius * math.sin(angle), index))
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")


def loops_of(folder, name):
    """Writes the closed curves of a domain of tests/corpus/engineering.py; returns the name of the file."""
    points, lines = [], []
    for loop in engineering.DOMAINS[name]():
        first = len(points)
        points += loop
        lines.append([*range(first, len(points)), first])
    domain_files.write_vtp(folder / (name + ".domain.vtp"), points, lines)
    return str(folder / (name + ".domain.vtp"))


def nodes(report):
    counts = ["%d of valence %s" % (count, valence) for valence, count in report["irregular"].items()]
    return " and ".join(counts) or "none"


def row(name, report, seconds):
    jacobian = report["scaled_jacobian"]
    return "| %s | %d | %s | %d | %.3f, %.3f, %.4f | %.1f |" % (
        name.replace("_", " "), report["quads"], nodes(report), report["blocks"], jacobian["min"],
        jacobian["bound"], jacobian["mean"], seconds)


def difficult_rows(program):
    files = [*(TESTS / "data" / "hard").iterdir(), *(TESTS / "data" / "parts").iterdir()]
    return [survey.row(survey.mesh(program, file)) for file in sorted(files, key=lambda file: file.stem)]


def main(program, folder, wanted, count=1000):
    domains = {name: str(TESTS / "data" / "parts" / (name + ".vtp")) for name in PARTS}
    domains.update((name, loops_of(folder, name)) for name in engineering.DOMAINS)
    domains.update((name.replace("-", "_"), "builtin:" + name) for name in BUILT_IN)
    domains = {name: domain for name, domain in domains.items() if not wanted or name in wanted}
    rows, pictures = [], []
    for name, domain in domains.items():
        started = time.monotonic()
        printed = subprocess.run(
            [program, "quads", domain, "--quads", str(count), "-o", name + ".vtu", "--layout", name + ".vtp",
             "--json", "-"], cwd=folder, check=True, stdout=subprocess.PIPE, text=True).stdout
        report = json.loads(printed)
        if report["irregular"] != report["asked"]:
            sys.exit("The mesh of %s has the irregular nodes %s, requested were %s." % (name, report["irregular"], report["asked"]))
        rows.append(row(name, report, time.monotonic() - started))
        pictures.append("## %s\n\n![%s](quads/%s.png)" % (
            name.replace("_", " ").capitalize(), name.replace("_", " "), name))
        print("meshed", name, flush=True)
    if not wanted:
        write_by_hand(folder / "by_hand.csv")
        subprocess.run(
            [program, "quads", "builtin:ring", "-s", "by_hand.csv", "--quads", str(count), "-o", "ring_by_hand.vtu",
             "--layout", "ring_by_hand.vtp"], cwd=folder, check=True)
        domains["ring_by_hand"] = "builtin:ring"
    difficult = [] if wanted else difficult_rows(program)
    (folder / "quads.md").write_text(
        PAGE % (count, "\n".join(rows), "\n".join([survey.HEADER, *difficult]), "\n\n".join(pictures)), encoding="utf-8")
    (folder / "names.txt").write_text("\n".join(domains) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:])
