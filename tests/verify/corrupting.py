"""Access to a correct file for corrupting it in one place: its arrays and its field on edges, which
are changed in place."""
import functools
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader, vtkXMLPolyDataWriter,
                                 vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter)

import topology
from crouzeix_raviart import energies
from field import Field
from reading import Data


#: Name -> the correct file, the function that corrupts it, and the checks that must fail.
CASES = {}


def of(base, *names):
    """Decorates a case: names the correct file that it corrupts and the checks that must fail. No
    other check may fail."""
    def register(function):
        if function.__name__ in CASES:
            raise ValueError("There are two cases '%s'." % function.__name__)
        CASES[function.__name__] = (base, function, set(names))
        return function
    return register


class Arrays:
    """Views of the arrays of a data object."""

    def __init__(self, grid):
        self.grid = grid
        self.points = vtk_to_numpy(grid.GetPoints().GetData())

    def cell(self, name):
        return vtk_to_numpy(self.grid.GetCellData().GetArray(name))

    def point(self, name):
        return vtk_to_numpy(self.grid.GetPointData().GetArray(name))

    def report(self, name):
        return vtk_to_numpy(self.grid.GetFieldData().GetArray(name))

    def scale(self, factor, names):
        """Changes the unit of length of the arrays with these names."""
        self.points *= factor
        for data in (self.grid.GetPointData(), self.grid.GetCellData(), self.grid.GetFieldData()):
            for name in filter(data.HasArray, names):
                vtk_to_numpy(data.GetArray(name))[:] *= factor


class CorruptedFile(Arrays):
    """Views of the arrays of a file; changes in them are written."""

    def __init__(self, name):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(name))
        reader.Update()
        super().__init__(reader.GetOutput())
        self.data = Data(name)
        # Separatrices and patches of a map.
        self.beside = {}
        for part in ("lines", "faces"):
            path = pathlib.Path(name).with_suffix(".%s.vtp" % part)
            if path.exists():
                poly = vtkXMLPolyDataReader()
                poly.SetFileName(str(path))
                poly.Update()
                self.beside[part] = Arrays(poly.GetOutput())
        self.corners = vtk_to_numpy(self.grid.GetCells().GetConnectivityArray())

    @functools.cached_property
    def mesh(self):
        """The triangles before the change."""
        return topology.Mesh(self.data)

    @functools.cached_property
    def lines(self):
        """Indices of the cells that are lines."""
        return len(self.mesh.triangles) + np.arange(len(self.mesh.lines))

    @functools.cached_property
    def u(self):
        """The field on edges; call `show` after changing it."""
        return Field(self.data, self.mesh).u.copy()

    def remove(self, attributes, name):
        attributes.RemoveArray(name)

    def edges_of(self, kind, first=0):
        """Returns the edges of the first loop of a kind, in order."""
        return self.mesh.counter_clockwise(self.mesh.of_kind(kind)[first])

    def inner_edge(self):
        """Returns an edge that is far from all loops."""
        on_loop = np.zeros(len(self.mesh.points), bool)
        on_loop[self.mesh.lines.ravel()] = True
        near = on_loop[self.mesh.triangles].any(axis=1)
        far = np.setdiff1d(np.arange(len(self.mesh.ends)), self.mesh.edge[near])
        return far[len(far) // 2]

    def inner_vertex(self):
        return self.mesh.ends[self.inner_edge(), 0]

    def show(self, energy=False):
        """Writes u into all arrays derived from it, and the energy into the report."""
        mesh, u = self.mesh, self.u
        inside = u[mesh.edge]
        exact = self.cell("CrossFieldCR")
        count = len(mesh.triangles)
        exact[:count, 0::2], exact[:count, 1::2] = inside.real, inside.imag
        on_line = np.repeat(u[mesh.edge_of_line][:, None], 3, axis=1)
        exact[count:, 0::2], exact[count:, 1::2] = on_line.real, on_line.imag
        at_corner = inside.sum(axis=1)[:, None] - 2.0 * np.roll(inside, -1, axis=1)
        sums, weights = np.zeros(len(mesh.points), complex), np.zeros(len(mesh.points))
        np.add.at(sums, mesh.triangles, mesh.area[:, None] * at_corner)
        np.add.at(weights, mesh.triangles, mesh.area[:, None] * np.ones(3))
        for attributes, values in ((self.cell, np.concatenate([inside.mean(axis=1), u[mesh.edge_of_line]])),
                                   (self.point, sums / np.where(weights > 0, weights, 1.0))):
            attributes("Representation")[:, 0] = values.real
            attributes("Representation")[:, 1] = values.imag
            attributes("CrossNorm")[:] = np.abs(values)
            angle = 0.25 * np.angle(values)
            attributes("Cross")[:] = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
            attributes("Cross2")[:] = np.stack([-np.sin(angle), np.cos(angle), 0 * angle], axis=1)
        if energy:
            self.report("Energy")[0] = energies(mesh, inside).sum()

    def write(self, name):
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputDataObject(self.grid)
        writer.SetDataModeToBinary()
        writer.SetFileName(str(name))
        writer.Write()
        for part, arrays in self.beside.items():
            writer = vtkXMLPolyDataWriter()
            writer.SetInputDataObject(arrays.grid)
            writer.SetDataModeToBinary()
            writer.SetFileName(str(pathlib.Path(name).with_suffix(".%s.vtp" % part)))
            writer.Write()
