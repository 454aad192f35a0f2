"""bracket.py with tetrahedra of Gmsh: python3 gmsh_tetrahedra.py [SIZE ...]

Needs the Debian packages calculix-ccx and python3-gmsh.
"""
import pathlib
import sys
import tempfile

import gmsh

from bracket import DEPTH, INNER, LEG, THICKNESS, results_of

FACES = [{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}]  # corners of the faces of C3D10, in the order of S1 to S4


def mesh_of(size):
    """Returns the mesh as text of an .inp file; sizes in the fillet are a third of the others."""
    gmsh.model.add("bracket")
    cad = gmsh.model.geo
    places = [(0, 0), (LEG, 0), (LEG, THICKNESS), (INNER, THICKNESS), (THICKNESS, INNER), (THICKNESS, LEG), (0, LEG), (INNER, INNER)]
    points = [cad.addPoint(x, y, 0, size / 3 if i in (3, 4) else size) for i, (x, y) in enumerate(places)]
    lines = [cad.addLine(points[i], points[i + 1]) for i in (0, 1, 2)] + [cad.addCircleArc(points[3], points[7], points[4])]
    lines += [cad.addLine(points[i], points[(i + 1) % 7]) for i in (4, 5, 6)]
    surface = cad.addPlaneSurface([cad.addCurveLoop(lines)])
    swept = cad.extrude([(2, surface)], 0, 0, DEPTH)
    cad.synchronize()
    for name, value in {"Optimize": 1, "ElementOrder": 2, "HighOrderOptimize": 2}.items():
        gmsh.option.setNumber("Mesh." + name, value)
    gmsh.model.mesh.generate(3)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    [_], [elements], [nodes] = gmsh.model.mesh.getElements(3)
    rows = [list(map(int, nodes[i:i + 10])) for i in range(0, len(nodes), 10)]
    for row in rows:
        row[8], row[9] = row[9], row[8]  # Gmsh has the last two middles in the other order
    used = {node for row in rows for node in row}
    text = ["*NODE, NSET=NALL"] + ["%d, %.12e, %.12e, %.12e" % (tag, *coordinates[3 * i:3 * i + 3])
                                   for i, tag in enumerate(tags) if tag in used]
    text += ["*ELEMENT, TYPE=C3D10, ELSET=domain"] + [", ".join(map(str, [tag, *row])) for tag, row in zip(elements, rows)]
    sides = {name: set(map(int, gmsh.model.mesh.getNodes(2, swept[2 + i][1], includeBoundary=True)[0]))
             for name, i in (("wall", 6), ("shelf", 2))}
    text += ["*NSET, NSET=wall"] + [str(node) for node in sorted(sides["wall"])]
    text += ["*SURFACE, NAME=shelf, TYPE=ELEMENT"]
    text += ["%d, S%d" % (tag, face + 1) for tag, row in zip(elements, rows) for face, corners in enumerate(FACES)
             if {row[i] for i in corners} <= sides["shelf"]]
    gmsh.model.remove()
    return "\n".join(text) + "\n"


def main():
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 1)
    for size in map(float, sys.argv[1:] or ("8", "5", "3.5")):
        with tempfile.TemporaryDirectory() as temporary:
            nodes, stress, deflection = results_of(pathlib.Path(temporary), mesh_of(size))
        print(f"{nodes} nodes: fillet {stress:.2f} MPa, tip {deflection:.4f} mm")


if __name__ == "__main__":
    main()
