"""Meshes the domains of the gallery of quads and writes its page: python3 quads_gallery.py PROGRAM FOLDER [NAME...]

Every domain goes in alone, with no option but the number of quads. FOLDER gets NAME.vtu, NAME.vtp (the layout)
and quads.md.
"""
import json
import pathlib
import subprocess
import sys
import time

TESTS = pathlib.Path(__file__).resolve().parent.parent / "tests"
sys.path[:0] = [str(TESTS / "corpus"), str(TESTS / "pipelines")]
import domain_files  # noqa: E402
import engineering  # noqa: E402

PARTS = ("plate3", "bracket", "elbow", "naca_blunt", "tjunction")
BUILT_IN = ("disk", "ring", "ellipse", "quarter-disk", "l-shape", "star")

PAGE = """# Gallery of quads: a domain in, quads out

Made by `scripts/quads.sh`. Every domain goes in alone, with `--quads %d` and no other option: its singularities
are proposed from a coarse Ginzburg-Landau field, moved to where the renormalised energy is least, and become the
irregular nodes. In the pictures blocks have pale colours; nodes of valence 3 are red, those of valence 5 blue.
Every mesh has exactly the nodes that were asked for. Scaled Jacobians are least sines of angles; with an
irregular node of valence 5 they are at most 0.951, with one of valence 3 at most 0.866, at a corner of the domain
at most the sine of its part of the angle. Seconds are those of whole runs, files included, on 2 cores.

| domain | quads | irregular nodes | blocks | scaled Jacobian: least, attainable, mean | seconds |
| --- | --- | --- | --- | --- | --- |
%s

%s
"""


def loops_of(folder, name):
    """A file with the closed curves of a domain of tests/corpus/engineering.py."""
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
            sys.exit("The mesh of %s has %s, asked were %s." % (name, report["irregular"], report["asked"]))
        rows.append(row(name, report, time.monotonic() - started))
        pictures.append("## %s\n\n![%s](quads/%s.png)" % (
            name.replace("_", " ").capitalize(), name.replace("_", " "), name))
        print("meshed", name, flush=True)
    (folder / "quads.md").write_text(PAGE % (count, "\n".join(rows), "\n\n".join(pictures)), encoding="utf-8")
    (folder / "names.txt").write_text("\n".join(domains) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:])
