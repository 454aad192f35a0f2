"""Meshes and draws the picture of docs/lines.md.

    PYTHONPATH=$(crossfield --paths | sed -n 's/^python: //p') python3 scripts/pictures/lines.py FOLDER
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import crossfield

PLATE = [(-2, -1), (2, -1), (2, 1), (-2, 1)]
ANGLES = np.linspace(0, 2 * np.pi, 72, endpoint=False)
HOLE = np.column_stack((np.cos(ANGLES) * 0.4 - 1, np.sin(ANGLES) * 0.4))
LINES = {"crack": [(-0.6, 0), (0.2, 0)], "probe": [(1, -1), (1.2, 1)]}
NODE = (0.7, 0.3)


def main():
    folder = pathlib.Path(sys.argv[1])
    mesh = crossfield.quads([PLATE, HOLE], count=800, lines=LINES, open_lines=["crack"], nodes=[NODE])
    figure, axes = plt.subplots(figsize=(7.2, 3.7))
    axes.add_collection(PolyCollection(mesh.points[mesh.quads][:, :, :2], facecolor="#e8eef4", edgecolor="#8899aa", linewidth=0.6))
    for side, edge in zip(mesh.edge_side, mesh.points[mesh.edges][:, :, :2]):
        colour = "#c0392b" if side.startswith("crack") else "#1f6fb2" if side == "probe" else "#333333"
        axes.plot(*edge.T, color=colour, linewidth=1.2 if colour == "#333333" else 2.2, solid_capstyle="round")
    axes.plot(*NODE, "o", color="#1e8449", markersize=6)
    axes.set(xlim=(-2.03, 2.03), ylim=(-1.03, 1.03), aspect="equal")
    axes.axis("off")
    figure.subplots_adjust(0, 0, 1, 1)
    figure.savefig(folder / "lines.png", dpi=100)


if __name__ == "__main__":
    main()
