"""The rooms of filters/numerics: docs/architecture.md and the build name the same rooms and arrows, and no
two units of the numerics include each other, however many others are between them."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NUMERICS = ROOT / "filters" / "numerics"


def rooms_of_the_build(text):
    """Room -> rooms that it may use, from the calls of crossfield_add_room."""
    rooms = {}
    for words in re.findall(r"^crossfield_add_room\(([^)]*)\)", text, re.MULTILINE):
        name, *rest = words.split()
        rooms[name] = set()
        if "MAY_USE" in rest:
            used = rest[rest.index("MAY_USE") + 1:]
            end = used.index("LIBRARIES") if "LIBRARIES" in used else len(used)
            rooms[name] = set(used[:end])
    return rooms


def rooms_of_the_page(text):
    """The same from the table of the page."""
    section = text.split("## The rooms of the numerics")[1].split("\n## ")[0]
    rooms = {}
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) == 5 and re.fullmatch(r"`\w+`", cells[1]):
            rooms[cells[1].strip("`")] = set(re.findall(r"`(\w+)`", cells[3]))
    return rooms


def units(files):
    """Unit -> units whose headers its .h or .cxx includes; files: name -> text."""
    known = {name.rsplit(".", 1)[0] for name in files}
    graph = {name: set() for name in known}
    for name, text in files.items():
        unit = name.rsplit(".", 1)[0]
        for header in re.findall(r'^#include "(\w+)\.h"', text, re.MULTILINE):
            if header in known and header != unit:
                graph[unit].add(header)
    return graph


def cycle(graph):
    """Units that include each other in a ring, or None."""
    done = set()
    path = []

    def visit(unit):
        if unit in path:
            return path[path.index(unit):] + [unit]
        if unit in done:
            return None
        path.append(unit)
        for other in sorted(graph[unit]):
            found = visit(other)
            if found:
                return found
        path.pop()
        done.add(unit)
        return None

    for unit in sorted(graph):
        found = visit(unit)
        if found:
            return found
    return None


class Rooms(unittest.TestCase):
    def test_a_ring_is_found(self):
        files = {"A.h": '#include "B.h"', "B.cxx": '#include "C.h"', "C.h": '#include "A.h"', "D.h": ""}
        self.assertEqual(cycle(units(files)), ["A", "B", "C", "A"])
        files["C.h"] = '#include "D.h"'
        self.assertIsNone(cycle(units(files)))

    def test_another_arrow_is_found(self):
        build = "crossfield_add_room(base)\ncrossfield_add_room(mesh MAY_USE base LIBRARIES X::Y)\n"
        page = "## The rooms of the numerics\n| `base` | a | |\n| `mesh` | b | `base` |\n"
        self.assertEqual(rooms_of_the_build(build), rooms_of_the_page(page))
        self.assertNotEqual(rooms_of_the_build(build), rooms_of_the_page(page.replace("`base` |\n", "|\n")))

    def test_page_build_and_folders_agree(self):
        build = rooms_of_the_build((NUMERICS / "CMakeLists.txt").read_text())
        page = rooms_of_the_page((ROOT / "docs" / "architecture.md").read_text())
        folders = {path.name for path in NUMERICS.iterdir() if path.is_dir() and path.name != "cmake"}
        self.assertEqual(build, page)
        self.assertEqual(set(build), folders)
        self.assertEqual(list(NUMERICS.glob("*.h")) + list(NUMERICS.glob("*.cxx")), [])

    def test_tests_mirror_the_rooms(self):
        for test in (ROOT / "tests" / "numerics").glob("*/Test*.cxx"):
            self.assertIn(test.parent.name, rooms_of_the_build((NUMERICS / "CMakeLists.txt").read_text()))

    def test_no_two_units_need_each_other(self):
        files = {path.name: path.read_text() for suffix in ("h", "cxx") for path in NUMERICS.glob(f"*/*.{suffix}")}
        self.assertGreater(len(files), 100)
        self.assertIsNone(cycle(units(files)))


if __name__ == "__main__":
    unittest.main()
