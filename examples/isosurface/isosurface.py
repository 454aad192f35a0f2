"""Meshes an isosurface of VTK's wavelet with quads.

    PYTHONPATH=... python3 isosurface.py [--quads N] [--folder FOLDER]

`crossfield --paths` prints the folder for PYTHONPATH. Writes quads.vtu, and quads.inp with shells for CalculiX.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataConnectivityFilter, vtkWindowedSincPolyDataFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

import crossfield

# Below about 190 the surface reaches the faces of the box, where it ends in thin wedges. From 190 to 240 its largest part is closed and
# has no handle, so that its quarter indices add up to 8. At 200 bumps are wider than quads.
LEVEL = 200


def isosurface():
    """Returns the largest part of the level as a vtkPolyData."""
    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    # A third of the default frequencies. With these the surface has creases that are narrower than quads.
    wavelet.SetXFreq(20)
    wavelet.SetYFreq(10)
    wavelet.SetZFreq(13)
    contour = vtkContourFilter()
    contour.SetInputConnection(wavelet.GetOutputPort())
    contour.SetValue(0, LEVEL)
    contour.ComputeNormalsOff()
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(contour.GetOutputPort())
    largest.SetExtractionModeToLargestRegion()
    # Many triangles of a contour are slivers, and the surface is bent along the grid. Smoothing removes both and keeps the volume.
    smooth = vtkWindowedSincPolyDataFilter()
    smooth.SetInputConnection(largest.GetOutputPort())
    smooth.SetNumberOfIterations(30)
    smooth.SetPassBand(0.02)
    smooth.NormalizeCoordinatesOn()
    smooth.Update()
    return smooth.GetOutput()


def from_arrays(points, triangles):
    """Returns the surface of arrays of points (n, 3) and triangles (m, 3)."""
    places, faces, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    places.SetData(numpy_to_vtk(np.asarray(points, dtype=float), deep=True))
    rows = np.column_stack([np.full(len(triangles), 3), triangles]).astype(np.int64)
    faces.SetCells(len(triangles), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    surface.SetPoints(places)
    surface.SetPolys(faces)
    return surface


def print_report(title, mesh):
    report = mesh.report
    print("%s: %d quads in %d blocks, irregular nodes %s, scaled Jacobian: minimum %.3f, mean %.4f, largest distance %.3f" % (
        title, report["quads"], report["blocks"], report["irregular"], report["scaled_jacobian"]["min"],
        report["scaled_jacobian"]["mean"], report["surface_distance"]["max"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--quads", type=int, default=3000)
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path())
    arguments = parser.parse_args()

    surface = isosurface()
    mesh = crossfield.quads(surface, count=arguments.quads)
    print_report("filter", mesh)
    mesh.write(arguments.folder / "quads.vtu")
    mesh.write(arguments.folder / "quads.inp")

    # The same surface as arrays, such as those of a marching cubes function of another package.
    points = vtk_to_numpy(surface.GetPoints().GetData())
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    mesh = crossfield.quads(from_arrays(points, triangles), count=arguments.quads // 2)
    print_report("arrays", mesh)
    print("points %s, quads %s" % (mesh.points.shape, mesh.quads.shape))

    try:
        import pyvista
    except ImportError:
        return
    # A data set of PyVista is one of VTK, and `pyvista.wrap` makes one of the result.
    mesh = crossfield.quads(pyvista.wrap(surface), count=arguments.quads // 2)
    print_report("PyVista", mesh)
    print("area %.1f" % pyvista.wrap(mesh.grid).extract_surface().area)


if __name__ == "__main__":
    main()
