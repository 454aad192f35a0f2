"""Docstrings, names and stubs of the Python package: python3 test_package_names.py HEADER

The examples in docstrings run, the names of arrays are those of the header, and the stubs list all public names.
"""
import ast
import contextlib
import doctest
import io
import os
import re
import sys

import crossfield

from checks import check, check_equal

HEADER, = sys.argv[1:]


def test_examples():
    count = 0
    for module in (crossfield, crossfield._functions, crossfield._input):
        printed = io.StringIO()  # doctest reads its encoding, which standard output of pvpython does not have
        with contextlib.redirect_stdout(printed):
            result = doctest.testmod(module, optionflags=doctest.ELLIPSIS)
        check_equal(result.failed, 0, "the failed examples of %s: %s"
                    % (module.__name__, printed.getvalue()))
        count += result.attempted
    check(count > 10, "only %d examples" % count)
    for name in ("solve", "check", "corners", "drill", "configuration"):
        check(">>>" in getattr(crossfield, name).__doc__, "%s has no example" % name)


def test_names():
    with open(HEADER, encoding="utf-8") as file:
        expected = dict(re.findall(r'constexpr const char\* (\w+) = "(\w+)";', file.read()))
    found = {name: value for name, value in vars(crossfield.names).items() if isinstance(value, str)
             and not name.startswith("_")}
    check_equal(found, expected, "the names of arrays")
    check(len(expected) > 30, "the header was not read")


def stub_names(path):
    """Returns the names that a .pyi file defines or exports."""
    found = set()
    with open(path, encoding="utf-8") as file:
        body = ast.parse(file.read()).body
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            found.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            found.add(node.target.id)
        elif isinstance(node, ast.ImportFrom) and node.names[0].name == "*":
            inner = os.path.join(os.path.dirname(path), node.module + ".pyi")
            found |= {name for name in stub_names(inner) if not name.startswith("_")}
        elif isinstance(node, ast.ImportFrom):
            found |= {alias.asname for alias in node.names if alias.asname}
    return found


def test_stubs():
    folder = os.path.dirname(crossfield.__file__)
    check(os.path.exists(os.path.join(folder, "py.typed")), "there is no py.typed")
    module = {name for name in vars(crossfield)
              if not name.startswith("_") and name not in ("vtkmodules", "vtkCrossFieldFilters")}
    check_equal(sorted(stub_names(os.path.join(folder, "__init__.pyi")) - {"__version__"}),
                sorted(module), "the names in the stubs")
    classes = {name for name in module if name.startswith("vtk")}
    check({"vtkDrillHoles", "vtkCrossGlyphs"} < classes, "the stubs lack classes")


for test in (test_examples, test_names, test_stubs):
    test()
    print(test.__name__, "passed")
