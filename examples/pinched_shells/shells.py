"""Two shells that are pinched, with CalculiX: a cylinder between diaphragms, and a hemisphere.

    python3 shells.py [--program CROSSFIELD] [--quads N ...] [--keep FOLDER]

Both are written as triangles with named lines, which change their names where loads are, so that nodes are there. They are meshed
with quads of order 2 and solved by ccx with shells S8R. A mapped mesh of as many quads is solved too: for the cylinder a grid,
for the hemisphere the upper half of a cube, blown up. Prints the displacement under the load over that of the literature. Needs the Debian
package calculix-ccx.
"""
import argparse
import itertools
import json
import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from calculix import read_mesh, run, working_folder  # noqa: E402

STEP = """
*MATERIAL, NAME=steel
*ELASTIC
{young}, 0.3
*SHELL SECTION, ELSET={elements}, MATERIAL=steel
{thickness}
*BOUNDARY
{supports}
*STEP
*STATIC
*CLOAD
{loads}
*NODE FILE, OUTPUT=2D
U
*END STEP
"""


class Cylinder:
    """Radius 300, length 600, thickness 3, E = 3e6, pinched by 1 in the middle of its length, with diaphragms at its ends."""
    name, young, thickness, reference = "cylinder", 3e6, 3.0, 1.8248e-5
    supports = {"end": (1, 2)}
    loads = {(0.0, 300.0, 0.0): (2, -1.0), (0.0, -300.0, 0.0): (2, 1.0)}
    fixed = {(0.0, 300.0, 0.0): (3,), (0.0, -300.0, 0.0): (3,)}
    equal = ()

    @staticmethod
    def grids(n):
        """Returns the points of patches of squares, row by row."""
        angles = [math.pi / 2 * i / n for i in range(4 * n + 1)]
        return [[(300 * math.sin(a), 300 * math.cos(a), 300 * j / n) for a in angles] for j in range(-n, n + 1)],

    @staticmethod
    def side(one, other):
        """Returns the name of an edge. Names change at the loads, so that nodes are there."""
        for z in (-300.0, 300.0):
            if abs(one[2] - z) + abs(other[2] - z) < 1e-6:
                return "end"
        return ("left" if one[0] + other[0] < 0 else "right") if abs(one[2]) + abs(other[2]) < 1e-6 else ""


class Hemisphere:
    """Radius 10, thickness 0.04, E = 6.825e7, pulled by 2 in one direction at its edge and pushed by 2 in the other."""
    name, young, thickness, reference = "hemisphere", 6.825e7, 0.04, 0.0924
    supports = {}
    loads = {(10.0, 0.0, 0.0): (1, 2.0), (-10.0, 0.0, 0.0): (1, -2.0), (0.0, 10.0, 0.0): (2, -2.0),
             (0.0, -10.0, 0.0): (2, 2.0)}
    # By symmetry, but for the motion along z.
    fixed = {(10.0, 0.0, 0.0): (2, 3), (-10.0, 0.0, 0.0): (2, 3), (0.0, 10.0, 0.0): (1,), (0.0, -10.0, 0.0): (1,)}
    equal = (((0.0, 10.0, 0.0), (0.0, -10.0, 0.0), 3),)

    @staticmethod
    def grids(n):
        def at(face, i, j):
            u, v = math.tan(math.pi / 4 * i / n), math.tan(math.pi / 4 * j / n)
            place = (u, v, 1.0) if face == 4 else [(1.0, u, v), (-u, 1.0, v), (-1.0, -u, v), (u, -1.0, v)][face]
            return tuple(10 * x / math.hypot(*place) for x in place)

        both = range(-n, n + 1)
        return [[[at(face, i, j) for i in both] for j in (both if face == 4 else range(n + 1))] for face in range(5)]

    @staticmethod
    def side(one, other):
        if abs(one[2]) + abs(other[2]) > 1e-6:
            return ""
        x, y = one[0] + other[0], one[1] + other[1]
        return ("north" if y > 0 else "south") + ("east" if x > 0 else "west")


def numbered(grids):
    """Returns points and squares of grids; points at the same place are one."""
    numbers, squares = {}, []
    key = lambda point: tuple(round(x, 6) + 0.0 for x in point)  # noqa: E731
    for grid in grids:
        for row in grid:
            for point in row:
                numbers.setdefault(key(point), (len(numbers), point))
        for (below, above) in itertools.pairwise(grid):
            for i in range(len(below) - 1):
                squares.append([numbers[key(p)][0] for p in (below[i], below[i + 1], above[i + 1], above[i])])
    return [point for _, point in numbers.values()], squares


def write_surface(shell, path):
    """Writes triangles, with the names of the edges of the boundary, as a .vtk file."""
    points, squares = numbered(shell.grids(40))
    triangles = [t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))]
    edges = {tuple(sorted(pair)) for square in squares for pair in zip(square, square[1:] + square[:1])}
    lines = [(a, b, name) for a, b in sorted(edges) if (name := shell.side(points[a], points[b]))]
    rows = ["# vtk DataFile Version 3.0", shell.name, "ASCII", "DATASET POLYDATA", f"POINTS {len(points)} double"]
    rows += ["%r %r %r" % point for point in points] + [f"LINES {len(lines)} {3 * len(lines)}"]
    rows += [f"2 {a} {b}" for a, b, _ in lines] + [f"POLYGONS {len(triangles)} {4 * len(triangles)}"]
    rows += ["3 %d %d %d" % t for t in triangles]
    rows += [f"CELL_DATA {len(lines) + len(triangles)}", "FIELD names 1", f"Side 1 {len(lines) + len(triangles)} string"]
    rows += [name for _, _, name in lines] + [""] * len(triangles)
    path.write_text("\n".join(rows) + "\n")


def mapped_mesh(shell, quads):
    """Returns a mapped mesh of about as many quads of order 2 as the text of an .inp file."""
    n = max(1, round(math.sqrt(quads / len(numbered(shell.grids(1))[1]))))
    coarse, squares = numbered(shell.grids(n))
    fine, _ = numbered(shell.grids(2 * n))
    key = lambda point: tuple(round(x, 6) + 0.0 for x in point)  # noqa: E731
    number = {key(point): i for i, point in enumerate(fine)}
    middles = {}
    for grid in shell.grids(2 * n):
        for j, row in enumerate(grid):
            for i, point in enumerate(row):
                if (i + j) % 2 == 1:  # between its two neighbours with even numbers
                    ends = ((i - 1, j), (i + 1, j)) if i % 2 == 1 else ((i, j - 1), (i, j + 1))
                    middles[frozenset(key(grid[b][a]) for a, b in ends)] = number[key(point)]
    elements = []
    for square in squares:
        corners = [key(coarse[v]) for v in square]
        elements.append([number[c] for c in corners] + [
            middles[frozenset(pair)] for pair in zip(corners, corners[1:] + corners[:1])])
    used = sorted({node for element in elements for node in element})
    rows = ["*NODE"] + ["%d, %.12g, %.12g, %.12g" % (v + 1, *fine[v]) for v in used]
    rows += ["*ELEMENT, TYPE=S8R, ELSET=quads"] + [
        ", ".join(str(v) for v in [i + 1] + [v + 1 for v in element]) for i, element in enumerate(elements)]
    return "\n".join(rows) + "\n"


def solve(shell, folder, text):
    """Returns the number of quads of an .inp file without a step, and the displacement under the first load."""
    text = text.replace("TYPE=S8,", "TYPE=S8R,")
    places, elements = read_mesh(text)

    def nearest(point):
        return min(places, key=lambda node: math.dist(places[node], point))

    supports = [f"{node}, {freedom}" for node, place in places.items() for freedom in shell.supports.get(
        shell.side(place, place), ())]
    supports += [f"{nearest(point)}, {freedom}" for point, freedoms in shell.fixed.items() for freedom in freedoms]
    equations = [f"*EQUATION\n2\n{nearest(one)}, {freedom}, 1, {nearest(other)}, {freedom}, -1"
                 for one, other, freedom in shell.equal]
    loads = [f"{nearest(point)}, {freedom}, {force}" for point, (freedom, force) in shell.loads.items()]
    elset = text.split("ELSET=")[1].split("\n")[0].strip()
    (folder / "shell.inp").write_text(text + "\n".join(equations) + STEP.format(
        young=shell.young, thickness=shell.thickness, elements=elset, supports="\n".join(sorted(set(supports))),
        loads="\n".join(loads)))
    _, displacements, _ = run(folder, "shell")
    point, (freedom, force) = next(iter(shell.loads.items()))
    return len(elements), math.copysign(1, force) * displacements[nearest(point)][freedom - 1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="crossfield")
    parser.add_argument("--quads", type=int, nargs="+", default=[300, 1200, 4800])
    parser.add_argument("--keep", type=pathlib.Path)
    arguments = parser.parse_args()
    with working_folder(arguments.keep) as folder:
        for shell in (Cylinder, Hemisphere):
            write_surface(shell, folder / "surface.vtk")
            for quads in arguments.quads:
                command = [arguments.program, "quads", folder / "surface.vtk", "-o", folder / "quads.inp", "--quads", str(quads),
                           "--order", "2", "--json", folder / "report.json"]
                subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
                report = json.loads((folder / "report.json").read_text())
                count, moved = solve(shell, folder, (folder / "quads.inp").read_text())
                mapped_count, mapped = solve(shell, folder, mapped_mesh(shell, count))
                print(f"{shell.name}: {count} quads, irregular nodes {report['irregular']}, displacement over the literature's "
                      f"{moved / shell.reference:.4f}; mapped mesh of {mapped_count}: {mapped / shell.reference:.4f}")


if __name__ == "__main__":
    main()
