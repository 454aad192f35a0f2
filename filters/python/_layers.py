"""Boundary layers, treatments of corners, curves and periodic sides in the text form of vtkQuadMesher."""
from __future__ import annotations

from typing import Iterable, Mapping, Sequence, Union

import numpy as np

from ._arguments import dictionary, number, text
from ._run import ArgumentError, Error

Layers = Union[str, Mapping[str, Union[float, Sequence[float], str]]]
CornerRows = Mapping[Union[str, Sequence[float]], str]
Curves = Union[str, Mapping[str, str]]
Periodic = Union[str, Mapping[str, str], Iterable[tuple[str, str]]]


def _name(name: str) -> str:
    if not name or ";" in name:
        raise Error("The name '%s' of a side is empty or has a semicolon; rename the side." % name)
    return name


def layers_text(layers: Layers) -> str:
    """Returns first height (None: that of the quads), growth and number of rows for each side; a text is in this form already."""
    if isinstance(layers, str):
        return layers
    entries = []
    for name, values in dictionary(layers, "argument layers", "{'wall': (1e-4, 1.2)}").items():
        if not isinstance(values, str):
            row = values if isinstance(values, (list, tuple)) else np.atleast_1d(values).tolist()
            values = ",".join("" if value is None and len(row) > 1 else
                              repr(number(value, "layer of '%s'" % name, "the height of its first row, or a tuple of numbers"))
                              for value in row)
        entries.append("%s:%s" % (_name(name), values))
    return ";".join(entries)


def corner_rows_text(rows: CornerRows) -> str:
    """Returns what rows do at each corner, given by its position, or by the name of a side."""
    entries = []
    for where, word in rows.items():
        if isinstance(where, str):
            place = _name(where)
        else:
            place = ",".join(repr(float(number(x, "position of a corner", "a tuple of numbers, or the name of a side")))
                             for x in (where if isinstance(where, Sequence) else [where]))
        entries.append("%s:%s" % (place, text(word, "treatment of the corner", "'end', 'turn' or 'leave'")))
    return ";".join(entries)


def curves_text(curves: Curves) -> str:
    """Returns the kind of curve for each named side, or "auto"."""
    if isinstance(curves, str):
        if curves != "auto" and ":" not in curves:
            raise Error("The curves '%s' are neither \"auto\" nor a dictionary of sides; give one of them." % curves)
        return curves
    return ";".join("%s:%s" % (_name(name), text(kind, "curve of '%s'" % name, "'circle', 'ellipse', 'spline' or 'line'"))
                    for name, kind in dictionary(curves, "argument curves", "{'hole': 'circle'}").items())


def periodic_text(periodic: Periodic) -> str:
    """Returns the pairs of sides that are images of each other."""
    if isinstance(periodic, str):
        return periodic
    pairs = list(periodic.items() if isinstance(periodic, Mapping) else periodic) if isinstance(
        periodic, Iterable) else [periodic]
    for pair in pairs:
        if not isinstance(pair, (tuple, list)) or len(pair) != 2 or not all(isinstance(name, str) for name in pair):
            raise ArgumentError("The argument periodic has the entry %r; give pairs of names of sides, as "
                                "{'left': 'right'}." % (pair,))
    return ";".join("%s:%s" % (_name(first), _name(second)) for first, second in pairs)
