"""Reports of the functions, with the keys of `crossfield --json`.

The table reports.json, which the program reads as well, lists the keys of every report and the
arrays that they come from, and explains its kinds of entries.
"""
from __future__ import annotations

import json
import pathlib
from dataclasses import dataclass
from typing import Any, Optional, Sequence

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkTable

from . import names

_TABLE = json.loads(pathlib.Path(__file__).with_name("reports.json").read_text(encoding="utf-8"))
_TYPES = {"number": float, "integer": int, "flag": bool, "text": str}


def report_of(name: str, data: Any, seconds: Sequence[float] = (), **others: Any) -> dict[str, Any]:
    """Returns the report of this name on `data`; `others` are further sources by name, or None."""
    reader = _Reader({"": data, **others}, seconds)
    place = _Place(data.GetFieldData())
    report: dict[str, Any] = {}
    reader.fill(_TABLE["reports"][name], place, report)
    reader.fill(_TABLE["common"], place, report)
    return report


@dataclass
class _Place:
    """Source from which entries read arrays: field data, or a row of a table or of points."""

    arrays: Any
    points: Any = None
    row: int = 0


def _has_height(data: Any) -> bool:
    """Returns whether a domain or mesh is in no plane z = const; false for points without cells."""
    if not isinstance(data, vtkDataSet) or data.GetMaxCellSize() < 2:
        return False
    bounds = data.GetBounds()
    return bounds[4] < bounds[5]


def _convert(array: Any, index: int, kind: str) -> Any:
    return _TYPES[kind](array.GetValue(index))


class _Reader:
    """Evaluates entries of the table; None means that an entry is left out."""

    def __init__(self, sources: dict[str, Any], seconds: Sequence[float]) -> None:
        self._sources = sources
        self._seconds = seconds
        self._has_height = any(map(_has_height, sources.values()))

    def fill(self, entries: dict[str, Any], place: _Place, report: dict[str, Any]) -> None:
        """Adds the entries whose keys the report does not have yet."""
        for key, entry in entries.items():
            if isinstance(entry, list) and entry[0] == "if":
                self.fill(entry[2], place, report)
            elif key not in report:
                value = self._value(entry, place)
                if value is not None:
                    report[key] = value

    def _value(self, entry: Any, place: _Place) -> Any:
        if isinstance(entry, dict):
            found: dict[str, Any] = {}
            self.fill(entry, place, found)
            return found or None
        kind, *arguments = entry
        if "rows" in kind:
            return self._rows(kind, place, *arguments)
        if kind == "columns":
            return self._columns(place, *arguments)
        if kind == "coordinate":
            axis, = arguments
            return place.points.GetPoint(place.row)[axis] if axis < 2 or self._has_height else None
        if kind == "triangles":
            kinds = self._sources[""].GetCellData().GetArray(names.BoundaryKind)
            return int(np.count_nonzero(vtk_to_numpy(kinds) == 0))
        if kind == "stages":
            return dict(zip(arguments, self._seconds)) if self._seconds else None
        if kind == "seconds":
            return self._seconds[arguments[0]]
        if kind == "file":
            return None  # configurations are no files here
        return self._from_array(kind, place, *arguments)

    def _array(self, name: str, place: _Place) -> Optional[Any]:
        source, slash, array = name.rpartition("/")
        if not slash:
            return place.arrays.GetAbstractArray(name)
        data = self._sources.get(source)
        return data.GetFieldData().GetAbstractArray(array) if data else None

    def _from_array(self, kind: str, place: _Place, name: str, option: Any = 0) -> Any:
        array = self._array(name, place)
        if kind == "counts":
            counts = self._array(option, place)
            return {str(_convert(array, i, "integer")): _convert(counts, i, "integer")
                    for i in range(array.GetNumberOfTuples()) if counts.GetValue(i) > 0}
        if array is None:
            return [] if option == "always" else None
        width = array.GetNumberOfComponents()
        if kind in _TYPES:
            return _convert(array, place.row * width + option, kind)
        values = [_convert(array, i, kind[:-1]) for i in range(array.GetNumberOfValues())]
        return values if width == 1 else [values[i:i + width] for i in range(0, len(values), width)]

    def _rows(self, kind: str, outer: _Place, source: str, entries: dict[str, Any], name: str = "") -> Any:
        data = self._sources.get(source)
        if data is None:
            return None
        is_table = isinstance(data, vtkTable)
        place = _Place(data.GetRowData() if is_table else data.GetPointData(), data)
        rows, keys = [], []
        for place.row in range(data.GetNumberOfRows() if is_table else data.GetNumberOfPoints()):
            row: dict[str, Any] = {}
            self.fill(entries, place, row)
            rows.append(row)
            keys.append(self._array(name, place).GetValue(place.row) if name else None)
        if kind == "rows of":
            key = self._array(name, outer).GetValue(outer.row)
            return [row for row, other in zip(rows, keys) if other == key]
        return dict(zip(keys, rows)) if kind == "named rows" else rows

    def _columns(self, place: _Place, entries: dict[str, Any]) -> Optional[list[dict[str, Any]]]:
        first = self._array(next(iter(entries.values()))[1], place)
        if first is None:
            return None
        rows = []
        for i in range(first.GetNumberOfTuples()):
            row: dict[str, Any] = {}
            self.fill(entries, _Place(place.arrays, row=i), row)
            rows.append(row)
        return rows
