"""Writes small drawings of every format that the program reads: a plate of 4 by 2 with a round hole of
radius 0.5 at (1, 1), whose sides are named wall and hole."""

import json
import struct

HOLE = [(1.5, 1.0), (0.5, 1.0)]  # ends of its two halves


def dxf(entities, units=None, blocks=()):
    """Returns a .dxf of entities (type, code, value, code, value, ...)."""
    lines = []

    def add(rows):
        for row in rows:
            lines.extend(["0", row[0]])
            lines.extend(str(word) for word in row[1:])

    if units is not None:
        lines.extend(["0", "SECTION", "2", "HEADER", "9", "$INSUNITS", "70", str(units), "0", "ENDSEC"])
    if blocks:
        lines.extend(["0", "SECTION", "2", "BLOCKS"])
        add(blocks)
        lines.extend(["0", "ENDSEC"])
    lines.extend(["0", "SECTION", "2", "ENTITIES"])
    add(entities)
    return "\n".join(lines + ["0", "ENDSEC", "0", "EOF", ""])


def line(a, b, layer="wall"):
    return ("LINE", 8, layer, 10, a[0], 20, a[1], 11, b[0], 21, b[1])


def circle(centre, radius, layer="hole"):
    return ("CIRCLE", 8, layer, 10, centre[0], 20, centre[1], 40, radius)


def plate(shift=0.0):
    """Returns the entities of the plate, at (shift, shift)."""
    corners = [(shift, shift), (4 + shift, shift), (4 + shift, 2 + shift), (shift, 2 + shift)]
    return [line(a, b) for a, b in zip(corners, corners[1:] + corners[:1])] + [
        circle((1 + shift, 1 + shift), 0.5)]


def plate_dxf(shift=0.0, units=4):
    return dxf(plate(shift), units)


SVG = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" width="4mm" height="2mm" viewBox="0 0 4 2">
  <g id="wall"><path d="M0 0H4V2H0Z"/></g>
  <circle id="hole" cx="1" cy="1" r="0.5"/>
</svg>
"""

GEOJSON = json.dumps({"type": "Polygon", "coordinates": [
    [[0, 0], [4, 0], [4, 2], [0, 2], [0, 0]], [[1.5, 1], [1, 1.5], [0.5, 1], [1, 0.5], [1.5, 1]]]})

NODES = [(0, 0), (4, 0), (4, 2), (0, 2), (1.5, 1), (1, 1.5), (0.5, 1), (1, 0.5)]
EDGES = [(1, 2, 1), (2, 3, 1), (3, 4, 1), (4, 1, 1), (5, 6, 2), (6, 7, 2), (7, 8, 2), (8, 5, 2)]
NAMES = '$PhysicalNames\n2\n1 1 "wall"\n1 2 "hole"\n$EndPhysicalNames\n'


def msh22():
    nodes = "".join("%d %g %g 0\n" % (i + 1, x, y) for i, (x, y) in enumerate(NODES))
    edges = "".join("%d 1 2 %d %d %d %d\n" % (i + 1, group, group, a, b)
                    for i, (a, b, group) in enumerate(EDGES))
    return ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + NAMES + "$Nodes\n%d\n%s$EndNodes\n$Elements\n%d\n%s$EndElements\n"
            % (len(NODES), nodes, len(EDGES), edges))


def msh41():
    nodes = "\n".join(map(str, range(1, 9))) + "\n" + "".join("%g %g 0\n" % place for place in NODES)
    blocks = "".join("1 %d 1 4\n" % group + "".join(
        "%d %d %d\n" % (i + 1, a, b) for i, (a, b, of) in enumerate(EDGES) if of == group) for group in (1, 2))
    return ("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + NAMES +
            "$Entities\n0 2 0 0\n1 0 0 0 4 2 0 1 1 0\n2 0 0 0 2 2 0 1 2 0\n$EndEntities\n"
            "$Nodes\n1 8 1 8\n1 1 0 8\n" + nodes + "$EndNodes\n$Elements\n2 8 1 8\n" + blocks + "$EndElements\n")


def msh22_binary():
    """Returns bytes."""
    text = b"$MeshFormat\n2.2 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n" + NAMES.encode()
    text += b"$Nodes\n8\n" + b"".join(
        struct.pack("<iddd", i + 1, x, y, 0.0) for i, (x, y) in enumerate(NODES)) + b"\n$EndNodes\n"
    text += b"$Elements\n8\n" + struct.pack("<iii", 1, 8, 2) + b"".join(
        struct.pack("<iiiii", i + 1, group, group, a, b) for i, (a, b, group) in enumerate(EDGES))
    return text + b"\n$EndElements\n"


def naca(count=40, blunt=True):
    """Returns a NACA 0012 in Selig's format."""
    import math

    def half(x):
        return 0.6 * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3
                      - (0.1015 if blunt else 0.1036) * x**4)
    upper = [(0.5 * (1 + math.cos(math.pi * i / count)),) for i in range(count + 1)]
    rows = [(x, half(x)) for (x,) in upper[:-1]] + [(0.0, 0.0)] + [(x, -half(x)) for (x,) in upper[-2::-1]]
    return "NACA 0012\n" + "".join("%.9f %.9f\n" % row for row in rows)
