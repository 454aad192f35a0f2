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
MERGED = ("plate3", "bracket", "bolts", "blade_passage", "slotted_link", "twenty_holes", "ellipse")  # with the table of --merge
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

`heart` and `teardrop` end in cusps, where the sides meet with an angle of 0, which no quad has. The tips are cut off, and a warning says
where and how wide.

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
- with `--hold`, a configuration for which no map that closes the grid lines was found, which is possible with a single pair of 1 and −1
  in a ring. The message names the hole, the angle by which grid lines miss, and the predicted stretch, and offers to leave out `--hold`
  if there are quads then.

Singularities closer to each other than the side of a quad may give inverted quads. The warning names a smaller size with which there
are none, if one was found; where the choice of singularities takes long, it was tried with the same ones.

A corner below 45°, such as the trailing edge of a profile, is cut off if there are no valid quads in it. The warning says
where and how wide.

A singularity of quarter index 2 is a node of valence 2, whose quads have an angle of 180°; one of −2 is a node of valence 6. `--split`
replaces each by two of index 1 or −1, about 1.5 quads apart.

Sizes are conformal where shapes are good and sizes vary by no more than half of their mean; otherwise conformal, partly uniform or
uniform, whichever gives the best quads ([method](method.md) §14.8). Nodes stay where the singularities were given, as long as shapes and
sizes are as good there; otherwise they move. Where this gives no valid quads, for example where singularities in a long strip are so far
from each other that sizes would differ a million times, the holonomy is repaired, or all singularities move towards a minimum of the energy,
and a warning says how far. Every move by more than a tenth of a quad is printed, `moves` in the report lists all of them, and
`--save-singularities` has the positions of the nodes. `--hold` keeps the nodes in place in any case.

## Fewer blocks

Separatrices that start at different singularities often run side by side, with narrow blocks between them. For a structured solver,
request fewer blocks:

```sh
crossfield quads part.vtp --merge clean -o quads.vtu --blocks blocks.vtm
```

`--merge clean` moves singularities by a fraction of a quad to a few quads, until these separatrices meet
([method](method.md) §14.10). Where round holes are equal or on a grid, it also tries four singularities at 45° around every hole. A
mesh is accepted only if it has fewer blocks and its quads are as good as before, both with the sizes of the map:

- the minimum scaled Jacobian is at most 0.02 lower, the mean at most 0.002
- the variation of sizes is at most 1.35 times as large, or at most 0.05 larger
- no quad is inverted

If no mesh fulfils this, you get the mesh without merging. If you give no singularities and no sizing, uniform sizes are chosen
afterwards, which may lower the minimum further. An event in the report gives the largest move, and `blocks_by_merge` the numbers
of blocks. Singularities given with `-s` are moved as well.

`--merge coarse`, or `--coarse` for short, starts from the result of `clean` and merges the separatrices that remain without moving
singularities. It accepts a worst quad that is half as good, and takes as long as `clean`.

Table: number of blocks and minimum scaled Jacobian with each kind of merging, for domains of this gallery, and the seconds that moving
singularities takes.

| domain | singularities | blocks: none, clean, coarse | minimum scaled Jacobian: none, clean, coarse | seconds |
| --- | --- | --- | --- | --- |
%s

`clean` moves singularities and may take longer than everything else, and so it is not the default.

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


def run(program, folder, domain, name, *options):
    """Meshes a domain and returns the report."""
    return json.loads(subprocess.run(
        [program, "quads", domain, *options, "-o", name + ".vtu", "--json", "-"],
        cwd=folder, check=True, stdout=subprocess.PIPE, text=True).stdout)


def merged_row(program, folder, domain, name, count, report):
    """Returns a row for each kind of merging; `report` is that without."""
    reports = [report] + [run(program, folder, domain, "merged", "--quads", str(count), "--merge", kind) for kind in ("clean", "coarse")]
    return "| %s | %d | %s | %s | %.1f |" % (
        name.replace("_", " "), len(report["singularities"]), ", ".join(str(one["blocks"]) for one in reports),
        ", ".join("%.3f" % one["scaled_jacobian"]["min"] for one in reports), reports[1]["seconds"]["clean"])


def difficult_rows(program):
    files = [*(TESTS / "data" / "hard").iterdir(), *(TESTS / "data" / "parts").iterdir()]
    return [survey.row(survey.mesh(program, file)) for file in sorted(files, key=lambda file: file.stem)]


def main(program, folder, wanted, count=1000):
    domains = {name: str(TESTS / "data" / "parts" / (name + ".vtp")) for name in PARTS}
    domains.update((name, loops_of(folder, name)) for name in engineering.DOMAINS)
    domains.update((name.replace("-", "_"), "builtin:" + name) for name in BUILT_IN)
    domains = {name: domain for name, domain in domains.items() if not wanted or name in wanted}
    rows, merged, pictures = [], [], []
    for name, domain in domains.items():
        started = time.monotonic()
        report = run(program, folder, domain, name, "--quads", str(count), "--layout", name + ".vtp")
        if report["irregular"] != report["asked"]:
            sys.exit("The mesh of %s has the irregular nodes %s, requested were %s." % (name, report["irregular"], report["asked"]))
        rows.append(row(name, report, time.monotonic() - started))
        if name in MERGED and not wanted:
            merged.append(merged_row(program, folder, domain, name, count, report))
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
        PAGE % (count, "\n".join(rows), "\n".join([survey.HEADER, *difficult]), "\n".join(merged), "\n\n".join(pictures)), encoding="utf-8")
    (folder / "names.txt").write_text("\n".join(domains) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:])
