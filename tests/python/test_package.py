"""The functions of the Python package: python3 test_package.py PROGRAM HEADER

Their numbers are those of the program, their arrays fit together, errors are exceptions and nothing
is printed, inputs are not touched, the examples of the docstrings hold, and the stubs name what there
is.
"""
import ast
import contextlib
import doctest
import functools
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import warnings

import numpy as np

import crossfield
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendFilter

from checks import check, check_default_field, check_equal, fingerprint

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

PROGRAM, HEADER = sys.argv[1:]
FOUR = np.array([(0.42, 0.42, 1, 0.1), (-0.42, 0.42, 1, 0.1), (-0.42, -0.42, 1, 0.1),
                 (0.42, -0.42, 1, 0.1)])
SQUARE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])
PAIR = np.array([(1.5, 1.0, 1, 0.1), (0.5, 1.0, -1, 0.1)])
TIMES = ("seconds",)


def keeping(function):
    """The function, with what it computes kept for the verifier."""
    @functools.wraps(function)
    def kept_function(*arguments, **options):
        result = function(*arguments, **options)
        kept.keep_data(result.grid)
        return result
    return kept_function


crossfield.drill, crossfield.solve = map(keeping, (crossfield.drill, crossfield.solve))


@contextlib.contextmanager
def silence():
    """What is written to standard output and error meanwhile, by Python or by VTK, is an error."""
    with tempfile.TemporaryFile() as file:
        kept = [os.dup(descriptor) for descriptor in (1, 2)]
        for descriptor in (1, 2):
            os.dup2(file.fileno(), descriptor)
        try:
            yield
        finally:
            for descriptor, old in zip((1, 2), kept):
                os.dup2(old, descriptor)
                os.close(old)
        file.seek(0)
        check_equal(file.read().decode(), "", "what was printed")


def program(*arguments):
    done = subprocess.run([PROGRAM, *arguments, "--json", "-"], cwd=FOLDER, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    check(done.stdout, "no report: " + done.stderr)
    return {key: value for key, value in json.loads(done.stdout).items() if key not in TIMES}


def write_rows(name, rows):
    with open(os.path.join(FOLDER, name), "w", encoding="utf-8") as file:
        file.write("x,y,quarter_index,radius\n")
        file.writelines(",".join(map(repr, map(float, row))) + "\n" for row in rows)


def expect_error(word, function, *arguments, inconsistent=False, **options):
    with silence():
        try:
            function(*arguments, **options)
        except crossfield.Error as error:
            sentence, found = str(error), error.inconsistent
        else:
            sentence = found = None
    check(sentence is not None, "no error that says '%s'" % word)
    check(word in sentence, "'%s' does not say '%s'" % (sentence, word))
    check("\n" not in sentence and sentence.endswith("."), "'%s' is no sentence" % sentence)
    check_equal(found, inconsistent, "inconsistent of '%s'" % sentence)


def check_report(found, expected, what):
    """Equal as JSON, where true is not 1 as it is in Python."""
    check_equal(json.dumps(found, sort_keys=True), json.dumps(expected, sort_keys=True), what)


def test_solve_is_the_program():
    write_rows("four.csv", FOUR)
    for options, arguments in (({}, ()), ({"size": 0.08}, ("--size", "0.08")),
                               ({"method": "unit-norm"}, ("--method", "unit-norm")),
                               ({"method": "constrained", "start": "harmonic"},
                                ("--method", "constrained", "--start", "harmonic")),
                               ({"method": "constrained", "unit_holes": True},
                                ("--method", "constrained", "--unit-holes"))):
        with silence():
            field = crossfield.solve("builtin:disk", FOUR, **options)
        expected = program("solve", "builtin:disk", "-s", "four.csv", *arguments)
        check_equal(len(expected.pop("singularities")), 4, "what the program was given")
        check_report(field.report, expected, "the report with %s" % options)
    check_default_field(crossfield.solve("builtin:disk", FOUR).grid)
    with silence():
        field = crossfield.solve("builtin:disk", method="ginzburg-landau", epsilon=0.1, size=0.1)
        points, quarters = field.singularities()
    found = program("solve", "builtin:disk", "--method", "ginzburg-landau", "--epsilon", "0.1",
                    "--size", "0.1")
    rows = [{"x": x, "y": y, "quarter_index": k} for (x, y, _), k in zip(points, quarters)]
    check_equal(rows, found.pop("singularities"), "the singularities")
    check_report(field.report, found, "the report of Ginzburg-Landau")


def test_arrays():
    field = crossfield.solve(SQUARE, PAIR, method="constrained")
    count, points = len(field.triangles), len(field.points)
    check_equal(field.report["triangles"], count, "the number of triangles")
    for name, shape in (("points", (points, 3)), ("triangles", (count, 3)), ("u", (count, 3)),
                        ("angle", (count,)), ("norm", (count,)), ("cross", (count, 3)),
                        ("point_angle", (points,)), ("point_norm", (points,)),
                        ("point_cross", (points, 3)), ("hole_degrees", (2,))):
        check_equal(getattr(field, name).shape, shape, "the shape of " + name)
    check_equal(field.hole_degrees.tolist(), [1, -1], "the degrees")
    # The field at the centre of a triangle is the mean of its midpoints.
    centre = field.u.mean(axis=1)
    check(abs(field.norm - abs(centre)).max() < 1e-12, "norm is not |u| at the centre")
    turned = np.exp(4j * field.angle) * field.norm
    check(abs(turned - centre).max() < 1e-12, "angle is not arg(u) / 4")
    check(abs(field.cross[:, 0] - np.cos(field.angle)).max() < 1e-6, "cross is not at the angle")
    check(abs(field.point_cross[:, 1] - np.sin(field.point_angle)).max() < 1e-6, "cross at points")
    # Energy of the Crouzeix-Raviart field, from the arrays alone: the gradient of u is that of the
    # linear function with the given values at the midpoints.
    a, b, c = (field.points[field.triangles[:, i], :2] for i in range(3))
    values = [field.u[:, 0] + field.u[:, 2] - field.u[:, 1],
              field.u[:, 0] + field.u[:, 1] - field.u[:, 2],
              field.u[:, 1] + field.u[:, 2] - field.u[:, 0]]
    double = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    check(double.min() > 0, "a triangle is clockwise")
    sides = [c - b, a - c, b - a]
    gradients = [sum(value * side[:, i] for value, side in zip(values, sides)) for i in (0, 1)]
    energy = sum((abs(gradient) ** 2 / double).sum() for gradient in gradients) / 4
    check(abs(energy / field.report["energy"] - 1) < 1e-12, "the energy of the arrays is %g" % energy)
    # The boundary, and the lengths of the loops.
    kinds = set(field.boundary_kind.tolist())
    check_equal(kinds, {1, 3}, "the kinds of edges")
    lengths = np.linalg.norm(np.diff(field.points[field.edges], axis=1)[:, 0], axis=1)
    check(abs(lengths[field.boundary_kind == 1].sum() - 8) < 1e-12, "the length of the outer loop")
    mesh = crossfield.drill(SQUARE, PAIR)
    check((mesh.points == field.points).all() and (mesh.triangles == field.triangles).all(),
          "drill and solve have different meshes")
    holes = mesh.quarter_index[mesh.boundary_kind == 3]
    check_equal(sorted(set(holes.tolist())), [-1, 1], "the quarter indices of holes")
    # What the grid has is a choice; the arrays of numpy follow from the exact field.
    for arrays, names in (("exact", set()), ("display", {"Cross", "CrossNorm"})):
        other = crossfield.solve(SQUARE, PAIR, method="constrained", arrays=arrays)
        data = other.grid.GetCellData()
        found = {data.GetArrayName(i) for i in range(data.GetNumberOfArrays())}
        check_equal(found & {"Cross", "Cross2", "CrossNorm", "Representation"}, names, "arrays of " + arrays)
        check((other.u == field.u).all() and (other.point_norm == field.point_norm).all(),
              arrays + ": the field is another")
        check_equal(other.cross is None, arrays == "exact", arrays + ": no crosses")
    shown = vtk_to_numpy(field.grid.GetPointData().GetArray("CrossNorm"))
    check(abs(field.point_norm - shown).max() < 1e-6, "point_norm is not CrossNorm")
    sizes = crossfield.hfield("builtin:disk", [(0, 0, 4)], arrays="exact").size_map
    check(len(sizes) > 0 and sizes.min() > 0, "there is no size map")
    # The result does not live from the filters, nor they from it.
    field.points[:] = 0
    check(field.grid.GetBounds()[1] == 2, "points is not a copy")


def test_check_and_corners_are_the_program():
    write_rows("pair.csv", PAIR)
    for domain, arguments, rows in (("builtin:square", ("-s", "pair.csv"), PAIR),
                                    ("builtin:star", (), None), ("builtin:angular-hole", (), None)):
        with silence():
            verdict = crossfield.check(domain, rows)
        expected = program("check", domain, *arguments)
        places = [[corner["x"], corner["y"]] for corner in expected["corners"]]
        check_equal(verdict.corner_points[:, :2].tolist(), places, "the corners")
        for name, key in (("corner_angles", "angle"), ("corner_quarters", "quarter_index"),
                          ("cancellable", "cancellable")):
            check_equal(getattr(verdict, name).tolist(),
                        [corner[key] for corner in expected["corners"]], name)
        check_equal(verdict.reason, expected["reason"], "the reason")
        check_report(verdict.report, {key: expected[key] for key in verdict.report}, "the report")
        check_equal(verdict.consistent, rows is not None, "consistent of " + domain)

        with silence():
            found = crossfield.corners(domain)
        expected = program("corners", domain)
        for name in ("scenario", "energy", "interior_quarters", "scenarios"):
            check_equal(getattr(found, name), expected[name], name)
        for name, key in (("angle", "angle"), ("quarter_index", "quarter_index"),
                          ("scarce", "quarter_index_scarce"), ("tied", "tied"),
                          ("balanced", "quarter_index_balanced"), ("excess", "quarter_index_excess"),
                          ("conventional", "quarter_index_conventional"),
                          ("corner_energy", "corner_energy"), ("cancellable", "cancellable")):
            check_equal(getattr(found, name).tolist(),
                        [corner[key] for corner in expected["corners"]], name)
    chosen = crossfield.corners("builtin:l-shape", overrides=[(0, 0, 2)])
    lacking = crossfield.check("builtin:l-shape", corners=chosen)
    check_equal(lacking.report["required_interior_quarters"], -1, "the sum with a chosen corner")
    for corners in (chosen, chosen.data, np.column_stack([chosen.points[:, :2],
                                                          chosen.quarter_index])):
        field = crossfield.solve("builtin:l-shape", [(0.5, 0.5, -1)], corners=corners,
                                 method="unit-norm")
        check_equal(field.hole_degrees.tolist(), [-1], "the degree with a chosen corner")
    check_equal(crossfield.check(field.grid, corners=chosen).consistent, True, "a solved field")


def test_forms_of_input():
    write_rows("pair.csv", PAIR)
    csv = os.path.join(FOLDER, "square.csv")
    np.savetxt(csv, SQUARE, "%r", delimiter=",", header="x,y", comments="")
    loop = vtkPolyData()
    loop.SetPoints(crossfield.solve(SQUARE, PAIR).grid.GetPoints().NewInstance())
    for x, y in SQUARE:
        loop.GetPoints().InsertNextPoint(x, y, 0)
    loop.SetLines(vtkCellArray())
    loop.GetLines().InsertNextCell(5, (0, 1, 2, 3, 0))
    append = vtkAppendFilter()
    append.AddInputData(loop)
    append.Update()
    image = vtkImageData()  # its cells are pixels; the boundary is the same square
    image.SetDimensions(2, 2, 1)
    image.SetSpacing(2, 2, 1)

    class Subclass(vtkPolyData):
        """As those of pyvista."""

    subclass = Subclass()
    subclass.ShallowCopy(loop)
    expected = crossfield.solve(SQUARE, PAIR)
    domains = [SQUARE.tolist(), [SQUARE], np.column_stack([SQUARE, np.zeros(4)]), SQUARE[::-1],
               SQUARE.astype(int), np.array([SQUARE]), loop, append.GetOutput(), image, subclass,
               csv, pathlib.Path(csv)]
    points = crossfield.configuration(PAIR[:, :2], PAIR[:, 2], 0.1)
    rows = [PAIR.tolist(), points, os.path.join(FOLDER, "pair.csv"), [tuple(row) for row in PAIR]]
    with silence():
        for i, domain in enumerate(domains):
            check_equal(crossfield.solve(domain, PAIR).report, expected.report, "domain %d" % i)
        for i, singularities in enumerate(rows):
            check_equal(crossfield.solve(SQUARE, singularities).report, expected.report,
                        "singularities %d" % i)
        for none in (None, [], np.empty((0, 3))):
            check_equal(crossfield.solve(SQUARE, none).hole_degrees.tolist(), [], "no holes")
        bare = crossfield.solve(SQUARE, PAIR[:, :3], size=0.1)
        check_equal(bare.report, crossfield.solve(SQUARE, PAIR, size=0.1).report, "no radius")


def test_files():
    mesh = crossfield.solve(SQUARE, PAIR)
    name = os.path.join(FOLDER, "field.vtu")
    with silence():
        mesh.write(name)
        again = crossfield.read(name)
    check(isinstance(again, vtkUnstructuredGrid), "a .vtu is no vtkUnstructuredGrid")
    check_equal(fingerprint(again), fingerprint(mesh.grid), "the field from its file")
    check_equal(crossfield.check(name).consistent, crossfield.check(mesh.grid).consistent, "a file")
    triangles = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(__file__)), "pipelines"))
    import domain_files
    expected = crossfield.solve(SQUARE, PAIR).report["energy"]
    for ending in ("vtu", "vtk", "stl", "obj", "ply", "vtp"):
        name = os.path.join(FOLDER, "square." + ending)
        if ending == "vtp":
            domain_files.write_loop(name, SQUARE.tolist())
        else:
            getattr(domain_files, "write_" + ending)(
                name, SQUARE.tolist() + [(0.75, 1.25)], triangles)
        with silence():
            energy = crossfield.solve(name, PAIR).report["energy"]
        check(abs(energy / expected - 1) < 1e-6, "the energy of a .%s is %g" % (ending, energy))


def test_gmsh():
    """A stand-in for meshio, so that this is tested where it is not installed."""
    name = os.path.join(FOLDER, "square.msh")
    with open(name, "w", encoding="utf-8") as file:
        file.write("what the stand-in does not read\n")
    real = sys.modules.get("meshio")
    try:
        sys.modules["meshio"] = None  # importing it fails
        command = "import meshio; meshio.write('%s', meshio.read('%s'))" % (name[:-4] + ".vtu", name)
        expect_error(command, crossfield.solve, name)

        block = types.SimpleNamespace
        points = np.vstack([SQUARE, [(1.0, 1.0)]])
        outline = block(type="line", data=np.array([(0, 1), (1, 2), (2, 3), (3, 0)]))
        triangles = block(type="triangle", data=np.array([(0, 1, 4), (1, 2, 4)]))
        quads = block(type="quad", data=np.array([(0, 4, 2, 3)]))
        vertex = block(type="vertex", data=np.array([(0,)]))
        stand_in = types.ModuleType("meshio")
        sys.modules["meshio"] = stand_in
        expected = crossfield.solve(SQUARE, PAIR).report
        for cells in ([vertex, outline], [outline, triangles, quads]):
            stand_in.read = lambda path: block(points=points, cells=cells)
            check_equal(crossfield.solve(name, PAIR).report, expected, "a mesh of Gmsh")
        for cells, word in (([block(type="tetra", data=np.zeros((1, 4)))], "tetra"),
                            ([vertex], "no cells")):
            stand_in.read = lambda path: block(points=points, cells=cells)
            expect_error(word, crossfield.solve, name)

        def refuse(path):
            raise ValueError("not a mesh")
        stand_in.read = refuse
        expect_error("not a mesh", crossfield.solve, name)
    finally:
        del sys.modules["meshio"]
        if real is not None:
            sys.modules["meshio"] = real
    try:
        import meshio
    except ImportError:
        print("meshio is not installed: no real file")
        return
    nodes = "".join("%d %r %r 0\n" % (i + 1, x, y) for i, (x, y) in enumerate(points.tolist()))
    elements = "1 15 2 1 1 1\n2 1 2 1 1 1 2\n3 2 2 1 1 1 2 5\n4 2 2 1 1 2 3 5\n5 3 2 1 1 1 5 3 4\n"
    with open(name, "w", encoding="utf-8") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n%s$EndNodes\n"
                   "$Elements\n5\n%s$EndElements\n" % (nodes, elements))
    check_equal(crossfield.solve(name, PAIR).report, expected, "a real mesh of Gmsh")
    exec(command)  # what the messages say
    check_equal(crossfield.solve(name[:-4] + ".vtu", PAIR).report, expected, "a converted mesh")


def tilt():
    """A rotation that takes z to a direction closer to z than to x and y, the shortest way."""
    normal = np.array([0.3, -0.4, 0.8]) / np.linalg.norm([0.3, -0.4, 0.8])
    axis = np.cross([0, 0, 1], normal)
    skew = np.array([(0, -axis[2], axis[1]), (axis[2], 0, -axis[0]), (-axis[1], axis[0], 0)])
    return np.eye(3) + skew + skew @ skew / (1 + normal[2])


def test_planes():
    # Of norm one: the relaxed minimum of this pair is flat, and rounding moves it along.
    flat = crossfield.solve(SQUARE, PAIR, method="unit-norm")
    loop = np.column_stack([SQUARE, np.zeros(4)])
    places = np.column_stack([PAIR[:, :2], np.zeros(2)])
    upright = {"xy": np.eye(3), "yz": [(0, 0, 1), (1, 0, 0), (0, 1, 0)],
               "xz": [(1, 0, 0), (0, 0, -1), (0, 1, 0)], "tilted": tilt()}
    for name, rotation in upright.items():
        rotation = np.array(rotation, dtype=float)
        singularities = crossfield.configuration(places @ rotation.T, PAIR[:, 2], PAIR[:, 3])
        with silence():
            field = crossfield.solve(loop @ rotation.T, singularities, method="unit-norm")
        change = abs(field.report["energy"] / flat.report["energy"] - 1)
        check(change < 1e-12, "%s: the energy changes by %g" % (name, change))
        # Numbers of points may differ, so each is looked for.
        distance = np.linalg.norm(
            field.points[:, None] - (flat.points @ rotation.T)[None], axis=2)
        nearest = distance.argmin(axis=1)
        check(distance.min(axis=1).max() < 1e-12, name + ": the points are elsewhere")
        check_equal(len(set(nearest.tolist())), len(flat.points), name + ": the number of points")
        u = field.point_norm * np.exp(4j * field.point_angle)
        v = (flat.point_norm * np.exp(4j * flat.point_angle))[nearest]
        check(abs(u - v).max() < 1e-9, name + ": the field is another")
        # A branch is one of four; the fourth power of the complex branch is the same.
        branch = field.point_cross @ rotation
        check(abs(branch[:, 2]).max() < 1e-6, name + ": the crosses leave the plane")
        power = (branch[:, 0] + 1j * branch[:, 1]) ** 4
        check(abs(power - v / abs(v))[abs(v) > 1e-3].max() < 1e-6, name + ": the crosses turn")
    expect_error("off the plane", crossfield.solve, loop @ tilt().T, PAIR)
    bent = loop + [(0, 0, 0), (0, 0, 0), (0, 0, 1), (0, 0, 0)]
    expect_error("not planar", crossfield.solve, bent, PAIR)


def test_errors():
    write_rows("four.csv", FOUR)
    cases = (
        ("outside", (SQUARE, [(5, 5, 1, 0.1)]), {}),
        ("overlap", (SQUARE, [(1, 1, 1, 0.2), (1.1, 1, -1, 0.2)]), {}),
        ("not an integer", (SQUARE, [(1, 1, 0.25)]), {}),
        ("columns", (SQUARE, [(1, 1)]), {}),
        ("columns", ([(0, 0, 0, 0)], PAIR), {}),
        ("columns", ([SQUARE, "words"], PAIR), {}),
        ("no loops", ([], PAIR), {}),
        ("finite", ([(0, 0), (1, 0), (float("nan"), 1)], None), {}),
        ("no method", (SQUARE, PAIR), {"method": "magic"}),
        ("no start", (SQUARE, PAIR), {"start": "zero"}),
        ("no start", (SQUARE, PAIR), {"start": "best", "method": "unit-norm"}),
        ("not positive", (SQUARE, PAIR), {"size": -1}),
        ("its own singularities", (SQUARE, PAIR), {"method": "ginzburg-landau"}),
        ("belongs", (SQUARE, PAIR), {"epsilon": 0.1}),
        ("no built-in domain", ("builtin:banana", PAIR), {}),
        ("no file", ("missing.vtp", PAIR), {}),
        ("no file", (SQUARE, "missing.csv"), {}),
        ("unknown ending", (os.path.abspath(__file__), PAIR), {}),
        ("QuarterIndex", (SQUARE, crossfield.drill(SQUARE).grid), {}),
    )
    for word, arguments, options in cases:
        expect_error(word, crossfield.solve, *arguments, **options)
    expect_error("Poincaré-Hopf", crossfield.solve, SQUARE, [(1, 1, 1)], inconsistent=True)
    expect_error("outside", crossfield.check, SQUARE, [(5, 5, 1)])
    expect_error("outside", crossfield.drill, SQUARE, [(5, 5, 1)])
    expect_error("no cells", crossfield.corners, vtkPolyData())
    expect_error("no cells", crossfield.check, vtkPolyData())
    expect_error("no cells", crossfield.solve, vtkPolyData())
    expect_error("one number", crossfield.configuration, SQUARE, [1, 2])
    words = os.path.join(FOLDER, "words.vtp")
    with open(words, "w", encoding="utf-8") as file:
        file.write("no data\n")
    expect_error("cannot be read", crossfield.solve, words)


def test_input_untouched():
    domain = crossfield.drill(SQUARE).grid
    rows = crossfield.configuration(PAIR[:, :2], PAIR[:, 2], PAIR[:, 3])
    loop, pair = SQUARE.copy(), PAIR.copy()
    before = fingerprint(domain), fingerprint(rows)
    for function in (crossfield.solve, crossfield.check, crossfield.drill):
        function(domain, rows)
        function(loop, pair)
    crossfield.corners(domain)
    check_equal((fingerprint(domain), fingerprint(rows)), before, "the data sets")
    check((loop == SQUARE).all() and (pair == PAIR).all(), "an array was changed")


def test_warning():
    algorithm = crossfield.vtkPerforatedCrossField()
    algorithm.SetInputData(crossfield.drill(SQUARE, PAIR).grid)
    algorithm.SetMethodToConstrained()
    algorithm.SetMaximumIterations(1)
    algorithm.SetTolerance(1e-300)
    with silence(), warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        crossfield._run.Pipeline().update_one(algorithm)
    check_equal({warning.category for warning in caught}, {RuntimeWarning}, "the warnings")
    check(str(caught[-1].message).startswith("The iteration stopped"), str(caught[-1].message))


def test_examples():
    count = 0
    for module in (crossfield, crossfield._functions, crossfield._input):
        printed = io.StringIO()  # doctest asks for its encoding, which that of pvpython has not
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
    """The names that a .pyi file defines or gives on."""
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


with tempfile.TemporaryDirectory() as FOLDER:
    for test in (test_solve_is_the_program, test_arrays, test_check_and_corners_are_the_program,
                 test_forms_of_input, test_files, test_gmsh, test_planes, test_errors,
                 test_input_untouched, test_warning, test_examples, test_names, test_stubs):
        test()
        print(test.__name__, "passed")
