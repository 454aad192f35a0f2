"""Converts domains and configurations of users to the data sets that the filters read."""
from __future__ import annotations

import os
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkDataSet, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from . import names
from ._arguments import checks_arguments
from ._run import ArgumentError, Error, Pipeline
from .vtkCrossFieldFilters import (
    vtkDrawingReader, vtkPlanarDomainReader, vtkPlanarDomainSource, vtkSingularitySource)

Path = Union[str, "os.PathLike[str]"]
#: One loop, several loops, a data set, a file, or "builtin:NAME".
Domain = Union[ArrayLike, Sequence[ArrayLike], vtkDataSet, Path]
#: Rows of x, y, quarter index and optionally radius, a data set, or a file; None: no singularities.
Singularities = Union[ArrayLike, vtkDataSet, Path, None]
#: Names of lines inside of a domain, or their points by names.
Lines = Union[str, Sequence[str], Mapping[str, ArrayLike]]

_READERS = {".vtp": vtkXMLPolyDataReader, ".vtu": vtkXMLUnstructuredGridReader,
            ".vtk": vtkGenericDataObjectReader, ".stl": vtkSTLReader, ".obj": vtkOBJReader,
            ".ply": vtkPLYReader}
_BUILTIN = "builtin:"


def _numbers(values: Any, widths: Sequence[int], what: str) -> np.ndarray:
    """Returns rows of numbers with one of the widths; there may be no rows."""
    try:
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        array = np.empty(0)
        values = None
    if values is not None and array.size == 0:
        return np.empty((0, widths[0]))
    if array.ndim != 2 or array.shape[1] not in widths:
        sentence = "The %s must be an array of numbers with %s columns; its shape is %s." % (
            what, " or ".join(map(str, widths)),
            array.shape if values is not None else "not that of an array")
        raise Error(sentence) if values is not None else ArgumentError(sentence)
    return array


def positions(values: Any, what: str) -> np.ndarray:
    """Returns positions (n, 3); z is 0 if it is not given."""
    rows = _numbers(values, (2, 3), what)
    padded = np.zeros((len(rows), 3))
    padded[:, :rows.shape[1]] = rows
    return padded


def _points(places: np.ndarray) -> vtkPoints:
    """Returns points in double precision; z is 0 if it is not given."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(positions(places, "points"), deep=True))
    return points


def _cells(cells: Sequence[np.ndarray]) -> vtkCellArray:
    """Returns cells, each with any number of points."""
    offsets = np.concatenate([[0], np.cumsum([len(cell) for cell in cells])]).astype(np.int64)
    ids = np.concatenate([np.asarray(cell, dtype=np.int64) for cell in cells])
    result = vtkCellArray()
    result.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                   numpy_to_vtkIdTypeArray(ids, deep=True))
    return result


def _loops(loops: Any) -> vtkPolyData:
    """Returns loops as closed polylines."""
    if len(loops) == 0:
        raise Error("The domain has no loops; give at least one array of points.")
    if np.ndim(loops[0]) == 1:
        loops = [loops]
    arrays = [_numbers(loop, (2, 3), "loop %d of the domain" % (i + 1)) for i, loop in enumerate(loops)]
    padded = [np.pad(array, ((0, 0), (0, 3 - array.shape[1]))) for array in arrays]
    first, lines = 0, []
    for array in padded:
        if len(array) > 0:
            lines.append(np.append(np.arange(first, first + len(array)), first))
        first += len(array)
    if not lines:
        raise Error("The loops of the domain have no points; give at least three.")
    result = vtkPolyData()
    result.SetPoints(_points(np.concatenate(padded)))
    result.SetLines(_cells(lines))
    return result


@checks_arguments
def read(path: Path, join_tolerance: Optional[float] = None, layers: Sequence[str] = (),
         closed_curves_are_regions: bool = False, all_faces: bool = False,
         lines: Sequence[str] = ()) -> Union[vtkPolyData, vtkUnstructuredGrid]:
    """Reads a domain from a file: .vtp .vtu .vtk .stl .obj .ply, .csv with the points of loops, an
    aerofoil .dat, or a drawing: .dxf .svg .geojson .msh .poly .off .step .brep, whose open ends are joined within
    `join_tolerance`, by default 1e-5 of its diagonal. Of a drawing, the curves of `layers` are used, by default all. With `closed_curves_are_regions` each closed curve of it bounds a material, except those whose names
    begin with "hole". With `all_faces` all faces of a .step or .brep model are a surface in space. Curves of the names `lines` are lines inside of it. "builtin:NAME" is a built-in domain.

    Raises Error if there is no such file or domain, or the file cannot be read or holds no cells.
    """
    path = os.fspath(path)
    if path.startswith(_BUILTIN):
        return _builtin(path, 0.0)
    if not os.path.isfile(path):
        raise Error("There is no file '%s'; check the name of the domain." % path)
    ending = os.path.splitext(path)[1].lower()
    if vtkDrawingReader.CanReadFile(path):
        drawing = vtkDrawingReader()
        drawing.SetFileName(path)
        drawing.SetJoinTolerance(join_tolerance or 0.0)
        drawing.SetLayers(";".join(layers))
        drawing.SetClosedCurvesAreRegions(closed_curves_are_regions)
        drawing.SetAllFaces(all_faces)
        drawing.SetLines(";".join(lines))
        return Pipeline().update_one(drawing).GetOutput()
    if layers or closed_curves_are_regions:
        raise Error("The file '%s' is no drawing and has no layers or curves; leave them out." % path)
    if ending in (".csv", ".dat"):
        reader = vtkPlanarDomainReader()
        reader.SetFileName(path)
        return Pipeline().update_one(reader).GetOutput()
    if ending in _READERS:
        data = _read_with(_READERS[ending], path)
    else:
        raise Error("The file '%s' has an unknown ending; give one of %s, .csv, .dat, .dxf, .svg, "
                    ".geojson, .msh, .poly, .off, .step or .brep." % (path, ", ".join(_READERS)))
    if not isinstance(data, vtkDataSet) or data.GetNumberOfCells() == 0:
        raise Error(
            "The file '%s' holds no cells; give boundary lines or a triangle mesh." % path)
    return _as_curves_or_surfaces(data)


def _builtin(name: str, size: float) -> vtkPolyData:
    source = vtkPlanarDomainSource()
    source.SetDomainName(name[len(_BUILTIN):])
    source.SetEdgeLength(size)
    return Pipeline().update_one(source).GetOutput()


def _read_with(kind: Any, path: str) -> Any:
    reader = kind()
    reader.SetFileName(path)
    try:
        return Pipeline().update_one(reader).GetOutputDataObject(0)
    except Error as error:
        # The VTKs of Debian 12 cannot parse files with appended data, for example.
        raise Error("The file '%s' cannot be read (%s); check it, or save it again as binary or "
                    "ASCII, not appended." % (path, error)) from None


def _as_curves_or_surfaces(data: vtkDataSet) -> Union[vtkPolyData, vtkUnstructuredGrid]:
    """Returns one of the two types that the filters read; the cells of other data sets are
    copied."""
    if isinstance(data, (vtkPolyData, vtkUnstructuredGrid)):
        return data
    append = vtkAppendFilter()
    append.AddInputData(data)
    return Pipeline().update_one(append).GetOutput()


def material_array(materials: Optional[str]) -> str:
    """Returns the name of the array of materials for filters; those of the curves of a drawing have the usual one."""
    return materials if materials and materials != "curves" else ""


def as_domain(domain: Domain, size: Optional[float], materials: Optional[str] = None,
              lines: Sequence[str] = ()) -> Union[vtkPolyData, vtkUnstructuredGrid]:
    """Returns the data set of a domain; curves of built-in domains are sampled at `size`. With the materials
    "curves" the domain must be a drawing. Curves of a drawing of the names `lines` are lines inside."""
    if materials == "curves":
        if not isinstance(domain, (str, os.PathLike)):
            raise Error("The materials \"curves\" are those of a drawing; give the name of its file.")
        return read(domain, closed_curves_are_regions=True, lines=lines)
    if isinstance(domain, vtkDataSet):
        if domain.GetNumberOfCells() == 0:  # the filters would return an empty output
            raise Error("The domain has no cells; give boundary lines or a triangle mesh.")
        return _as_curves_or_surfaces(domain)
    if isinstance(domain, (str, os.PathLike)):
        name = os.fspath(domain)
        return _builtin(name, size or 0.0) if name.startswith(_BUILTIN) else read(name, lines=lines)
    if not isinstance(domain, (np.ndarray, Sequence)) and not hasattr(domain, "__array__"):
        raise ArgumentError("The domain is of the type %s; give an array of points, a list of loops, a data set of VTK, "
                            "the name of a file or \"builtin:NAME\"." % type(domain).__name__)
    return _loops(domain if isinstance(domain, Sequence) else np.asarray(domain))


def line_names(lines: Optional[Lines]) -> list[str]:
    """Returns the names of lines inside of a domain."""
    names_of_lines = [lines] if isinstance(lines, str) else list(lines or ())
    if not all(isinstance(name, str) and name and ";" not in name for name in names_of_lines):
        raise ArgumentError("The lines are not called by names; give a list of names, or points by names, as "
                            "{'crack': [(0, 0), (1, 0)]}.")
    return names_of_lines


def with_lines(data: vtkDataSet, lines: Optional[Lines], array: Optional[str] = None) -> vtkDataSet:
    """Returns a domain with the lines whose points are given, and their names in the cell array, by default `Side`."""
    if not isinstance(lines, Mapping) or not lines:
        return data
    chains = [positions(points, "points of the line '%s'" % name) for name, points in lines.items()]
    added = vtkPolyData()
    added.SetPoints(_points(np.concatenate(chains)))
    cells = vtkCellArray()
    for last, places in zip(np.cumsum([len(places) for places in chains]), chains):
        cells.InsertNextCell(len(places), list(range(last - len(places), last)))
    added.SetLines(cells)
    given = data.NewInstance()
    given.ShallowCopy(data)
    old = given.GetCellData().GetAbstractArray(array or names.Side)
    side = vtkStringArray()
    side.SetName(array or names.Side)
    for cell in range(given.GetNumberOfCells()):
        side.InsertNextValue(old.GetVariantValue(cell).ToString() if old else "")
    given.GetCellData().AddArray(side)
    for i in range(given.GetCellData().GetNumberOfArrays()):  # appending keeps arrays that both have
        column = given.GetCellData().GetAbstractArray(i)
        copy = column.NewInstance()
        copy.SetName(column.GetName())
        copy.SetNumberOfComponents(column.GetNumberOfComponents())
        copy.SetNumberOfTuples(len(lines))
        if not isinstance(copy, vtkStringArray):
            copy.Fill(-1)
        added.GetCellData().AddArray(copy)
    for i, name in enumerate(lines):
        added.GetCellData().GetAbstractArray(side.GetName()).SetValue(i, name)
    append = vtkAppendFilter()
    append.AddInputData(given)
    append.AddInputData(added)
    append.Update()
    append.GetOutput().SetFieldData(data.GetFieldData())
    return append.GetOutput()


def configuration(points: ArrayLike, quarter_index: ArrayLike,
                  radius: Optional[ArrayLike] = None) -> vtkPolyData:
    """Returns singularities as points with the arrays `QuarterIndex` and, if given, `Radius`.

    `points` is (n, 2), or (n, 3) for a domain in any plane of space, `quarter_index` (n,), 4 times
    the index of each; `radius` is (n,) or one number, in the units of the domain.

    >>> data = configuration([(0.3, 0.5, 0.0), (0.7, 0.5, 0.0)], [1, -1], 0.05)
    >>> data.GetNumberOfPoints()
    2
    """
    places = _numbers(points, (2, 3), "points of the singularities")
    columns = [(names.QuarterIndex, quarter_index)]
    if radius is not None:
        columns.append((names.Radius, radius))
    result = vtkPolyData()
    result.SetPoints(_points(places))
    if len(places) > 0:
        result.SetVerts(_cells(np.arange(len(places)).reshape(-1, 1)))
    for name, values in columns:
        try:
            column = np.array(np.broadcast_to(np.asarray(values, dtype=float), len(places)))
        except (TypeError, ValueError):
            raise Error("The singularities need one number '%s' for each of their %d points."
                        % (name, len(places))) from None
        # The filters report values that are not integers.
        if name == names.QuarterIndex and (column == column.astype(np.int32)).all():
            column = column.astype(np.int32)
        array = numpy_to_vtk(column, deep=True)
        array.SetName(name)
        result.GetPointData().AddArray(array)
    return result


def as_configuration(rows: Singularities, what: str = "singularities") -> vtkDataSet:
    """Returns the points of singularities or corners with their quarter indices."""
    data = getattr(rows, "data", None)  # of a result of propose, optimize or corners
    rows = data if isinstance(data, vtkDataSet) else rows
    if isinstance(rows, vtkDataSet):
        return rows
    if isinstance(rows, (str, os.PathLike)):
        name = os.fspath(rows)
        if os.path.splitext(name)[1].lower() == ".vtp" and os.path.isfile(name):
            return _read_with(vtkXMLPolyDataReader, name)
        source = vtkSingularitySource()
        source.SetFileName(name)
        return Pipeline().update_one(source).GetOutput()
    table = _numbers([] if rows is None else rows, (3, 4), what)
    return configuration(table[:, :2], table[:, 2], table[:, 3] if table.shape[1] == 4 else None)
