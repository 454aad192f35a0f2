"""The modules of filters/numerics: docs/architecture.md and the build name the same modules and arrows, libraries of
others are included in their modules alone, and no two units of the numerics include each other, however many
others are between them. Everywhere a function is defined in the unit whose header declares it."""

import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import messages  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
NUMERICS = ROOT / "filters" / "numerics"


def modules_of_the_build(text):
    """Module -> modules that it may use, from the calls of crossfield_add_module."""
    modules = {}
    for words in re.findall(r"^crossfield_add_module\(([^)]*)\)", text, re.MULTILINE):
        name, *rest = words.split()
        modules[name] = set()
        if "MAY_USE" in rest:
            used = rest[rest.index("MAY_USE") + 1:]
            end = used.index("LIBRARIES") if "LIBRARIES" in used else len(used)
            modules[name] = set(used[:end])
    return modules


def modules_of_the_page(text):
    """The same from the table of the page."""
    section = text.split("## The modules of the numerics")[1].split("\n## ")[0]
    modules = {}
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) == 5 and re.fullmatch(r"`\w+`", cells[1]):
            modules[cells[1].strip("`")] = set(re.findall(r"`(\w+)`", cells[3]))
    return modules


# What headers of a library are called; a module has the libraries that the page says it has.
LIBRARIES = {"CGAL": r"CGAL/", "CHOLMOD": r"cholmod\.h", "LAPACK": r"(cblas|lapacke?|openblas\w*)\.h|OpenBLAS's functions",
             "OpenMP": r"omp\.h", "LEMON": r"lemon/", "GLPK": r"glpk\.h"}
# Headers that every module may include: of the language, of Eigen, and of the system for what it says of memory.
EVERYWHERE = r"[a-z_]+$|Eigen/|unistd\.h$|sys/resource\.h$"


def libraries_of_the_page(text):
    """Library -> the module that is said to be the only one with it."""
    found = {}
    for module, said in re.findall(r"^\| `(\w+)` \|.*the only module with ([^|]*?) \|", text, re.MULTILINE):
        for library in re.split(r", | and ", said):
            found[library] = module
    return found


def foreign_includes(files, modules):
    """What no module, or another, may include; files: (module, name) -> text."""
    found = []
    for (module, name), text in files.items():
        included = re.findall(r"^ *# *include *<([^>]+)>", text, re.MULTILINE)
        if re.search(r'^extern "C"', text, re.MULTILINE):
            included.append("OpenBLAS's functions")  # their headers cannot be included next to another cblas.h
        for header in included:
            owners = [modules.get(library) for library, like in LIBRARIES.items() if re.match(like, header)]
            if module not in owners and not (re.match(EVERYWHERE, header) and not owners):
                found.append("%s/%s includes %s" % (module, name, header))
    return found


def functions(text):
    """(declared, defined): functions of a file as namespace::name, without those of namespaces that have no name and
    of classes."""
    tokens = messages.tokens_of(re.sub(r"^ *#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.MULTILINE))
    declared, defined = set(), set()
    spaces = []  # of the namespaces that are open here
    i = 0
    while i < len(tokens):
        if tokens[i] == "namespace":
            opening = next(j for j in range(i, len(tokens)) if tokens[j] in ("{", ";", "="))
            if tokens[opening] == "{":
                spaces.append("".join(tokens[i + 1:opening]))
                i = opening + 1
                continue
        if tokens[i] == "}":
            spaces.pop()
            i += 1
            continue
        # A statement, or a definition with what is in its braces.
        end = i
        while end < len(tokens) and tokens[end] not in (";", "{", "}"):
            end = messages.closing(tokens, end) + 1 if tokens[end] in ("(", "[") else end + 1
        statement = tokens[i:end]
        if end < len(tokens) and tokens[end] == "{":
            has_body = True
            i = messages.closing(tokens, end) + 1
        else:
            has_body = False
            i = end + 1 if end < len(tokens) and tokens[end] == ";" else max(end, i + 1)
        if "(" not in statement or {"class", "struct", "enum", "using", "extern"} & set(statement[:2]) or "" in spaces:
            continue
        bracket = statement.index("(")
        if "=" in statement[:bracket] or not messages.is_name(statement[bracket - 1]) or bracket < 2:
            continue
        first = bracket - 1
        while first >= 2 and statement[first - 1] == "::":
            first -= 2
        name = "::".join(spaces + ["".join(statement[first:bracket])])
        (defined if has_body else declared).add(name)
    return declared, defined


def strays(files):
    """Functions that one header declares and another unit defines; files: name -> text."""
    owner = {}
    for name, text in files.items():
        if name.endswith(".h"):
            for function in functions(text)[0]:
                owner.setdefault(function, set()).add(name)
    found = []
    for name, text in files.items():
        for function in functions(text)[1] if name.endswith(".cxx") else ():
            units_of = {header.rsplit(".", 1)[0] for header in owner.get(function, ())}
            if units_of and name.rsplit(".", 1)[0] not in units_of:
                found.append("%s defines %s of %s" % (name, function, ", ".join(sorted(owner[function]))))
    return sorted(found)


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


class Modules(unittest.TestCase):
    def test_a_ring_is_found(self):
        files = {"A.h": '#include "B.h"', "B.cxx": '#include "C.h"', "C.h": '#include "A.h"', "D.h": ""}
        self.assertEqual(cycle(units(files)), ["A", "B", "C", "A"])
        files["C.h"] = '#include "D.h"'
        self.assertIsNone(cycle(units(files)))

    def test_another_arrow_is_found(self):
        build = "crossfield_add_module(base)\ncrossfield_add_module(mesh MAY_USE base LIBRARIES X::Y)\n"
        page = "## The modules of the numerics\n| `base` | a | |\n| `mesh` | b | `base` |\n"
        self.assertEqual(modules_of_the_build(build), modules_of_the_page(page))
        self.assertNotEqual(modules_of_the_build(build), modules_of_the_page(page.replace("`base` |\n", "|\n")))

    def test_a_stranger_is_found(self):
        page = "| `meshing` | meshes; the only module with CGAL | `mesh` |\n| `algebra` | the only module with LAPACK and OpenMP | |"
        modules = libraries_of_the_page(page)
        self.assertEqual(modules, {"CGAL": "meshing", "LAPACK": "algebra", "OpenMP": "algebra"})
        files = {("meshing", "A.h"): "#include <CGAL/a.h>\n#include <vector>", ("algebra", "B.cxx"): 'extern "C"\n{\n}'}
        self.assertEqual(foreign_includes(files, modules), [])
        files = {("mesh", "A.h"): "#include <CGAL/a.h>", ("mesh", "B.h"): "#include <boost/b.hpp>",
                 ("mesh", "C.cxx"): 'extern "C" void dgemm_();', ("meshing", "D.h"): "#include <glpk.h>"}
        self.assertEqual(len(foreign_includes(files, modules)), 4)

    def test_a_function_in_another_unit_is_found(self):
        header = ("#define F(x) \\\n  G(x)\nnamespace n\n{\nclass C { void M(); };\nint F(int a = 1);\nconstexpr int N = F(2);\n"
                  "template <class T>\nT K(T t) { return H(t); }\nstd::vector<int> G(const C& c);\n}\n")
        here = "namespace n\n{\nnamespace\n{\nint G(int) { return 1; }\n}\nint F(int a)\n{\n  return G(a);\n}\nvoid C::M() {}\n}\n"
        there = "std::vector<int> n::G(const C& c)\n{\n  return {};\n}\n"
        self.assertEqual(functions(header)[0], {"n::F", "n::G"})
        self.assertEqual(functions(here)[1], {"n::F", "n::C::M"})
        self.assertEqual(strays({"A.h": header, "A.cxx": here + there}), [])
        self.assertEqual(strays({"A.h": header, "B.cxx": here, "A.cxx": there}), ["B.cxx defines n::F of A.h"])

    def test_libraries_of_others_stay_in_their_rooms(self):
        modules = libraries_of_the_page((ROOT / "docs" / "architecture.md").read_text())
        self.assertEqual(set(modules), set(LIBRARIES))
        files = {(path.parent.name, path.name): path.read_text()
                 for suffix in ("h", "cxx") for path in NUMERICS.glob(f"*/*.{suffix}")}
        self.assertEqual(foreign_includes(files, modules), [])

    def test_functions_live_where_they_are_declared(self):
        for folder in (*NUMERICS.iterdir(), ROOT / "filters" / "vtk", ROOT / "pipelines"):
            if folder.is_dir():
                files = {path.name: path.read_text() for suffix in ("h", "cxx") for path in folder.glob(f"*.{suffix}")
                         if path.name != "CommandLine.h"}  # the list of the commands
                self.assertEqual(strays(files), [], folder)

    def test_page_build_and_folders_agree(self):
        build = modules_of_the_build((NUMERICS / "CMakeLists.txt").read_text())
        page = modules_of_the_page((ROOT / "docs" / "architecture.md").read_text())
        folders = {path.name for path in NUMERICS.iterdir() if path.is_dir() and path.name != "cmake"}
        self.assertEqual(build, page)
        self.assertEqual(set(build), folders)
        self.assertEqual(list(NUMERICS.glob("*.h")) + list(NUMERICS.glob("*.cxx")), [])

    def test_tests_mirror_the_rooms(self):
        modules = modules_of_the_build((NUMERICS / "CMakeLists.txt").read_text())
        room_of = {path.stem: path.parent.name for path in NUMERICS.glob("*/*.h")}
        for test in (ROOT / "tests" / "numerics").glob("*/Test*.cxx"):
            self.assertIn(test.parent.name, modules)
            # That of a unit is where the unit is; others test what several do together.
            unit = test.stem[len("Test"):]
            self.assertEqual(test.parent.name, room_of.get(unit, test.parent.name), unit)

    def test_every_filter_has_its_tests(self):
        filters = ROOT / "filters" / "vtk"
        listed = re.search(r"set\(classes\s([^)]*)\)", (filters / "CMakeLists.txt").read_text()).group(1).split()
        self.assertEqual(set(listed), {path.stem for path in filters.glob("vtk*.cxx")})
        for name in set(listed) - {"vtkCrossFieldSolver"}:  # abstract
            self.assertTrue((ROOT / "tests" / "vtk" / f"Test{name[len('vtk'):]}.cxx").exists(), name)

    def test_no_two_units_need_each_other(self):
        files = {path.name: path.read_text() for suffix in ("h", "cxx") for path in NUMERICS.glob(f"*/*.{suffix}")}
        self.assertGreater(len(files), 100)
        self.assertIsNone(cycle(units(files)))


if __name__ == "__main__":
    unittest.main()
