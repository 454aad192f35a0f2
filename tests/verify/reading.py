"""Reads a .vtu into numpy arrays. VTK is used for this only."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_LINE, VTK_QUAD, VTK_TRIANGLE, VTK_WEDGE
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from report import Unverifiable


def arrays_of(attributes):
    """Returns name -> array; strings and arrays without a name are left out."""
    found = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        if array is not None and array.GetName():
            found[array.GetName()] = vtk_to_numpy(array).copy()
    return found


class Data:
    """Points in space, triangles, lines and quads, and the arrays on all of them.

    `cells` has for each name a pair of arrays, for the rows of `triangles` and of `lines`;
    `quad_cells` has one array for the rows of `quads`, `solid_cells` one for the hexahedra and prisms in `solids`.
    """

    def __init__(self, name):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(name))
        reader.Update()
        grid = reader.GetOutput()
        if reader.GetErrorCode() != 0 or grid is None:
            raise Unverifiable("VTK cannot read the file")
        self.points = np.zeros((0, 3))
        if grid.GetNumberOfPoints() > 0:
            self.points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        self.triangles = np.zeros((0, 3), int)
        self.lines = np.zeros((0, 2), int)
        self.quads = np.zeros((0, 4), int)
        self.only_triangles_and_lines = True
        self.only_known_cells = True
        self.solids = []
        self.only_known_solids = True
        chosen = [np.zeros(0, int)] * 3
        if grid.GetNumberOfCells() > 0:
            types = vtk_to_numpy(grid.GetCellTypesArray())
            ends = vtk_to_numpy(grid.GetCells().GetOffsetsArray()).astype(int)
            ids = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).astype(int)
            chosen = [np.flatnonzero(types == kind) for kind in (VTK_TRIANGLE, VTK_LINE, VTK_QUAD)]
            self.only_triangles_and_lines = len(chosen[0]) + len(chosen[1]) == len(types)
            self.only_known_cells = sum(map(len, chosen)) == len(types)
            self.triangles = ids[ends[chosen[0]][:, None] + np.arange(3)]
            self.lines = ids[ends[chosen[1]][:, None] + np.arange(2)]
            self.quads = ids[ends[chosen[2]][:, None] + np.arange(4)]
            solid = np.flatnonzero((types == VTK_HEXAHEDRON) | (types == VTK_WEDGE))
            self.solids = [ids[ends[i]:ends[i + 1]] for i in solid]
            self.only_known_solids = len(solid) + len(chosen[0]) + len(chosen[2]) == len(types)
            self.solid_cells = {name: array[solid] for name, array in arrays_of(grid.GetCellData()).items()}
        on_cells = arrays_of(grid.GetCellData())
        self.cells = {name: (array[chosen[0]], array[chosen[1]]) for name, array in on_cells.items()}
        self.quad_cells = {name: array[chosen[2]] for name, array in on_cells.items()}
        self.at_points = arrays_of(grid.GetPointData())
        self.field = arrays_of(grid.GetFieldData())

    def value(self, name):
        """Returns the single value of a field data array, or None if there is none."""
        array = self.field.get(name)
        return None if array is None or array.size != 1 else array.ravel()[0].item()
