"""Smooth Quads on meshes of ParaView and of Gmsh: pvpython test_plugin_smooth.py PLUGIN"""
import os
import subprocess
import tempfile

from checks import check, check_equal
from loaded_plugin import *

GEOMETRY = """
Point(1) = {0, 0, 0, 0.3}; Point(2) = {3, 0, 0, 0.3}; Point(3) = {3, 2, 0, 0.3}; Point(4) = {0, 2, 0, 0.3};
Point(5) = {1, 1, 0, 0.15}; Point(6) = {1.5, 1, 0, 0.15}; Point(7) = {0.5, 1, 0, 0.15};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1}; Circle(5) = {6, 5, 7}; Circle(6) = {7, 5, 6};
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5, 6}; Plane Surface(1) = {1, 2}; Physical Surface(1) = {1};
Recombine Surface {1}; Mesh.RecombinationAlgorithm = 2; Mesh.SubdivisionAlgorithm = 1; Mesh.MeshSizeExtendFromBoundary = 1;
"""


def minimum(data, name):
    return data.GetFieldData().GetArray(name).GetComponent(0, 0)


def check_smoothed(source, cells=None, **options):
    data = fetch(SmoothQuads(Input=source, **options))
    check(cells is None or data.GetNumberOfCells() == cells, "the number of cells")
    before, after = (minimum(data, name) for name in ("ScaledJacobianRangeBefore", "ScaledJacobianRange"))
    check(after > before, "the minimum scaled Jacobian: %g after %g" % (after, before))
    check_equal(minimum(data, "Inverted"), 0, "inverted quads")
    return after


def test_mesh_of_paraview():
    plane = Plane(XResolution=20, YResolution=20)
    waves = Calculator(Input=plane, CoordinateResults=1,
                       Function="coords + 0.02 * (sin(40 * coordsX) * cos(37 * coordsY) * iHat + sin(29 * coordsY) * jHat)"
                                " * (0.25 - coordsX * coordsX) * (0.25 - coordsY * coordsY) * 16")
    check(check_smoothed(waves, 400) > 0.95, "the grid is not regular")
    check(check_smoothed(waves, 400, UniformSizes=1) > 0.99, "the grid is not uniform")


def test_mesh_of_gmsh():
    with tempfile.TemporaryDirectory() as folder:
        geometry = os.path.join(folder, "plate.geo")
        file = os.path.join(folder, "plate.vtk")
        with open(geometry, "w", encoding="utf-8") as text:
            text.write(GEOMETRY)
        subprocess.run(["gmsh", "-2", geometry, "-o", file], check=True, stdout=subprocess.DEVNULL)
        mesh = LegacyVTKReader(FileNames=[file])
        check_smoothed(mesh)
        check_smoothed(mesh, SlideOnBoundary=0)


run_tests(test_mesh_of_paraview, test_mesh_of_gmsh)
