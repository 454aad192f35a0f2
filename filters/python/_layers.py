"""Boundary layers, treatments of corners, curves and periodic sides in the text form of vtkQuadMesher."""
from __future__ import annotations

from typing import Iterable, Mapping, Sequence, Union

from ._run import Error

Layers = Mapping[str, Union[float, Sequence[float]]]
CornerRows = Mapping[Union[str, Sequence[float]], str]
Curves = Union[str, Mapping[str, str]]
Periodic = Union[Mapping[str, str], Iterable[tuple[str, str]]]


def _name(name: str) -> str:
    if not name or ";" in name:
        raise Error("The name '%s' of a side is empty or has a semicolon; rename the side." % name)
    return name


def layers_text(layers: Layers) -> str:
    """Returns first height, growth and number of rows for each named side."""
    entries = []
    for name, values in layers.items():
        numbers = [values] if isinstance(values, (int, float)) else list(values)
        entries.append("%s:%s" % (_name(name), ",".join(str(number) for number in numbers)))
    return ";".join(entries)


def corner_rows_text(rows: CornerRows) -> str:
    """Returns what rows do at each corner, given by its position, or by the name of a side."""
    entries = []
    for where, word in rows.items():
        place = _name(where) if isinstance(where, str) else ",".join(repr(float(x)) for x in where)
        entries.append("%s:%s" % (place, word))
    return ";".join(entries)


def curves_text(curves: Curves) -> str:
    """Returns the kind of curve for each named side, or "auto"."""
    if isinstance(curves, str):
        if curves != "auto":
            raise Error("The curves '%s' are neither \"auto\" nor a dictionary of sides; give one of them." % curves)
        return curves
    return ";".join("%s:%s" % (_name(name), kind) for name, kind in curves.items())


def periodic_text(periodic: Periodic) -> str:
    """Returns the pairs of sides that are images of each other."""
    pairs = periodic.items() if isinstance(periodic, Mapping) else periodic
    return ";".join("%s:%s" % (_name(first), _name(second)) for first, second in pairs)
