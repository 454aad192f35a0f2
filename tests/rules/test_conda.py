"""Compares the recipe of the conda package with the CMake files.

    python3 test_conda.py

- The recipe is YAML after its Jinja expressions are replaced, with the version of the project.
- Every option in its build script is one of CMake or of the project.
- Every package that the build looks for is a requirement, and nothing else is.

conda itself is not needed. Without Jinja2 or PyYAML the test is skipped.
"""
import glob
import os
import re
import sys
import unittest

try:
    import jinja2
    import yaml
except ImportError as error:
    print("%s. To install what is missing: apt-get install python3-jinja2 python3-yaml" % error)
    sys.exit(77)

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
RECIPE = "scripts/conda/meta.yaml"

# Packages of conda-forge for what the CMake files look for: the first argument of find_package, or the variable of the
# other commands. Empty: part of another package, of the compiler, or of the build with ParaView or tests alone.
PACKAGES = {
    "VTK": "vtk", "Python3": "python", "Eigen3": "eigen", "CGAL": "cgal-cpp", "CHOLMOD": "libcholmod",
    "CHOLMOD_INCLUDE_DIR": "libcholmod", "CHOLMOD_LIBRARY": "libcholmod", "BLAS": "openblas", "TBB": "tbb-devel",
    "LEMON_HEADERS": "lemon", "GLPK_HEADERS": "glpk", "GLPK_LIBRARY": "glpk", "EXPAT": "expat",
    "nlohmann_json": "nlohmann_json", "CLI11": "cli11", "LIBDEFLATE_HEADERS": "libdeflate",
    "LIBDEFLATE_LIBRARY": "libdeflate", "OPENCASCADE_HEADERS": "occt", "OPENCASCADE_TKDESTEP": "occt",
    "OPENCASCADE_${library}": "occt", "CGNS_HEADERS": "cgns", "CGNS_LIBRARY": "cgns",
    "OpenMP": "", "CCACHE_PROGRAM": "", "ParaView": "", "Qt${PARAVIEW_QT_MAJOR_VERSION}": "",
}
# Requirements that these packages need for their CMake files, for the choice of BLAS, or to be pinned.
FURTHER = {"gmp", "libxml2-devel", "libopenblas", "libblas"}


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def render(text):
    """Returns the recipe as conda-build reads it on Linux; its selectors are comments for YAML."""
    environment = jinja2.Environment(undefined=jinja2.StrictUndefined)
    return yaml.safe_load(environment.from_string(text).render(
        compiler=lambda language: "compiler-" + language, stdlib=lambda language: "stdlib-" + language))


def cmake_files():
    """Returns the texts of the CMake files of the build without tests."""
    names = ["CMakeLists.txt"]
    for pattern in ("CMakeLists.txt", "*.cmake"):
        for folder in ("cmake", "filters", "pipelines", "paraview-plugin"):
            names += glob.glob(os.path.join(folder, "**", pattern), root_dir=ROOT, recursive=True)
    return {name: re.sub(r"#.*", "", read(name)) for name in names}


def sought(texts):
    """Returns what the CMake files look for, by the files that do."""
    found = {}
    for name, text in texts.items():
        for match in re.finditer(r"\b(?:find_(?:package|path|library|program|file)|pkg_\w+)\s*\(\s*([^\s)]+)", text):
            found.setdefault(match.group(1), name)
    return found


def findings(recipe, texts):
    """Returns the differences between a recipe and the CMake files."""
    found = []
    options = set()
    for text in texts.values():
        options |= set(re.findall(r"\boption\s*\(\s*(\w+)", text))
        options |= set(re.findall(r"\bset\s*\(\s*(\w+)[^()]*\bCACHE\b", text))
    for option in re.findall(r"-D(\w+)", " ".join(recipe["build"]["script"])):
        if option not in options and not re.match(r"CMAKE_|Python3_EXECUTABLE$", option):
            found.append("the option %s does not exist" % option)
    required = {line.split()[0] for line in recipe["requirements"]["host"]}
    needed = set()
    for thing, name in sorted(sought(texts).items()):
        if thing not in PACKAGES:
            found.append("%s looks for %s: name its conda package in tests/rules/test_conda.py" % (name, thing))
        elif PACKAGES[thing]:
            needed.add(PACKAGES[thing])
    found += ["%s is not required" % package for package in sorted(needed - required)]
    found += ["%s is required but not looked for" % package for package in sorted(required - needed - FURTHER)]
    return found


class Conda(unittest.TestCase):
    def test_finds_differences(self):
        recipe = {"build": {"script": ["cmake -DA=1 -DB=2 -DCMAKE_C=3"]}, "requirements": {"host": ["cgns >=4", "x", "gmp"]}}
        texts = {"a": 'option(A "")\nfind_package( VTK 9)', "b": "find_path(CGNS_HEADERS h)\nfind_package(Z)\nfind_package(OpenMP)"}
        self.assertEqual(findings(recipe, texts), [
            "the option B does not exist", "b looks for Z: name its conda package in tests/rules/test_conda.py",
            "vtk is not required", "x is required but not looked for"])

    def test_finds_an_unknown_expression(self):
        with self.assertRaises(jinja2.UndefinedError):
            render("a: {{ compilers('c') }}")

    def test_the_recipe(self):
        recipe = render(read(RECIPE))
        self.assertLessEqual({"package", "source", "build", "requirements", "test", "about"}, set(recipe))
        version = re.search(r"project\(CrossField VERSION (\S+)", read("CMakeLists.txt")).group(1)
        self.assertEqual(recipe["package"], {"name": "crossfield", "version": version})
        source = os.path.join(ROOT, os.path.dirname(RECIPE), recipe["source"]["path"])
        self.assertTrue(os.path.samefile(source, ROOT))
        self.assertTrue(os.path.exists(os.path.join(ROOT, recipe["about"]["license_file"])))
        found = findings(recipe, cmake_files())
        self.assertFalse(found, "\n" + "\n".join(found))


if __name__ == "__main__":
    unittest.main()
