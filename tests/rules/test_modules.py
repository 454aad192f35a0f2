"""Checks the modules of filters/numerics.

    python3 test_modules.py

- docs/architecture.md and the build name the same modules and dependencies.
- Each external library is included in one module only.
- No two units of the numerics include each other, directly or through other units. A unit is a
  header and the source of the same name.
- A function is defined in the unit whose header declares it.
- No two headers have the same name or define classes of the same name: the linker would take the
  functions of one for those of the other.
- Tests are in the folder of the module that they test, and every filter has a test.
"""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NUMERICS = ROOT / "filters" / "numerics"


TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"'
                   r"|'(?:\\.|[^'\\\n])+'|[A-Za-z_]\w*|\.?\d[\w.']*|<<|>>|->|::|\+=|==|[^\s]", re.DOTALL)


def tokens_of(source):
    """Returns the tokens of C++ source without its comments."""
    found = [match.group() for match in TOKEN.finditer(source)]
    return [token for token in found if not token.startswith(("//", "/*"))]


def closing(tokens, opening):
    """Returns the index of the bracket that closes the one at index `opening`."""
    depth = 0
    for i in range(opening, len(tokens)):
        depth += (tokens[i] in ("(", "[", "{")) - (tokens[i] in (")", "]", "}"))
        if depth == 0:
            return i
    return len(tokens)


def modules_of_the_build(text):
    """Returns module -> modules that it may use, from the calls of crossfield_add_module."""
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
    """Returns module -> modules that it may use, from docs/architecture.md: the rows of the table, in their order,
    and the arrows of the drawing."""
    section = text.split("## The modules of the numerics")[1].split("\n## ")[0]
    modules = {name: set() for name in re.findall(r"^\| `(\w+)` \|", section, re.MULTILINE)}
    for name, used in re.findall(r"^  (\w+) --> (.*)$", section, re.MULTILINE):
        modules[name] = set(used.split(" & "))
    return modules


# Patterns of the headers of each library; docs/architecture.md lists the libraries of each module.
LIBRARIES = {"CGAL": r"CGAL/", "CHOLMOD": r"cholmod\.h", "LAPACK": r"(cblas|lapacke?|openblas\w*)\.h|OpenBLAS's functions",
             "OpenMP": r"omp\.h", "TBB": r"tbb/", "LEMON": r"lemon/", "GLPK": r"glpk\.h",
             "Expat": r"expat\.h", "nlohmann-json": r"nlohmann/"}
# Headers that every module may include: of the standard library, of Eigen, of the system to query
# memory, and of the compiler's sanitizers.
EVERYWHERE = r"[a-z_]+$|Eigen/|unistd\.h$|sys/resource\.h$|sanitizer/"


def libraries_of_the_page(text):
    """Returns library -> the only module that uses it."""
    found = {}
    for module, libraries in re.findall(r"^\| `(\w+)` \|.*the only module with ([^|]*?) \|", text, re.MULTILINE):
        for library in re.split(r", | and ", libraries):
            found[library] = module
    return found


def foreign_includes(files, modules):
    """Returns the includes that are not allowed in their module; files: (module, name) -> text."""
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
    """Returns (declared, defined): the functions of a file as namespace::name, without those in
    unnamed namespaces and without the members that a class declares."""
    tokens = tokens_of(re.sub(r"^ *#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.MULTILINE))
    declared, defined = set(), set()
    spaces = []  # the namespaces that are open at token i
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
        # A statement, or a definition with its body.
        end = i
        while end < len(tokens) and tokens[end] not in (";", "{", "}"):
            end = closing(tokens, end) + 1 if tokens[end] in ("(", "[") else end + 1
        statement = tokens[i:end]
        if end < len(tokens) and tokens[end] == "{":
            has_body = True
            i = closing(tokens, end) + 1
        else:
            has_body = False
            i = end + 1 if end < len(tokens) and tokens[end] == ";" else max(end, i + 1)
        if "(" not in statement or {"class", "struct", "enum", "using", "extern"} & set(statement[:2]) or "" in spaces:
            continue
        bracket = statement.index("(")
        if "=" in statement[:bracket] or not re.match(r"[A-Za-z_]", statement[bracket - 1]) or bracket < 2:
            continue
        first = bracket - 1
        while first >= 2 and statement[first - 1] == "::":
            first -= 2
        name = "::".join(spaces + ["".join(statement[first:bracket])])
        (defined if has_body else declared).add(name)
    return declared, defined


def misplaced_functions(files):
    """Returns the functions that one unit defines and the header of another declares; files: name
    -> text."""
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
    """Returns unit -> units whose headers its .h or .cxx includes; files: name -> text."""
    known = {name.rsplit(".", 1)[0] for name in files}
    graph = {name: set() for name in known}
    for name, text in files.items():
        unit = name.rsplit(".", 1)[0]
        for header in re.findall(r'^#include "(\w+)\.h"', text, re.MULTILINE):
            if header in known and header != unit:
                graph[unit].add(header)
    return graph


def cycle(graph):
    """Returns a cycle of units that include each other, or None."""
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


def repeated_names(files):
    """Returns the names of headers, and of the classes that they define, that occur more than once."""
    names = [name for _, name in files]
    for text in files.values():
        names += re.findall(r"^(?:class|struct) (\w+)(?: final)?\s*(?::[^;{]*)?\{", text, re.MULTILINE)
    return sorted({name for name in names if names.count(name) > 1})


class Modules(unittest.TestCase):
    def test_finds_a_cycle(self):
        files = {"A.h": '#include "B.h"', "B.cxx": '#include "C.h"', "C.h": '#include "A.h"', "D.h": ""}
        self.assertEqual(cycle(units(files)), ["A", "B", "C", "A"])
        files["C.h"] = '#include "D.h"'
        self.assertIsNone(cycle(units(files)))

    def test_finds_a_different_dependency(self):
        build = "crossfield_add_module(base)\ncrossfield_add_module(mesh MAY_USE base LIBRARIES X::Y)\n"
        page = "## The modules of the numerics\n  mesh --> base\n| `base` | a |\n| `mesh` | b |\n"
        self.assertEqual(modules_of_the_build(build), modules_of_the_page(page))
        self.assertNotEqual(modules_of_the_build(build), modules_of_the_page(page.replace("  mesh --> base\n", "")))

    def test_finds_a_foreign_include(self):
        page = "| `meshing` | meshes; the only module with CGAL |\n| `algebra` | the only module with LAPACK and OpenMP |"
        modules = libraries_of_the_page(page)
        self.assertEqual(modules, {"CGAL": "meshing", "LAPACK": "algebra", "OpenMP": "algebra"})
        files = {("meshing", "A.h"): "#include <CGAL/a.h>\n#include <vector>", ("algebra", "B.cxx"): 'extern "C"\n{\n}'}
        self.assertEqual(foreign_includes(files, modules), [])
        files = {("mesh", "A.h"): "#include <CGAL/a.h>", ("mesh", "B.h"): "#include <boost/b.hpp>",
                 ("mesh", "C.cxx"): 'extern "C" void dgemm_();', ("meshing", "D.h"): "#include <glpk.h>"}
        self.assertEqual(len(foreign_includes(files, modules)), 4)

    def test_finds_a_misplaced_function(self):
        header = ("#define F(x) \\\n  G(x)\nnamespace n\n{\nclass C { void M(); };\nint F(int a = 1);\nconstexpr int N = F(2);\n"
                  "template <class T>\nT K(T t) { return H(t); }\nstd::vector<int> G(const C& c);\n}\n")
        here = "namespace n\n{\nnamespace\n{\nint G(int) { return 1; }\n}\nint F(int a)\n{\n  return G(a);\n}\nvoid C::M() {}\n}\n"
        there = "std::vector<int> n::G(const C& c)\n{\n  return {};\n}\n"
        self.assertEqual(functions(header)[0], {"n::F", "n::G"})
        self.assertEqual(functions(here)[1], {"n::F", "n::C::M"})
        self.assertEqual(misplaced_functions({"A.h": header, "A.cxx": here + there}), [])
        self.assertEqual(misplaced_functions({"A.h": header, "B.cxx": here, "A.cxx": there}), ["B.cxx defines n::F of A.h"])

    def test_finds_a_name_twice(self):
        one, other = "class Grid\n{\n};\nstruct A;\n", "struct Grid\n  : public B\n{\n};\nstruct A\n{\n};\n"
        self.assertEqual(repeated_names({("a", "One.h"): one, ("b", "Other.h"): other}), ["Grid"])
        self.assertEqual(repeated_names({("a", "Same.h"): one, ("b", "Same.h"): ""}), ["Same.h"])

    def test_names_of_headers_and_classes_are_unique(self):
        files = {(path.parent.name, path.name): path.read_text() for path in NUMERICS.glob("*/*.h")}
        self.assertEqual(repeated_names(files), [])

    def test_each_library_is_used_in_one_module(self):
        modules = libraries_of_the_page((ROOT / "docs" / "architecture.md").read_text())
        self.assertEqual(set(modules), set(LIBRARIES))
        files = {(path.parent.name, path.name): path.read_text()
                 for suffix in ("h", "cxx") for path in NUMERICS.glob(f"*/*.{suffix}")}
        self.assertEqual(foreign_includes(files, modules), [])

    def test_functions_are_defined_in_the_unit_that_declares_them(self):
        for folder in (*NUMERICS.iterdir(), ROOT / "filters" / "vtk", ROOT / "pipelines"):
            if folder.is_dir():
                files = {path.name: path.read_text() for suffix in ("h", "cxx") for path in folder.glob(f"*.{suffix}")
                         if path.name != "CommandLine.h"}  # declares the commands, which are defined in a file each
                self.assertEqual(misplaced_functions(files), [], folder)

    def test_documentation_build_and_folders_agree(self):
        build = modules_of_the_build((NUMERICS / "CMakeLists.txt").read_text())
        page = modules_of_the_page((ROOT / "docs" / "architecture.md").read_text())
        folders = {path.name for path in NUMERICS.iterdir() if path.is_dir() and path.name != "cmake"}
        self.assertEqual(build, page)
        rows = list(page)
        for name, used in page.items():
            self.assertLessEqual(used, set(rows[:rows.index(name)]), "%s uses a later module" % name)
        self.assertEqual(set(build), folders)
        self.assertEqual(list(NUMERICS.glob("*.h")) + list(NUMERICS.glob("*.cxx")), [])

    def test_tests_are_in_the_folder_of_their_module(self):
        modules = modules_of_the_build((NUMERICS / "CMakeLists.txt").read_text())
        module_of = {path.stem: path.parent.name for path in NUMERICS.glob("*/*.h")}
        for test in (ROOT / "tests" / "numerics").glob("*/Test*.cxx"):
            self.assertIn(test.parent.name, modules)
            # The test of one unit is in the folder of its module; other tests cover several units.
            unit = test.stem[len("Test"):]
            self.assertEqual(test.parent.name, module_of.get(unit, test.parent.name), unit)

    def test_every_filter_has_its_tests(self):
        filters = ROOT / "filters" / "vtk"
        listed = re.search(r"set\(classes\s([^)]*)\)", (filters / "CMakeLists.txt").read_text()).group(1).split()
        self.assertEqual(set(listed), {path.stem for path in filters.glob("vtk*.cxx")})
        for name in set(listed) - {"vtkCrossFieldSolver"}:  # abstract
            self.assertTrue((ROOT / "tests" / "vtk" / f"Test{name[len('vtk'):]}.cxx").exists(), name)

    def test_no_two_units_include_each_other(self):
        files = {path.name: path.read_text() for suffix in ("h", "cxx") for path in NUMERICS.glob(f"*/*.{suffix}")}
        self.assertGreater(len(files), 100)
        self.assertIsNone(cycle(units(files)))


if __name__ == "__main__":
    unittest.main()
