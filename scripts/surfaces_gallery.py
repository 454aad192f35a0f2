"""Meshes the surfaces of the gallery and writes the page: pvpython surfaces_gallery.py PROGRAM FOLDER [NAME...]

Writes into FOLDER: the surfaces NAME.vtp, NAME.vtu, NAME.json, surfaces_gallery.md and names.txt, the names of the pictures.
"""
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import textwrap
import time

import vtk

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from surface_shapes import bodies, parts  # noqa: E402
from surface_shapes.triangles import write  # noqa: E402

DOCS = pathlib.Path(__file__).resolve().parents[1] / "docs" / "surfaces"

PAGE = """# Gallery of surfaces

Each surface is a file of triangles, or a model, and one command makes the mesh. [Surfaces in space](surfaces.md) explains the input and the
output. `scripts/surfaces.sh` makes this page and writes the surfaces to build/surfaces_gallery, where the commands run; their shapes are in
`scripts/surface_shapes`. `bracket.off`, `ellipsoid.off` and `housing.step` are in docs/surfaces.

In the pictures nodes of valence 3 are red and nodes of valence 5 blue; thick lines are the boundary, sharp edges and lines between
regions. The table counts irregular nodes on these lines as well.

| surface | triangles | faces | sharp edges | χ | quads | irregular nodes | blocks | scaled Jacobian: minimum, mean | distance / size | seconds |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |
%s

*Table: the meshes of this page. Faces: the parts between sharp edges and lines between regions. Sharp edges: lines that quads follow
inside of the surface. χ: 2 − 2 × handles − boundary loops. Distance: the largest one of the centre of a quad from the triangles, divided
by the mean side length of the quads. Seconds: the time of the whole run on 2 cores, including files.*

%s
"""

EIGHT = "x,y,z,quarter_index\n" + "".join(
    "%g,%g,%g,1\n" % (x, y, z) for z in (0.462, -0.462) for x, y in ((0.866, 0.577), (-0.866, 0.577), (-0.866, -0.577), (0.866, -0.577)))

# Name, shape or file, options, direction of view, what the picture shows.
CASES = (
    ("sphere", bodies.sphere, "--quads 600 --merge coarse", (2, -3, 1.6),
     "A sphere. `--merge coarse` merges separatrices, for few blocks."),
    ("ellipsoid", "ellipsoid.off", "-s eight.csv --quads 1500", (2, -3, 1.6),
     "An ellipsoid with eight given singularities, the table of [Surfaces in space](surfaces.md)."),
    ("egg", bodies.egg, "--chord-error 0.004", (2, -3, 0.8),
     "An egg. With `--chord-error` quads are smaller where the surface is more curved."),
    ("torus", bodies.torus, "--quads 1800", (1, -2, 2.5),
     "A torus needs no irregular nodes."),
    ("two_rings", bodies.two_rings, "--quads 2000", (0.5, -2, 3),
     "A surface with two handles, where two rings blend into each other: quarter indices add up to −8. "
     "Where separatrices nearly meet, between the rings, quads are narrow."),
    ("three_rings", bodies.three_rings, "--quads 3000", (0.5, -2, 3.4),
     "Three rings that blend into each other, with three handles: quarter indices add up to −16. A strip of quads is narrow."),
    ("frame", bodies.frame_of_potentials, "--quads 4000", (0.5, -2, 3),
     "A level of a sum of five potentials, as an example of an isosurface."),
    ("wavelet", bodies.wavelet, "--quads 3000", (2, -3, 1.6),
     "The largest part of a level of VTK's wavelet. [An example](../examples/isosurface/README.md) meshes the same surface in Python."),
    ("bumpy", bodies.bumpy, "--quads 2000", (2, -3, 1.6),
     "A body with bumps of several sizes, like a scan of a stone."),
    ("aeroplane", bodies.aeroplane, "--quads 4000", (2, -2, 3),
     "A fuselage and a wing that blend into each other."),
    ("tee", bodies.tee, "--quads 1500 --order 2", (1, -3, 2),
     "Two pipes that meet, as quads with nine nodes. The three ends are open."),
    ("terrain", bodies.terrain, "--size 0.15 --size-near 1.8,2.4,0.5:0.05,0.5", (0.6, -2, 2),
     "Heights over a rectangle. `--size-near` requests small quads at the higher summit."),
    ("gutter", bodies.gutter, "--quads 600", (-2, -2, 3),
     "Half a pipe that is bent by 90°. Its four corners suffice."),
    ("spring", bodies.spring, "--quads 2000", (1, -3, 1.6),
     "A tube along a helix, open at both ends. Smooth crosses have eight pairs of singularities on it, which are left out."),
    ("panel", parts.panel, "--quads 1200", (0.4, -1.4, 3),
     "A bent plate with three holes."),
    ("car_body", parts.car_body, "--quads 2500 --count front_window:56 --size-at filler_cap:0.03", (0.3, -3, 0.7),
     "The side of a car: a doubly curved sheet with wheel arches, two windows and a filler cap. The holes have names in the cell array `Side` "
     "of line cells: `--count` prescribes the number of edges of one window, and `--size-at` the length of edges at the filler cap."),
    ("dome", parts.dome, "--quads 900", (1, -2, 2.2),
     "A dome of steel with a window of glass, two regions that are named in the cell array `Region`."),
    ("bracket", "bracket.off", "--quads 1500", (2, -3, 3),
     "An angle bracket with two holes and sharp edges."),
    ("box", parts.box, "--quads 1200", (1.6, -3, 2.4),
     "A box with a hole through it."),
    ("can", parts.can, "--quads 1200", (1.6, -3, 2.4),
     "A cylinder with lids, which are faces of their own."),
    ("flange", parts.flange, "--quads 1500", (1.6, -3, 2.8),
     "A piece of pipe with a flange."),
    ("gear", parts.gear, "--quads 2500", (0.6, -2, 2.6),
     "A gear wheel with ten teeth and a bore."),
    ("housing", "housing.step", "--all-faces --quads 2500", (2, -3, 2.4),
     "All faces of a model, with their names as regions."),
)


# Tables of singularities.
TABLES = {"eight.csv": EIGHT}


def write_input(folder, name, shape):
    """Writes the surface into the folder and returns the name of its file."""
    if not callable(shape):
        shutil.copy(DOCS / shape, folder)
        return shape
    write(shape(), folder / (name + ".vtp"))
    return name + ".vtp"


def triangles_of(file):
    """Returns the triangles of a file, as lists of indices."""
    if file.suffix == ".off":
        words = file.read_text(encoding="utf-8").split()
        points, count = int(words[1]), int(words[2])
        first = 4 + 3 * points
        return [[int(word) for word in words[at + 1:at + 4]] for at in range(first, first + 4 * count, 4)]
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    data = reader.GetOutput()
    cells = range(data.GetNumberOfLines(), data.GetNumberOfCells())  # VTK numbers lines before triangles
    return [[data.GetCell(cell).GetPointId(k) for k in range(3)] for cell in cells]


def triangles_and_characteristic(file):
    """Returns the number of triangles of a file and its Euler characteristic, or nothing for a model."""
    if file.suffix == ".step":
        return None
    triangles = triangles_of(file)
    used = {point for corners in triangles for point in corners}
    edges = {frozenset(pair) for corners in triangles for pair in zip(corners, corners[1:] + corners[:1])}
    return len(triangles), len(used) - len(edges) + len(triangles)


def row(name, report, known, seconds):
    jacobian, sizes = report["scaled_jacobian"], report["sizes"]
    followed = re.search(r"(\d+) lines? between (\d+) faces", " ".join(report.get("events", [])))
    nodes = ["%d of valence %s" % (count, valence) for valence, count in report["irregular"].items()]
    return "| %s | %s | %s | %s | %s | %d | %s | %d | %.3f, %.4f | %.3f | %.1f |" % (
        name.replace("_", " "), known[0] if known else "model", followed[2] if followed else 1, followed[1] if followed else "none",
        str(known[1]).replace("-", "−") if known else "", report["quads"], ", ".join(nodes) or "none", report["blocks"],
        jacobian["min"], jacobian["mean"], report["surface_distance"]["max"] / sizes["mean"], seconds)


def run(program, folder, arguments):
    done = subprocess.run([program, *arguments], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        sys.exit("crossfield %s: %s" % (shlex.join(arguments), done.stdout))
    print("meshed", done.stdout.strip(), flush=True)


def main(program, folder, wanted):
    table, pictures, names = [], [], []
    for file, rows in TABLES.items():
        (folder / file).write_text(rows, encoding="utf-8")
    for name, shape, options, _, text in CASES:
        if wanted and name not in wanted:
            continue
        file = write_input(folder, name, shape)
        command = ["quads", file, *shlex.split(options), "-o", name + ".vtu"]
        started = time.monotonic()
        run(program, folder, [*command, "--json", name + ".json"])
        seconds = time.monotonic() - started
        report = json.loads((folder / (name + ".json")).read_text(encoding="utf-8"))
        table.append(row(name, report, triangles_and_characteristic(folder / file), seconds))
        names.append(name)
        title = name.replace("_", " ").capitalize()
        pictures.append("## %s\n\n```sh\ncrossfield %s\n```\n\n![%s](surfaces_gallery/%s.png)\n\n%s" % (
            title, shlex.join(command), title, name, textwrap.fill(text, 140)))
    (folder / "surfaces_gallery.md").write_text(PAGE % ("\n".join(table), "\n\n".join(pictures)), encoding="utf-8")
    (folder / "names.txt").write_text("\n".join(names) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:])
