"""Meshes and draws the pictures of docs/sizes.md.

    PYTHONPATH=$(crossfield --paths | sed -n 's/^python: //p') python3 scripts/pictures/sizes.py FOLDER
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import crossfield


def circle(x, y, radius, count=64):
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.column_stack([x + radius * np.cos(angles), y + radius * np.sin(angles)])


def profile(count=60):
    """Returns NACA 0012 with a closed trailing edge."""
    x = 0.5 * (1 - np.cos(np.linspace(0, np.pi, count)))
    y = 0.6 * (0.2969 * np.sqrt(x) - 0.1260 * x - 0.3516 * x ** 2 + 0.2843 * x ** 3 - 0.1036 * x ** 4)
    return np.concatenate([np.column_stack([x, y])[::-1], np.column_stack([x, -y])[1:-1]])


def box(left, bottom, right, top):
    return np.array([(left, bottom), (right, bottom), (right, top), (left, top)])


BRACKET = np.array([(0, 0), (3, 0), (3, 1), (1.3, 1), (1.15, 1.04), (1.04, 1.15), (1, 1.3), (1, 3), (0, 3)])


def draw(axes, mesh):
    """Draws quads coloured by block, nodes of valence 3 in red and of valence 5 in blue."""
    axes.add_collection(PolyCollection(mesh.points[mesh.quads][:, :, :2], array=mesh.block * 7 % 20, cmap="Pastel1",
                                       edgecolor="black", linewidth=0.4))
    inside = np.ones(len(mesh.points), bool)
    inside[mesh.edges.ravel()] = False
    for index, colour in ((1, "red"), (-1, "blue")):
        chosen = mesh.points[inside & (mesh.irregular == index)]
        axes.plot(chosen[:, 0], chosen[:, 1], "o", color=colour, markersize=4)
    axes.set_aspect("equal")
    axes.autoscale()
    axes.axis("off")


def main():
    folder = pathlib.Path(sys.argv[1])
    pictures = {
        "bracket": [crossfield.quads([BRACKET, circle(0.5, 2.4, 0.2)], size=0.25, sizes_near=[(1.1, 1.1, 0.03, 0.1)],
                                     sizes={"hole0": 0.06})],
        "fields": [
            crossfield.quads([box(-2, -1, 2, 1), circle(-0.35, 0, 0.3), circle(0.35, 0, 0.3)], size=0.2,
                             sizes_near=[(0, 0, 0.03, 0.1)]),
            crossfield.quads([box(-2, -2, 3, 2), profile()], size=0.4, growth=1.2,
                             sizes_near=[(0, 0, 0.01), (1, 0, 0.01)]),
            crossfield.quads([box(-2, -2, 8, 2), circle(0, 0, 0.5)], size=0.4, sizes={"hole0": 0.1},
                             sizes_near=[(x, 0, 0.12, 0.5) for x in (1.5, 2.5, 3.5, 4.5)])]}
    for name, meshes in pictures.items():
        figure, rows = plt.subplots(1, len(meshes), figsize=(4.5 * len(meshes), 4.5), squeeze=False)
        for axes, mesh in zip(rows[0], meshes):
            draw(axes, mesh)
        figure.tight_layout()
        figure.savefig(folder / f"{name}.png", dpi=90)


if __name__ == "__main__":
    main()
