"""Checks that the program treats each file of tests/data as the README.md there states."""

import pathlib
import re
import shutil
import unittest

from corpus import COMMANDS, DRILLS, CorpusTest

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
#: All formats of meshes give the same domains; for most files these commands suffice.
BRIEF = ("check", "drill", "unit-norm")
PAIR = [(0.25, 0.25, 1, 0.05), (0.75, 0.75, -1, 0.05)]
ROW = re.compile(r"^\| `([^`]+)` \| [^|]+ \| (solved|refused|inconsistent)(?:: ([^|]+))? \|$", re.M)


def table():
    """Returns the expected status and words for every file."""
    rows = ROW.findall((DATA / "README.md").read_text())
    return {name: (ending, [word.strip() for word in words.split("…") if word.strip()])
            for name, ending, words in rows}


class Files(CorpusTest):
    def test_every_file_is_in_the_table(self):
        files = {path.name for path in DATA.iterdir() if path.is_file() and path.name != "README.md"}
        self.assertEqual(files, set(table()))

    def go_through(self, *endings):
        rows = {name: row for name, row in table().items()
                if name.endswith(endings) and not name.startswith("rows_")}
        self.assertGreater(len(rows), 2)
        brief = BRIEF if endings[0] in (".vtk", ".stl", ".obj", ".ply") else tuple(COMMANDS)
        for name, (ending, words) in rows.items():
            shutil.copy(DATA / name, self.folder)
            if ending == "solved":
                self.solves(name, PAIR, brief)
            elif ending == "inconsistent":
                # Neither `corners` nor `drill` needs a sum; `energy` reports it in its table.
                commands = [command for command in COMMANDS
                            if command not in ("corners", "drill", "energy")]
                self.refuses(name, PAIR, words, commands, status=1)
            else:
                self.refuses(name, PAIR, words, brief)

    def test_vtp(self):
        self.go_through(".vtp")

    def test_vtu(self):
        self.go_through(".vtu")

    def test_vtk(self):
        self.go_through(".vtk")

    def test_stl(self):
        self.go_through(".stl")

    def test_obj(self):
        self.go_through(".obj")

    def test_ply(self):
        self.go_through(".ply")

    def test_csv(self):
        self.go_through(".csv")

    def test_crashers(self):
        for path in sorted((DATA / "crashers").glob("*.ply")):
            shutil.copy(path, self.folder)
            self.refuses(path.name, commands=("check", "unit-norm"))

    def test_configurations(self):
        rows = {name: row for name, row in table().items() if name.startswith("rows_")}
        self.assertGreater(len(rows), 5)
        shutil.copy(DATA / "square.vtp", self.folder)
        for name, (ending, words) in rows.items():
            shutil.copy(DATA / name, self.folder)
            if ending == "solved":
                self.solves("square.vtp", name)
            else:
                self.refuses("square.vtp", name, words, DRILLS)


if __name__ == "__main__":
    unittest.main()
