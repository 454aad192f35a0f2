"""Functions of the package: one pipeline of filters each."""
from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from . import names
from ._arguments import checks_arguments
from ._configurations import checked, chosen as choose, corner_points, give
from ._input import (
    Domain, Lines, Singularities, as_configuration, as_domain, line_names, material_array, with_lines)
from ._results import (
    Corners, CrossField, HField, Mesh, Separatrices, ConsistencyCheck, copied, field_of, h_field_of, mesh_of,
    places, report_of, separatrices_of)
from ._run import Error, Pipeline
from .vtkCrossFieldFilters import (
    vtkBoundaryCornerClassifier, vtkCrossFieldMap, vtkDrillHoles, vtkGinzburgLandauCrossField,
    vtkHField, vtkPerforatedCrossField, vtkPoincareHopfCheck, vtkSeparatrices)

_STARTS = {"constrained": {"best": vtkPerforatedCrossField.StartBest,
                           "harmonic": vtkPerforatedCrossField.StartHarmonic,
                           "unit-norm": vtkPerforatedCrossField.StartUnitNorm},
           "unit-norm": {},
           "ginzburg-landau": {"harmonic": vtkGinzburgLandauCrossField.StartHarmonic,
                               "constant": vtkGinzburgLandauCrossField.StartConstant,
                               "zero": vtkGinzburgLandauCrossField.StartZero}}

_ARRAYS = {"exact": 0, "display": 1, "all": 2}  # codes of vtkCrossFieldArraySets


def _choice(value: str, choices: Any, what: str) -> Any:
    if value not in choices:
        raise Error("There is no %s '%s'; choose %s." % (what, value, ", ".join(choices) or "none"))
    return choices[value]


def _drilled(pipeline: Pipeline, domain: Any, singularities: Any,
             size: Optional[float], minimum_hole_edges: int, gradation: float) -> Any:
    checked(size)
    drill_holes = pipeline.add(vtkDrillHoles())
    drill_holes.SetInputData(domain)
    drill_holes.SetSingularitiesData(singularities)
    drill_holes.SetMeshSize(size or 0.0)
    drill_holes.SetMinimumHoleEdges(minimum_hole_edges)
    drill_holes.SetGradation(gradation)
    return drill_holes


@checks_arguments
def drill(domain: Domain, singularities: Singularities = None, *, size: Optional[float] = None,
          minimum_hole_edges: int = 32, gradation: float = 0.25) -> Mesh:
    """Triangulates a domain with a small hole at every singularity.

    The arguments are those of `solve`; without singularities they are chosen. `gradation` is the
    maximum growth of the edge length per unit of distance, `minimum_hole_edges` the minimum number
    of edges on a hole.

    >>> mesh = drill("builtin:square", [(1.5, 1, 1, 0.1), (0.5, 1, -1, 0.1)])
    >>> sorted(set(mesh.quarter_index.tolist()))
    [-1, 0, 1]
    """
    pipeline = Pipeline()
    data = as_domain(domain, size)
    rows = (choose(pipeline, data, None, size, None).data if singularities is None
            else as_configuration(singularities))
    found = _drilled(pipeline, data, rows, size, minimum_hole_edges, gradation)
    return mesh_of(pipeline.update(found).GetOutput())


@checks_arguments
def solve(domain: Domain, singularities: Singularities = None, *, size: Optional[float] = None,
          method: str = "unit-norm", start: Optional[str] = None, unit_holes: bool = False,
          corners: Union[Corners, Singularities] = None, epsilon: Optional[float] = None,
          minimum_hole_edges: int = 32, gradation: float = 0.25, arrays: str = "all") -> CrossField:
    """Computes the smoothest cross field that is aligned with the boundary and has these
    singularities.

    domain         a loop, an array (n, 2) of points; a list of loops; any vtkDataSet with boundary
                   lines or a surface mesh; a file; or "builtin:NAME". Loops may be in any plane of
                   space, (n, 3).
    singularities  an array (m, 3) of x, y, quarter index, or (m, 4) with a radius; any vtkDataSet of
                   points with `QuarterIndex`, see `configuration`; a .csv or .vtp file; a result of
                   `propose` or `optimize`; [] for none. Default: None, they are chosen for the domain, and
                   report["events"] lists the decisions
    size           target edge length of the mesh; default: 1/40 of the diagonal of the domain
    method         "unit-norm": norm one, with exactly these singularities; "constrained": the method of the paper,
                   whose norm is free; if it vanishes elsewhere, there are further singularities and a
                   RuntimeWarning; "ginzburg-landau": places the singularities itself
    start          "constrained": "best" (default), "harmonic", "unit-norm"; "ginzburg-landau":
                   "harmonic" (default), "constant", "zero"
    unit_holes     forces unit crosses on the holes
    corners        quarter indices of corners: a result of `corners`, or as `singularities`
    epsilon        "ginzburg-landau": radius of the cores, a length; default: the mean edge length by area
    minimum_hole_edges, gradation
                   options of the mesh, see `drill`
    arrays         arrays of `grid`, and of a file that it is written to: "all"; "display", without Representation
                   and Cross2; "exact", only the array that holds `u`

    Raises Error with one sentence if the input is bad or no such field exists. An iteration that
    does not converge is a RuntimeWarning, and report["converged"] is False.

    >>> len(solve("builtin:disk").report["singularities"])
    4

    >>> import numpy as np
    >>> outer = [(0, 0), (6, 0), (6, 4), (0, 4)]
    >>> t = np.arange(32) * 2 * np.pi / 32
    >>> inner = np.column_stack([3 + 0.8 * np.cos(t), 2 + 0.8 * np.sin(t)])
    >>> field = solve([outer, inner], [(1, 2, -2, 0.2), (5, 2, -2, 0.2)], size=0.3)
    >>> field.hole_degrees.tolist(), field.report["converged"]
    ([-2, -2], True)
    >>> field.u.shape == (len(field.triangles), 3)
    True
    >>> solve(outer, [(1, 2, 1)])
    Traceback (most recent call last):
    crossfield.Error: The quarter indices of the singularities add up to 1 ...
    """
    starts = _choice(method, _STARTS, "method")
    array_set = _choice(arrays, _ARRAYS, "choice of arrays")
    pipeline = Pipeline()
    data = as_domain(domain, size)
    chosen = None
    rows = as_configuration([] if singularities is None else singularities)
    if method == "ginzburg-landau":
        if singularities is not None:
            raise Error("The method ginzburg-landau has its own singularities; give none.")
        if unit_holes or corners is not None:
            raise Error("The options unit_holes and corners do not belong to the method "
                        "ginzburg-landau; leave them out.")
        solver = pipeline.add(vtkGinzburgLandauCrossField())
        solver.SetEpsilon(epsilon or 0.0)
    else:
        if epsilon is not None:
            raise Error("The option epsilon belongs to the method ginzburg-landau; leave it out.")
        solver = pipeline.add(vtkPerforatedCrossField())
        if method == "constrained":
            solver.SetMethodToConstrained()
        solver.SetUnitHoles(unit_holes)
        if singularities is None:
            chosen = choose(pipeline, data, None, size, corners)
            rows = chosen.data
            solver.SetCornersData(chosen.corners)
        elif corners is not None:
            solver.SetCornersData(corner_points(corners))
    if start is not None:
        solver.SetStart(_choice(start, starts, "start of the method " + method))
    solver.SetArrays(array_set)
    found = _drilled(pipeline, data, rows, size, minimum_hole_edges, gradation)
    solver.SetInputConnection(found.GetOutputPort())
    return field_of(pipeline.update(solver).GetOutput(), chosen)


@checks_arguments
def hfield(domain: Domain, singularities: Singularities = None, *, size: Optional[float] = None,
           corners: Union[Corners, Singularities] = None, arrays: str = "all") -> HField:
    """Computes the size field H, its size map and its cross field of norm one, with singularities
    as points.

    The arguments are those of `solve`; singularities may be on the boundary. `domain` can also be
    the `grid` of a drilled mesh, whose holes are then the singularities.

    >>> field = hfield("builtin:disk", [(0, 0, 4)])
    >>> field.h.shape == field.size_map.shape == (len(field.points),)
    True
    """
    pipeline = Pipeline()
    data = as_domain(domain, size)
    solver = pipeline.add(vtkHField())
    solver.SetArrays(_choice(arrays, _ARRAYS, "choice of arrays"))
    solver.SetInputData(data)
    solver.SetMeshSize(checked(size))
    chosen = None
    if singularities is not None or not data.GetCellData().HasArray(names.BoundaryKind):
        chosen = give(pipeline, solver, data, singularities, size, corners)
    elif corners is not None:  # a drilled mesh has its singularities
        solver.SetCornersData(corner_points(corners))
    return h_field_of(pipeline.update(solver).GetOutput(), chosen)


@checks_arguments
def check(domain: Domain, singularities: Singularities = None, *,
          corners: Union[Corners, Singularities] = None, corner_angle: float = 30.0,
          holonomy: bool = True, cap_corners: bool = True, materials: Optional[str] = None,
          lines: Optional[Lines] = None, feature_angle: float = 35.0) -> ConsistencyCheck:
    """Checks whether singularities can exist on a domain, and why, by the Poincaré-Hopf theorem.

    The arguments are those of `solve`; `domain` can also be the `grid` of a solved field, which is
    then checked itself. A vertex of the boundary that turns by more than `corner_angle` degrees is
    a corner. `holonomy` also computes the holonomy defects of inner loops, which takes a solve.
    `cap_corners` gives sharp corners of quarter index 2 index 1, as `quads` does. `materials` is the
    cell array of a mesh with the materials of its cells, as for `quads`: each region is checked by
    itself. `lines` and `feature_angle` are as for `quads`. A configuration that cannot exist is no error.

    >>> checked = check("builtin:disk", [(0, 0, 1)])
    >>> checked.consistent, checked.report["required_interior_quarters"]
    (False, 4)
    """
    pipeline = Pipeline()
    filter_ = pipeline.add(vtkPoincareHopfCheck())
    data = as_domain(domain, None, materials, line_names(lines))
    filter_.SetInputData(with_lines(data, lines))
    filter_.SetLines(";".join(line_names(lines)))
    if singularities is not None:
        filter_.SetSingularitiesData(as_configuration(singularities))
    if corners is not None:
        filter_.SetCornersData(corner_points(corners))
    filter_.SetCornerAngle(corner_angle)
    filter_.SetFeatureAngle(feature_angle)
    filter_.SetHolonomy(holonomy)
    filter_.SetCapCorners(cap_corners)
    filter_.SetMaterialArray(material_array(materials))
    checked = pipeline.update(filter_).GetOutput()
    found = filter_.GetOutputDataObject(2)
    report = report_of("check", checked, corners=found, loops=filter_.GetOutputDataObject(1))
    data = found.GetPointData()
    return ConsistencyCheck(
        consistent=report["consistent"],
        reason=report["reason"],
        corner_points=places(found), corner_angles=copied(data, names.Angle),
        corner_quarters=copied(data, names.QuarterIndex),
        cancellable=copied(data, names.Cancellable) != 0, report=report)


@checks_arguments
def corners(domain: Domain, *, corner_angle: float = 30.0, printed_coefficient: bool = False,
            overrides: Sequence[tuple[float, float, int]] = ()) -> Corners:
    """Computes the quarter indices of corners that have minimum energy with the singularities that
    they require.

    `overrides` are rows of x, y and quarter index for the corner nearest to (x, y), in coordinates
    of the domain's plane. `printed_coefficient` counts interior singularities twice, as the formula
    printed in the paper does.

    >>> found = corners("builtin:l-shape")
    >>> found.quarter_index.tolist(), found.interior_quarters
    ([1, 1, 1, -1, 1, 1], 0)
    """
    pipeline = Pipeline()
    classifier = pipeline.add(vtkBoundaryCornerClassifier())
    classifier.SetInputData(as_domain(domain, None))
    classifier.SetCornerAngle(corner_angle)
    classifier.SetPrintedCoefficient(printed_coefficient)
    for row in overrides:
        classifier.AddOverride(*row)
    found = pipeline.update(classifier).GetOutput()
    data = found.GetPointData()
    report = report_of("corners", found, scenarios=classifier.GetOutputDataObject(1))
    return Corners(
        points=places(found), angle=copied(data, names.Angle),
        quarter_index=copied(data, names.QuarterIndex),
        scarce=copied(data, names.QuarterIndexScarce),
        balanced=copied(data, names.QuarterIndexBalanced),
        excess=copied(data, names.QuarterIndexExcess),
        conventional=copied(data, names.QuarterIndexConventional),
        corner_energy=copied(data, names.CornerEnergy),
        cancellable=copied(data, names.Cancellable) != 0, tied=copied(data, names.Tied) != 0,
        scenario=report["scenario"], energy=report["energy"],
        interior_quarters=report["interior_quarters"], scenarios=report["scenarios"], data=found)


@checks_arguments
def separatrices(domain: Domain, singularities: Singularities = None, *,
                 size: Optional[float] = None, corners: Union[Corners, Singularities] = None,
                 cap_corners: bool = False, repair_holonomy: bool = False,
                 seeds: Singularities = None) -> Separatrices:
    """Traces the separatrices of a cross field, the lines that leave its singularities, and the
    rectangles between them.

    The arguments are those of `solve`, without holes. `cap_corners` treats very sharp corners
    (quarter index 2) as ordinary ones (index 1). `repair_holonomy` moves singularities slightly so
    that grid lines close up around each hole; `report["repair"]` has the distance. From each of
    `seeds`, points as `singularities`, four streamlines are traced.

    >>> found = separatrices("builtin:l-shape")
    >>> len(found.lines), len(found.faces)
    (2, 3)
    """
    pipeline = Pipeline()
    data = as_domain(domain, size)
    flat = pipeline.add(vtkCrossFieldMap())
    flat.SetInputData(data)
    flat.SetMeshSize(checked(size))
    chosen = give(pipeline, flat, data, singularities, size, corners, {"CapCorners": cap_corners})
    flat.SetCapCorners(cap_corners)
    flat.SetRepairHolonomy(repair_holonomy)
    traced = pipeline.add(vtkSeparatrices())
    traced.SetInputConnection(flat.GetOutputPort())
    if seeds is not None:
        traced.SetSeedsData(as_configuration(seeds, "seeds"))
    pipeline.update(traced)
    return separatrices_of(traced.GetOutput(0), traced.GetOutput(1), flat.GetOutput(), chosen)
