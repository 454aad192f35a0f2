"""Functions that the examples with CalculiX share: their folder, loads for its input, and results from its output.

    python3 calculix.py MESH.inp RESULT.frd SIDE...

prints the largest von Mises stress at the nodes of each side, and where it is. RESULT.frd has the nodes of MESH.inp: the step
writes it with OUTPUT=2D if its elements are plane.
"""
import contextlib
import pathlib
import re
import subprocess
import sys
import tempfile


@contextlib.contextmanager
def working_folder(kept):
    """Yields the folder `kept`, or a temporary one if it is None."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = kept or pathlib.Path(temporary)
        folder.mkdir(exist_ok=True)
        yield folder


def pressure_on(text, side, pressure):
    """Returns rows of *DLOAD for the faces of a *SURFACE. (*DSLOAD has no effect on plane elements in ccx 2.20.)"""
    rows = text.split(f"*SURFACE, NAME={side}, TYPE=ELEMENT\n")[1].split("*")[0]
    return "\n".join(f"{row.replace('S', 'P')}, {pressure}" for row in rows.splitlines())


def read_mesh(text):
    """Returns positions by node and the nodes of each element of an .inp file with one type of elements."""
    def rows(card):
        part = text.split(card)[1].split("\n", 1)[1].split("*")[0]
        return [row.split(",") for row in part.replace(",\n", ", ").splitlines()]

    places = {int(row[0]): tuple(map(float, row[1:])) for row in rows("*NODE")}
    return places, [[int(node) for node in row[1:]] for row in rows("*ELEMENT")]


def read_side(text, side):
    """Returns the nodes of a side of an .inp file."""
    rows = text.split(f"*NSET, NSET={side}\n")[1].split("*")[0]
    return [int(node) for node in re.findall(r"\d+", rows)]


def run(folder, name):
    """Runs CalculiX on name.inp and returns positions, displacements and stresses (xx, yy, zz, xy, yz, zx) by node."""
    subprocess.run(["ccx", name], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return read_results(folder / f"{name}.frd")


def read_results(path):
    """Returns positions, displacements and stresses by node of a .frd file."""
    places, displacements, stresses = {}, {}, {}
    blocks = {"DISP": displacements, "STRESS": stresses}
    found = None
    for line in path.read_text().splitlines():
        if line.startswith("    2C"):
            found = places
        elif line.startswith((" -4", "    3C")):
            found = blocks.get(line[5:].split()[0]) if line.startswith(" -4") else None
        elif line.startswith(" -1") and found is not None:
            found[int(line[3:13])] = [float(line[i:i + 12]) for i in range(13, len(line) - 11, 12)]
    return places, displacements, stresses


def equivalent(stress):
    """Returns the von Mises stress."""
    xx, yy, zz, xy, yz, zx = stress
    return (((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy ** 2 + yz ** 2 + zx ** 2)) ** 0.5


def main():
    mesh = pathlib.Path(sys.argv[1]).read_text()
    places, _, stresses = read_results(pathlib.Path(sys.argv[2]))
    for side in sys.argv[3:]:
        node = max(read_side(mesh, side), key=lambda node: equivalent(stresses[node]))
        x, y, _ = places[node]
        print(f"{side}: {equivalent(stresses[node]):.1f} at ({x:.1f}, {y:.1f})")


if __name__ == "__main__":
    main()
