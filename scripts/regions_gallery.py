"""Meshes the domains of the gallery of several materials and writes the page: python3 regions_gallery.py PROGRAM FOLDER [NAME...]

Writes the domains of tests/data/regions that are missing, meshes each with one command, and writes into FOLDER: NAME.vtu, NAME.json,
regions_gallery.md and names.txt, the names of the pictures.
"""
import json
import math
import pathlib
import shlex
import subprocess
import sys
import textwrap
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
DATA = ROOT / "tests" / "data" / "regions"

PAGE = """# Gallery of several materials

Each domain is a file of polygons with the cell array `Material`, or a drawing, and one command makes the mesh.
[Several materials](regions.md) explains the input and the output. `scripts/regions.sh` makes this page;
`scripts/regions_gallery.py` has the shapes.

In the pictures each material has a colour and interfaces are thick lines. Nodes of valence 3 are red, nodes of valence 5 blue. The table counts
irregular nodes on interfaces as well.

| domain | materials | regions | quads | irregular nodes | scaled Jacobian: minimum, attainable, mean | size ratio | seconds |
| --- | --- | --- | --- | --- | --- | --- | --- |
%s

*Table: the meshes of this page. Size ratio: the largest ratio of the areas of two quads on both sides of an interface. Seconds: the time of
the whole run on 2 cores, including files.*

| domain | edges on each interface |
| --- | --- |
%s

*Table: number of edges on the interfaces between two materials.*

%s
"""


def arc(x, y, radius, begin, end, count):
    """Returns points of an arc; angles in degrees, both ends included."""
    angles = [math.radians(begin + (end - begin) * i / count) for i in range(count + 1)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]


def circle(x, y, radius, count=48):
    return arc(x, y, radius, 0, 360, count)[:-1]


def box(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def halves(loop):
    """Returns the lower and the upper part of a loop in counter-clockwise order, both from its leftmost to its rightmost point."""
    left = min(range(len(loop)), key=lambda i: loop[i])
    turned = loop[left:] + loop[:left]
    right = max(range(len(loop)), key=lambda i: turned[i])
    return turned[:right + 1], [turned[0]] + turned[:right - 1:-1]


def between(material, outer, holes):
    """Returns the rest of a loop outside of loops in it, as two polygons, because a polygon has no holes.

    The cut leads through all holes from left to right. The rightmost point of each is left of the next one.
    """
    below, above = halves(outer)
    lower, upper = [], []
    for hole in holes:
        part = halves(hole)
        lower += part[0]
        upper += part[1]
    return [(material, below + lower[::-1]), (material, upper + above[::-1])]


def composite():
    """Returns a laminate of seven layers with a ripple that decays towards its surfaces."""
    layers = (("ply0", 0.16), ("ply45", 0.1), ("ply90", 0.2), ("resin", 0.03), ("ply90", 0.2), ("ply45", 0.1), ("ply0", 0.16))
    total, count = sum(thickness for _, thickness in layers), 80

    def level(height):
        part = math.sin(math.pi * height / total)
        return [(3.0 * i / count, height + 0.09 * part * math.sin(2 * math.pi * i / count)) for i in range(count + 1)]
    polygons, height = [], 0.0
    for material, thickness in layers:
        polygons.append((material, level(height) + level(height + thickness)[::-1]))
        height += thickness
    return polygons


def fibre_hexagonal(radius=0.8268):
    """Returns a hexagonal cell with a fibre of 62 % of its volume."""
    hexagon = [(math.cos(math.radians(60 * i)) * 2 / 3 ** 0.5, math.sin(math.radians(60 * i)) * 2 / 3 ** 0.5) for i in range(6)]
    fibre = circle(0, 0, radius)
    return [("fibre", fibre), *between("matrix", hexagon, [fibre])]


def fibre_square(radius=0.85):
    """Returns a square cell with a quarter of a fibre at each corner."""
    corners, matrix, polygons = box(-1, -1, 1, 1), [], []
    for i, (x, y) in enumerate(corners):
        quarter = arc(x, y, radius, 90 * i, 90 * (i + 1), 16)
        polygons.append(("fibre", [(x, y)] + quarter))
        matrix += quarter[::-1]
    return [("matrix", matrix), *polygons]


def pipe():
    """Returns a steel pipe with insulation in soil, empty inside."""
    inside, steel, insulation = (circle(0, 0, radius) for radius in (0.5, 0.56, 0.8))
    return [*between("steel", steel, [inside]), *between("insulation", insulation, [steel]),
            *between("soil", box(-2, -1.8, 2, 1.2), [insulation])]


def bimetal():
    """Returns a bent strip of steel and brass."""
    def layer(inner, outer):
        return arc(0, 0, outer, 30, 150, 48) + arc(0, 0, inner, 150, 30, 48)
    return [("steel", layer(4.0, 4.25)), ("brass", layer(4.25, 4.6))]


def ends_of_bimetal():
    """Returns the sides of the strip that have names."""
    return [(name, [arc(0, 0, radius, angle, angle, 1)[0] for radius in (4.0, 4.25, 4.6)]) for name, angle in (("left", 150), ("right", 30))]


def wing():
    """Returns a wing section: the skin of a NACA 0018 profile, the spar, and cores of foam before and behind it."""
    def half(s):
        return 0.9 * (0.2969 * s ** 0.5 - 0.126 * s - 0.3516 * s ** 2 + 0.2843 * s ** 3 - 0.1015 * s ** 4)
    stations = [0.5 * (1 - math.cos(math.pi * i / 50)) for i in range(51)]
    upper = [(s, half(s)) for s in stations]
    thickness, spar = 0.008, (0.27, 0.30)

    def inner(s):
        """Returns the height of the lower side of the skin above s by intersecting the offset polyline."""
        moved = []
        for (a, b), (c, d) in zip(upper, upper[1:]):
            length = math.hypot(c - a, d - b)
            x, y = thickness * (d - b) / length, -thickness * (c - a) / length
            moved.append(((a + x, b + y), (c + x, d + y)))
        best = None
        for (a, b), (c, d) in moved:
            if a <= s <= c:
                y = b + (d - b) * (s - a) / (c - a)
                best = y if best is None else min(best, y)
        return best
    last = 0.86
    inside = [thickness + (last - thickness) * 0.5 * (1 - math.cos(math.pi * i / 40)) for i in range(41)]
    inside = sorted({*[s for s in inside if all(abs(s - one) > 0.012 for one in spar)], *spar})
    height = {s: inner(s) for s in inside[1:]}
    height[inside[0]] = 0.0
    roof = [(s, height[s]) for s in inside]

    def core(begin, end):
        part = [p for p in roof if begin <= p[0] <= end]
        return [(x, -y) for x, y in part] + [p for p in part[::-1] if p[1] > 0]
    outline = [(x, -y) for x, y in upper] + upper[:0:-1]
    hollow = [(x, -y) for x, y in roof] + roof[:0:-1]
    return [*between("skin", outline, [hollow]), ("foam", core(0, spar[0])), ("spar", core(*spar)), ("foam", core(spar[1], 1))]


def slot():
    """Returns a tooth pitch of a stator: iron, a conductor with insulation around it, and air in the opening and the gap."""
    iron = [(-1, 0.15), (-0.25, 0.15), (-0.25, 0.3), (-0.5, 0.5), (-0.65, 2.2), (0.65, 2.2), (0.5, 0.5), (0.25, 0.3), (0.25, 0.15), (1, 0.15),
            (1, 3), (-1, 3)]
    copper = [(-0.43, 0.6), (0.43, 0.6), (0.56, 2.1), (-0.56, 2.1)]
    paper = [(-0.5, 0.5), (0.5, 0.5), (0.65, 2.2), (-0.65, 2.2)]
    air = [(-1, 0), (1, 0), (1, 0.15), (0.25, 0.15), (0.25, 0.3), (0.5, 0.5), (-0.5, 0.5), (-0.25, 0.3), (-0.25, 0.15), (-1, 0.15)]
    return [("iron", iron), ("copper", copper), *between("insulation", paper, [copper]), ("air", air)]


def grains():
    """Returns three grains of equal angles at a triple junction, with curved boundaries."""
    def boundary(angle, length):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        bend = 0.06
        points = [(length * i / 24, bend * (1 - math.cos(2 * math.pi * i / 24)) / 2) for i in range(25)]
        return [(c * x - s * y, s * x + c * y) for x, y in points]
    rim = circle(0, 0, 1, 72)
    parts = [boundary(90 + 120 * i, 1) for i in range(3)]
    polygons = []
    for i, name in enumerate(("alpha", "beta", "gamma")):
        first, last = 18 + 24 * i, 18 + 24 * (i + 1)
        edge = [rim[k % 72] for k in range(first, last + 1)]
        start, end = parts[i][:-1], parts[(i + 1) % 3][:-1]
        polygons.append((name, start + edge + end[:0:-1]))
    return polygons


def wavy(x, y, across, high, waves, count):
    """Returns a smooth closed curve: an ellipse whose radius has waves of (number, amplitude, phase)."""
    curve = []
    for i in range(count):
        a = 2 * math.pi * i / count
        r = 1 + sum(part * math.cos(n * a + phase) for n, part, phase in waves)
        curve.append((x + across * r * math.cos(a), y + high * r * math.sin(a)))
    return curve


def lakes():
    """Returns an island with four lakes in the sea; an island is in the second lake."""
    coast = wavy(0, 0, 3.0, 1.7, ((2, 0.10, 0.7), (3, 0.12, 1.9), (5, 0.06, 0.3), (7, 0.03, 2.0)), 160)
    waters = [wavy(-1.9, 0.1, 0.33, 0.22, ((2, 0.12, 1.0), (3, 0.1, 0.2)), 40),
              wavy(-0.45, -0.2, 0.75, 0.5, ((2, 0.1, 2.0), (3, 0.12, 0.9)), 72),
              wavy(0.95, 0.5, 0.34, 0.3, ((3, 0.13, 2.5),), 40),
              wavy(1.85, -0.1, 0.3, 0.24, ((2, 0.15, 0.0), (3, 0.06, 1.0)), 40)]
    islet = wavy(-0.45, -0.22, 0.36, 0.24, ((3, 0.1, 0.5),), 36)
    return [*between("sea", box(-4.2, -2.8, 4.2, 2.8), [coast]), *between("land", coast, waters),
            *[("lake", one) for i, one in enumerate(waters) if i != 1], *between("lake", waters[1], [islet]), ("land", islet)]


def weld():
    """Returns a butt weld with a single V, a cap, a root that is ground flush, and heat-affected zones."""
    def side(shift, mirror):
        return [(mirror * (x + shift), y) for x, y in ((0.12, 0.0), (0.62, 1.0))]
    zone = 0.2
    cap = [(0.62 - 1.24 * i / 16, 1 + 0.14 * (1 - (1 - i / 8) ** 2)) for i in range(17)]
    polygons = [("weld", [(-0.12, 0.0), (0.12, 0.0), *cap])]
    for mirror in (1, -1):
        fusion, end = side(0, mirror), side(zone, mirror)
        far = [(3.0 * mirror, 0.0), (3.0 * mirror, 1.0)]
        for material, a, b in (("zone", fusion, end), ("plate", end, far)):
            polygons.append((material, [a[0], b[0], b[1], a[1]][::mirror]))
    return polygons


# Name, shape, options, what the picture shows.
CASES = (
    ("composite", composite, "--size 0.06 --size-in resin:0.03",
     "A laminate 0/45/90/90/45/0 with a ripple and a layer of resin in the middle. `--size-in` requests small quads in the resin, and sizes grow "
     "from there. Every layer is one block, so all layers have equal numbers of quads along them."),
    ("fibre_hexagonal", fibre_hexagonal, "--quads 1200 --curves auto --periodic outer0:outer3 --periodic outer1:outer4 --periodic outer2:outer5",
     "A hexagonal cell with a fibre of 62 % of its volume. `--curves auto` places the nodes on the true circle, and "
     "nodes of opposite sides match."),
    ("fibre_square", fibre_square, "--quads 400 --curves auto --order 2",
     "A square cell with quarter fibres at its corners, as quads with nine nodes whose edges follow the circles."),
    ("pipe", pipe, "--size 0.15 --curves auto --count insulation+steel:40",
     "A steel pipe with insulation in soil, empty inside. `--count` prescribes the number of edges on the interface of steel and insulation, and with "
     "it that of the other circles."),
    ("bimetal", bimetal, "--size 0.1 --curves auto --order 2",
     "A bent strip of two metals as a file for CalculiX: an element set for each material, sets for the sides `left` and `right`, which lines of the "
     "input name, and a surface for the interface."),
    ("wing", wing, "--size 0.012 --size-in skin:0.008",
     "A NACA 0018 wing section with a skin that is solid at the trailing edge, a spar, and cores of foam before and behind it. `--size-in` "
     "requests smaller quads in the skin."),
    ("slot", slot, "--quads 1500 --size-at copper+insulation:0.05",
     "One slot of a motor: iron, a conductor in its insulation, and air. `--size-at` requests the length of the edges around the conductor. The "
     "scaled Jacobian at the lower corners of the slot is limited by the angle of the air there, 39°."),
    ("stator", None, "--quads 2000",
     "A sector of a stator as a drawing with lines and arcs that branch. The regions are what lines enclose, with names by decreasing area. The "
     "interfaces have the names of the layers of the drawing."),
    ("grains", grains, "--quads 900 --curves auto",
     "Three grains that meet at angles of 120°. The common node has valence 3, and each grain has one node of valence 3 inside."),
    ("lakes", lakes, "--quads 3000",
     "An island in the sea, with four lakes and an islet in one of them."),
    ("weld", weld, "--size 0.12 --size-in weld:0.06",
     "A butt weld between two plates, with heat-affected zones. `--size-in` requests smaller quads in the weld."),
)
WRITTEN = {"bimetal": "bimetal.inp"}  # other formats than .vtu
EXTENSION = {"stator": ".dxf"}
SIDES = {"bimetal": ends_of_bimetal}


def array(kind, name, values, components=1):
    return '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="ascii">\n%s\n</DataArray>' % (
        kind, name, components, " ".join(map(str, values)))


def strings(name, values):
    """Returns a cell array of strings, which VTK writes as numbers of their characters."""
    letters = [code for value in values for code in (*value.encode(), 0)]
    return '<Array type="String" Name="%s" NumberOfTuples="%d" format="ascii">\n%s\n</Array>' % (name, len(values), " ".join(map(str, letters)))


def cells_of(tag, cells):
    ends = [sum(map(len, cells[:i + 1])) for i in range(len(cells))]
    return "<%s>\n%s\n%s\n</%s>" % (
        tag, array("Int64", "connectivity", [i for cell in cells for i in cell]), array("Int64", "offsets", ends), tag)


def write_partition(file, polygons, sides=()):
    """Writes polygons with materials, and lines with the names of sides, as a .vtp file; points at the same place are one."""
    places = {}

    def ids(points):
        return [places.setdefault((round(x, 9) + 0.0, round(y, 9) + 0.0), len(places)) for x, y in points]
    faces, lines = [ids(polygon) for _, polygon in polygons], [ids(line) for _, line in sides]
    names = [strings("Material", [""] * len(sides) + [material for material, _ in polygons])]
    if sides:
        names.append(strings("Side", [side for side, _ in sides] + [""] * len(polygons)))
    file.write_text("\n".join([
        '<?xml version="1.0"?>', '<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">', "<PolyData>",
        '<Piece NumberOfPoints="%d" NumberOfLines="%d" NumberOfPolys="%d">' % (len(places), len(lines), len(faces)),
        "<CellData>", *names, "</CellData>",
        "<Points>\n%s\n</Points>" % array("Float64", "Points", ["%.9g" % value for place in places for value in (*place, 0)], 3),
        cells_of("Lines", lines), cells_of("Polys", faces),
        "</Piece>", "</PolyData>", "</VTKFile>", ""]), encoding="utf-8")


def nodes(report):
    counts = ["%d of valence %s" % (count, valence) for valence, count in report["irregular"].items()]
    return ", ".join(counts) or "none"


def rows(name, report, seconds):
    """Returns the rows of both tables."""
    jacobian = report["scaled_jacobian"]
    ratios = [interface["size_ratio"]["max"] for interface in report["interfaces"]]
    edges = ["`%s` %d" % (interface["name"], interface["edges"]) for interface in report["interfaces"]]
    return ("| %s | %s | %d | %d | %s | %.3f, %.3f, %.4f | %.2f | %.1f |" % (
        name.replace("_", " "), ", ".join(dict.fromkeys(region["name"] for region in report["regions"])), len(report["regions"]),
        report["quads"], nodes(report), jacobian["min"], jacobian["bound"], jacobian["mean"], max(ratios), seconds),
        "| %s | %s |" % (name.replace("_", " "), ", ".join(edges)))


def run(program, folder, name, output, options):
    """Meshes a domain and returns the report."""
    domain = DATA / (name + EXTENSION.get(name, ".vtp"))
    report = folder / (name + ".json")
    done = subprocess.run([program, "quads", str(domain), "-o", output, *shlex.split(options), "--json", str(report)], cwd=folder,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        sys.exit("%s was not meshed: %s" % (name, done.stdout))
    print("meshed", name, done.stdout.strip(), flush=True)
    return json.loads(report.read_text(encoding="utf-8"))


def main(program, folder, wanted):
    DATA.mkdir(exist_ok=True)
    table, interfaces, pictures, names = [], [], [], []
    for name, shape, options, text in CASES:
        if wanted and name not in wanted:
            continue
        if shape and not (DATA / (name + ".vtp")).exists():
            write_partition(DATA / (name + ".vtp"), shape(), SIDES.get(name, list)())
        output = WRITTEN.get(name, name + ".vtu")
        started = time.monotonic()
        report = run(program, folder, name, output, options)
        row, interface = rows(name, report, time.monotonic() - started)
        if name in WRITTEN:
            run(program, folder, name, name + ".vtu", options)  # for the picture
        table.append(row)
        interfaces.append(interface)
        names.append(name)
        title = name.replace("_", " ").capitalize()
        pictures.append("## %s\n\n```sh\ncrossfield quads tests/data/regions/%s -o %s %s\n```\n\n![%s](regions_gallery/%s.png)\n\n%s" % (
            title, name + EXTENSION.get(name, ".vtp"), output, options, title, name, textwrap.fill(text, 140)))
    (folder / "regions_gallery.md").write_text(PAGE % ("\n".join(table), "\n".join(interfaces), "\n\n".join(pictures)), encoding="utf-8")
    (folder / "names.txt").write_text("\n".join(names) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:])
