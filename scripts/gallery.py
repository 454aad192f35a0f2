"""Writes docs/gallery.md from the table of `crossfield figures`: python3 gallery.py summary.csv"""
import csv
import sys

PAGE = """# Gallery: the figures of the paper, reproduced

`scripts/figures.sh` runs `crossfield figures`, draws the results and makes this page; `--only NAME` computes one figure. In the
pictures red lines are holes, imprinted circles and triangles. Red dots are positive singularities, blue dots negative ones. Blue
areas have |u| < 1, orange areas |u| > 1.

The meshes are coarse, so that all figures together take a few seconds. The test `Program.Figures` recomputes and compares the numbers.
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
        found += ", %s of them unwanted" % row["unwanted_singularities"]
    work = "" if row["converged"] == "1" else ", NOT converged"
    return ENTRY.format(found=found, work=work, **{**row, "energy": float(row["energy"])})


with open(sys.argv[1], encoding="utf-8") as table:
    sys.stdout.write(PAGE + "".join(entry(row) for row in csv.DictReader(table)))
