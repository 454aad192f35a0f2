"""Checks of the Python tests, which `python -O` keeps, and the arrays that the documentation
promises."""
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_LINE, VTK_TRIANGLE

# Energy ½∫|∇u|² of the default chain, from an independent prototype.
DISK_ENERGY = 30.3  # unit norm

# Number of components of the arrays of the drilled mesh and of the field.
MESH_CELL_ARRAYS = {"BoundaryKind": 1, "BoundaryId": 1, "QuarterIndex": 1}
FIELD_POINT_ARRAYS = {"Representation": 3, "Cross": 3, "Cross2": 3, "CrossNorm": 1}
FIELD_CELL_ARRAYS = {"CrossFieldCR": 6, **FIELD_POINT_ARRAYS, **MESH_CELL_ARRAYS}
FIELD_DATA = {
    "Energy": 1, "Iterations": 1, "Residual": 1, "Converged": 1, "HoleDegree": 1,
    "HoleNormRange": 2, "UnwantedSingularities": 1, "EulerCharacteristic": 1, "Valence": 1,
    "TangentTurning": 1, "RequiredInteriorQuarters": 1, "GivenInteriorQuarters": 1,
    "Consistent": 1}


def check(condition, sentence):
    if not condition:
        raise AssertionError(sentence)


def check_equal(found, expected, what):
    check(found == expected, "%s is %s instead of %s" % (what, found, expected))


def value(data, name):
    """Returns the value of a field data array with one value."""
    array = data.GetFieldData().GetArray(name)
    check(array is not None, "there is no field data '%s'" % name)
    return array.GetTuple1(0)


def values(data, name):
    """Returns all values of a field data array."""
    return list(vtk_to_numpy(data.GetFieldData().GetArray(name)))


def check_arrays(attributes, expected, tuples, what):
    for name, components in expected.items():
        array = attributes.GetArray(name)
        check(array is not None, "%s has no array '%s'" % (what, name))
        check_equal(array.GetNumberOfComponents(), components, "%s, components of %s" % (what, name))
        if tuples is not None:
            check_equal(array.GetNumberOfTuples(), tuples, "%s, tuples of %s" % (what, name))


def check_default_field(field, disk_energy=DISK_ENERGY):
    """Checks arrays and numbers of the field of the default chain."""
    check_arrays(field.GetPointData(), FIELD_POINT_ARRAYS, field.GetNumberOfPoints(), "points")
    check_arrays(field.GetCellData(), FIELD_CELL_ARRAYS, field.GetNumberOfCells(), "cells")
    check_arrays(field.GetFieldData(), FIELD_DATA, None, "field data")
    types = {field.GetCellType(cell) for cell in range(field.GetNumberOfCells())}
    check_equal(types, {VTK_LINE, VTK_TRIANGLE}, "the set of cell types")

    check_equal(value(field, "Converged"), 1, "Converged")
    energy = value(field, "Energy")
    check(abs(energy - disk_energy) < 0.02 * disk_energy, "the energy is %g" % energy)
    check_equal(values(field, "HoleDegree"), [1, 1, 1, 1], "HoleDegree")
    check_equal(value(field, "UnwantedSingularities"), 0, "UnwantedSingularities")
    check_equal(value(field, "EulerCharacteristic"), 1, "EulerCharacteristic")
    check_equal(value(field, "RequiredInteriorQuarters"), 4, "RequiredInteriorQuarters")
    check_equal(value(field, "GivenInteriorQuarters"), 4, "GivenInteriorQuarters")
    check_equal(value(field, "Consistent"), 1, "Consistent")

    cross = vtk_to_numpy(field.GetCellData().GetArray("Cross"))
    cross2 = vtk_to_numpy(field.GetCellData().GetArray("Cross2"))
    # Arrays that follow from the exact field are in single precision.
    check(abs((cross**2).sum(axis=1) - 1).max() < 1e-6, "Cross is not of length 1")
    check(abs((cross * cross2).sum(axis=1)).max() < 1e-6, "Cross2 is not orthogonal to Cross")


def fingerprint(data):
    """Returns everything that a filter could change in its input, for comparison."""
    def arrays(attributes):
        found = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
        return [(array.GetName(), array.GetNumberOfComponents(), vtk_to_numpy(array).tobytes())
                for array in found]

    cells = [tuple(data.GetCell(i).GetPointId(j) for j in range(data.GetCell(i).GetNumberOfPoints()))
             for i in range(data.GetNumberOfCells())]
    return (vtk_to_numpy(data.GetPoints().GetData()).tobytes(), cells, data.GetBounds(),
            arrays(data.GetPointData()), arrays(data.GetCellData()), arrays(data.GetFieldData()))
