"""Removes detail from the boundary of a domain before it is meshed."""
from __future__ import annotations

from typing import Optional, Union

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from . import names
from ._arguments import checks_arguments
from ._configurations import checked
from ._input import Domain, Singularities, as_configuration, as_domain
from ._layers import Curves, curves_text
from ._run import Error, Pipeline
from .vtkCrossFieldFilters import vtkBoundarySimplifier


@checks_arguments
def simplify(domain: Domain, *, size: Optional[float] = None, thin: Optional[float] = None,
             smooth: float = 0.0, keep: Singularities = None, corner_angle: float = 30.0,
             curves: Optional[Curves] = None, part: Union[str, int] = ""
             ) -> tuple[Union[vtkPolyData, vtkUnstructuredGrid], float]:
    """Returns a domain with less detail in its boundary, and the maximum distance that the boundary
    was moved.

    domain  as for `solve`
    size    target edge length of the mesh; default: 1/40 of the diagonal
    thin    removes detail below this length; 0: none; default: 0.02 of the size
    smooth  smooths waves below this length; 0: none
    keep    singularities and corners on the boundary, which stays in place there

    curves  curves that sides stand for, as for `quads`: they are fitted before the boundary is simplified, and
            the domain has them
    part    which of several separate parts of the domain: "largest", a number from 1 for the largest, or the name of a
            side that one part alone has

    The program simplifies every domain; the other functions of this package do not.

    >>> coast, moved = simplify("builtin:star", smooth=0.05)
    >>> moved
    0.0
    """
    if thin is not None and not thin >= 0:
        raise Error("The length %s to thin the boundary by is negative; give 0 for none, or None." % thin)
    if not smooth >= 0:
        raise Error("The length %s to smooth the boundary by is negative; give 0 for none." % smooth)
    pipeline = Pipeline()
    simplifier = pipeline.add(vtkBoundarySimplifier())
    simplifier.SetInputData(as_domain(domain, size))
    simplifier.SetPart(str(part))
    simplifier.SetMeshSize(checked(size))
    simplifier.SetThinningLength(-1.0 if thin is None else thin)
    simplifier.SetSmoothingLength(smooth)
    simplifier.SetCornerAngle(corner_angle)
    if curves is not None:
        simplifier.SetCurves(curves_text(curves))
    if keep is not None:
        simplifier.SetInputData(1, as_configuration(keep))
    found = pipeline.update(simplifier).GetOutputDataObject(0)
    moved = found.GetFieldData().GetArray(names.BoundaryMoved)
    return found, moved.GetValue(0) if moved else 0.0
