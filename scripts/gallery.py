"""Writes docs/gallery.md from the table of `crossfield figures`: python3 gallery.py summary.csv"""
import csv
import sys

PAGE = """# Gallery: the figures of the paper, computed again

Made by `scripts/figures.sh`, which runs `crossfield figures` and draws what it writes. In the pictures
red lines are holes, imprinted circles and triangles; red dots are positive singularities, blue dots
negative ones; blue areas have |u| < 1, orange ones |u| > 1. `--only NAME` computes one figure.

The numbers are those of coarse meshes, a few seconds for all of them. `Program.Figures` computes them again and
compares.
"""
ENTRY = """
## {figure}

![{figure}](gallery/{figure}.png)

Figure *{paper}*. The paper: {paper_says}. Here, by method `{method}`: {found}, energy {energy:.4g}{work}.

```console
crossfield figures --only {figure} -o figures
```
"""


def entry(row):
    found = "no singularities" if row["singularities"] == "none" else row["singularities"]
    if int(row["unwanted_singularities"]) and row["method"].find("ginzburg-landau") < 0:
        found += ", %s of them not asked for" % row["unwanted_singularities"]
    work = "" if row["converged"] == "1" else ", NOT converged"
    return ENTRY.format(found=found, work=work, **{**row, "energy": float(row["energy"])})


with open(sys.argv[1], encoding="utf-8") as table:
    sys.stdout.write(PAGE + "".join(entry(row) for row in csv.DictReader(table)))
