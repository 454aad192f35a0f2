"""The functions of the Python package: python3 test_package.py PROGRAM

Their numbers equal those of the program, and their arrays agree with each other, in every plane.
"""
import json
import os
import resource
import subprocess
import sys
import tempfile

import numpy as np

import crossfield

from checks import check, check_default_field, check_equal
from package_checks import PAIR, SQUARE, expect_error, silence, write_rows

PROGRAM, = sys.argv[1:]
FOUR = np.array([(0.42, 0.42, 1, 0.1), (-0.42, 0.42, 1, 0.1), (-0.42, -0.42, 1, 0.1),
                 (0.42, -0.42, 1, 0.1)])
TIMES = ("seconds",)


def program(*arguments):
    done = subprocess.run([PROGRAM, *arguments, "--json", "-"], cwd=FOLDER, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    check(done.stdout, "no report: " + done.stderr)
    return {key: value for key, value in json.loads(done.stdout).items() if key not in TIMES}


def check_report(found, expected, what):
    """Compares as JSON, where true differs from 1, unlike in Python."""
    check_equal(json.dumps(found, sort_keys=True), json.dumps(expected, sort_keys=True), what)


def test_solve_is_the_program():
    write_rows(os.path.join(FOLDER, "four.csv"), FOUR)
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
    # Boundary edges and lengths of the loops.
    kinds = set(field.boundary_kind.tolist())
    check_equal(kinds, {1, 3}, "the kinds of edges")
    lengths = np.linalg.norm(np.diff(field.points[field.edges], axis=1)[:, 0], axis=1)
    check(abs(lengths[field.boundary_kind == 1].sum() - 8) < 1e-12, "the length of the outer loop")
    mesh = crossfield.drill(SQUARE, PAIR)
    check((mesh.points == field.points).all() and (mesh.triangles == field.triangles).all(),
          "drill and solve have different meshes")
    holes = mesh.quarter_index[mesh.boundary_kind == 3]
    check_equal(sorted(set(holes.tolist())), [-1, 1], "the quarter indices of holes")
    # The arrays of the grid are a choice; results without an array are None.
    for arrays, names in (("exact", set()), ("display", {"Cross", "CrossNorm"})):
        other = crossfield.solve(SQUARE, PAIR, method="constrained", arrays=arrays)
        data = other.grid.GetCellData()
        found = {data.GetArrayName(i) for i in range(data.GetNumberOfArrays())}
        check_equal(found & {"Cross", "Cross2", "CrossNorm", "Representation"}, names, "arrays of " + arrays)
        check((other.u == field.u).all() and (other.norm == field.norm).all(), arrays + ": the field is another")
        for array in ("cross", "point_cross", "point_norm"):
            check_equal(getattr(other, array) is None, arrays == "exact", arrays + ": " + array)
        check(other.point_angle is None, arrays + ": angles at points")
    sizes = crossfield.hfield("builtin:disk", [(0, 0, 4)], arrays="exact").size_map
    check(len(sizes) > 0 and sizes.min() > 0, "there is no size map")
    # Results and filters can be destroyed in any order.
    field.points[:] = 0
    check(field.grid.GetBounds()[1] == 2, "points is not a copy")


def test_check_and_corners_are_the_program():
    write_rows(os.path.join(FOLDER, "pair.csv"), PAIR)
    for domain, arguments, rows in (("builtin:square", ("-s", "pair.csv"), PAIR),
                                    ("builtin:star", (), None), ("builtin:angular-hole", (), None)):
        with silence():
            checked = crossfield.check(domain, rows)
        expected = program("check", domain, *arguments)
        places = [[corner["x"], corner["y"]] for corner in expected["corners"]]
        check_equal(checked.corner_points[:, :2].tolist(), places, "the corners")
        for name, key in (("corner_angles", "angle"), ("corner_quarters", "quarter_index"),
                          ("cancellable", "cancellable")):
            check_equal(getattr(checked, name).tolist(),
                        [corner[key] for corner in expected["corners"]], name)
        check_equal(checked.reason, expected["reason"], "the reason")
        check_report(checked.report, {key: expected[key] for key in checked.report}, "the report")
        check_equal(checked.consistent, rows is not None, "consistent of " + domain)

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


def tilt():
    """Returns the shortest rotation from z to a direction that is closer to z than to x and y."""
    normal = np.array([0.3, -0.4, 0.8]) / np.linalg.norm([0.3, -0.4, 0.8])
    axis = np.cross([0, 0, 1], normal)
    skew = np.array([(0, -axis[2], axis[1]), (axis[2], 0, -axis[0]), (-axis[1], axis[0], 0)])
    return np.eye(3) + skew + skew @ skew / (1 + normal[2])


def test_planes():
    # Unit norm, because the relaxed minimum of this pair is flat and rounding moves the result
    # along it.
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
        # The order of points may differ, so each point is searched.
        distance = np.linalg.norm(
            field.points[:, None] - (flat.points @ rotation.T)[None], axis=2)
        nearest = distance.argmin(axis=1)
        check(distance.min(axis=1).max() < 1e-12, name + ": the points are elsewhere")
        check_equal(len(set(nearest.tolist())), len(flat.points), name + ": the number of points")
        u = field.point_norm * np.exp(4j * field.point_angle)
        v = (flat.point_norm * np.exp(4j * flat.point_angle))[nearest]
        check(abs(u - v).max() < 1e-6, name + ": the field is another")
        # A branch is one of four, whose complex fourth powers are equal.
        branch = field.point_cross @ rotation
        check(abs(branch[:, 2]).max() < 1e-6, name + ": the crosses leave the plane")
        power = (branch[:, 0] + 1j * branch[:, 1]) ** 4
        check(abs(power - v / abs(v))[abs(v) > 1e-3].max() < 1e-6, name + ": the crosses turn")
    expect_error("off the plane", crossfield.solve, loop @ tilt().T, PAIR)
    bent = loop + [(0, 0, 0), (0, 0, 0), (0, 0, 1), (0, 0, 0)]
    expect_error("not planar", crossfield.solve, bent, PAIR)


def test_a_file_is_replaced_when_the_new_one_is_complete():
    field = crossfield.solve(SQUARE, PAIR)
    folder = os.path.join(FOLDER, "written")
    os.mkdir(folder)
    name, link = os.path.join(folder, "field.vtu"), os.path.join(folder, "link.vtu")
    with open(name, "w", encoding="utf-8") as file:
        file.write("before")
    os.chmod(name, 0o640)
    os.symlink("field.vtu", link)
    limit = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limit[1]))  # simulates a full disk
    try:
        field.write(link)
    except OSError:
        pass
    else:
        check(False, "more than the limit was written")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limit)
    with open(name, encoding="utf-8") as file:
        check_equal(file.read(), "before", "the file after a failure")
    check_equal(sorted(os.listdir(folder)), ["field.vtu", "link.vtu"], "the folder after a failure")

    field.write(link)
    check(os.path.islink(link), "the link was replaced")
    check_equal(os.stat(name).st_mode & 0o777, 0o640, "the permissions")
    check_equal(crossfield.read(name).GetNumberOfPoints(), len(field.points), "the points of the file")
    field.write(os.devnull)
    check(not os.path.isfile(os.devnull), "the device was replaced")


with tempfile.TemporaryDirectory() as FOLDER:
    for test in (test_solve_is_the_program, test_arrays, test_check_and_corners_are_the_program, test_planes,
                 test_a_file_is_replaced_when_the_new_one_is_complete):
        test()
        print(test.__name__, "passed")
