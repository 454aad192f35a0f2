"""Inputs of the functions of the Python package: python3 test_package_input.py

Every form of a domain and of singularities gives the same field, files are read, inputs are not
changed, and errors and warnings are Python exceptions and warnings of one sentence.
"""
import json
import os
import pathlib
import sys
import tempfile
import warnings

import numpy as np

import crossfield
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendFilter

from checks import check, check_equal, fingerprint
from package_checks import PAIR, SQUARE, expect_error, silence, write_rows


def test_forms_of_input():
    write_rows(os.path.join(FOLDER, "pair.csv"), PAIR)
    csv = os.path.join(FOLDER, "square.csv")
    np.savetxt(csv, SQUARE, "%.17g", delimiter=",", header="x,y", comments="")
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
        """Data set of a subclass, as in pyvista."""

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
    builtin = crossfield.read("builtin:disk")
    check_equal(crossfield.quads(builtin, count=100).report["quads"], crossfield.quads("builtin:disk", count=100).report["quads"],
                "quads of a built-in domain that was read")
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


def test_drawings():
    expected = crossfield.solve(SQUARE, PAIR).report
    corners = ["%g %g" % tuple(place) for place in SQUARE[:, :2]]
    msh = os.path.join(FOLDER, "square.msh")
    with open(msh, "w", encoding="utf-8") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"south\"\n$EndPhysicalNames\n$Nodes\n4\n")
        file.write("".join("%d %s 0\n" % (i + 1, place) for i, place in enumerate(corners)))
        file.write("$EndNodes\n$Elements\n3\n1 1 2 5 1 1 2\n2 2 2 0 1 1 2 3\n3 2 2 0 1 1 3 4\n$EndElements\n")
    geojson = os.path.join(FOLDER, "square.geojson")
    with open(geojson, "w", encoding="utf-8") as file:
        json.dump({"type": "Polygon", "coordinates": [SQUARE[:, :2].tolist()]}, file)
    for name in (msh, geojson):
        check_equal(crossfield.solve(name, PAIR).report, expected, "a drawing")
        check(crossfield.read(name).GetFieldData().GetArray("LargestGap").GetValue(0) == 0.0, "its largest gap")
    sides = crossfield.read(msh).GetCellData().GetAbstractArray("Side")
    check(sorted(sides.GetValue(i) for i in range(4)) == ["", "", "", "south"], "names of a .msh file")

    open_svg = os.path.join(FOLDER, "open.svg")
    with open(open_svg, "w", encoding="utf-8") as file:
        file.write("<svg xmlns='http://www.w3.org/2000/svg'><path fill='none' d='M0 0H1V1H0V0.01'/></svg>")
    expect_error("is open at (0, ", crossfield.read, open_svg)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        check(crossfield.read(open_svg, join_tolerance=0.02).GetNumberOfLines() == 4, "a closed gap")
    check(len(caught) == 1 and "0.01 wide" in str(caught[0].message), "a warning about a gap")
    for text in ("", "$MeshFormat\n9 0 8\n"):
        with open(msh, "w", encoding="utf-8") as file:
            file.write(text)
        expect_error("square.msh", crossfield.read, msh)


def test_errors():
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


with tempfile.TemporaryDirectory() as FOLDER:
    for test in (test_forms_of_input, test_files, test_drawings, test_errors, test_input_untouched, test_warning):
        test()
        print(test.__name__, "passed")
