"""plate.py with quads of Gmsh: python3 gmsh_quads.py [SIZE ...]

Needs the Debian packages calculix-ccx and python3-gmsh.
"""
import math
import pathlib
import sys
import tempfile

import gmsh

from plate import LENGTH, RADIUS, STEP, TENSION, WIDTH
from calculix import pressure_on, run  # plate.py adds its folder


def write_mesh(path, size):
    """Meshes the quarter of the plate with quads of order 2 and the given size; returns the number of corner nodes."""
    gmsh.model.add("plate")
    cad = gmsh.model.geo
    places = [(RADIUS, 0), (WIDTH, 0), (WIDTH, LENGTH), (0, LENGTH), (0, RADIUS), (0, 0)]
    points = [cad.addPoint(x, y, 0, size) for x, y in places]
    lines = [cad.addLine(*points[i:i + 2]) for i in range(4)]
    arc = cad.addCircleArc(points[4], points[5], points[0])
    surface = cad.addPlaneSurface([cad.addCurveLoop([*lines, arc])])
    cad.synchronize()
    for name, value in {"RecombineAll": 1, "RecombinationAlgorithm": 3, "Algorithm": 6, "ElementOrder": 2,
                        "SecondOrderIncomplete": 1}.items():
        gmsh.option.setNumber("Mesh." + name, value)
    gmsh.model.mesh.generate(2)
    tags, coordinates, _ = gmsh.model.mesh.getNodes(includeBoundary=True)
    [kind], [elements], [nodes] = gmsh.model.mesh.getElements(2, surface)
    if gmsh.model.mesh.getElementProperties(kind)[3] != 8:
        raise SystemExit("Not all elements are quads.")
    rows = [list(map(int, nodes[i:i + 8])) for i in range(0, len(nodes), 8)]
    used = {node for row in rows for node in row}
    text = ["*NODE"] + ["%d, %.12e, %.12e, 0" % (tag, *coordinates[3 * i:3 * i + 2])
                        for i, tag in enumerate(tags) if tag in used]
    text += ["*ELEMENT, TYPE=CPS8, ELSET=domain"]
    text += [", ".join(map(str, [tag, *row])) for tag, row in zip(elements, rows)]
    sides = {}
    for name, line in (("bottom", lines[0]), ("top", lines[2]), ("left", lines[3])):
        sides[name] = set(map(int, gmsh.model.mesh.getNodes(1, line, includeBoundary=True)[0]))
        text += ["*NSET, NSET=" + name] + [str(node) for node in sorted(sides[name])]
    text += ["*SURFACE, NAME=top, TYPE=ELEMENT"]
    text += ["%d, S%d" % (tag, edge + 1) for tag, row in zip(elements, rows) for edge in range(4)
             if {row[edge], row[(edge + 1) % 4]} <= sides["top"]]
    mesh = "\n".join(text) + "\n"
    path.write_text(mesh + STEP.format(loads=pressure_on(mesh, "top", -TENSION)))
    gmsh.model.remove()
    return len({node for row in rows for node in row[:4]})


def main():
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 1)
    for size in map(float, sys.argv[1:] or ("0.125", "0.06", "0.031")):
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            nodes = write_mesh(folder / "plate.inp", size)
            places, _, stresses = run(folder, "plate")
            stress = stresses[min(stresses, key=lambda node: math.dist(places[node][:2], (RADIUS, 0)))][1]
        print(f"{nodes} nodes of quads: Kt {stress / TENSION:.3f}")


if __name__ == "__main__":
    main()
