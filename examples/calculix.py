"""Functions that the examples with CalculiX share: their folder, loads for its input, and results from its output."""
import contextlib
import pathlib
import subprocess
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
