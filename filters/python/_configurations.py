"""Configurations: proposed, optimised and compared."""
from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np

from . import names
from ._input import Domain, Singularities, as_configuration, as_domain
from ._results import Configuration, Corners, configuration_of, snake_case
from ._run import Error, Pipeline
from .vtkCrossFieldFilters import (
    vtkConfigurationProposal, vtkSingularityEnergy, vtkSingularityOptimizer)


def corner_points(corners: Union[Corners, Singularities]) -> Any:
    return corners.data if isinstance(corners, Corners) else as_configuration(corners, "corners")


def checked(size: Optional[float]) -> float:
    if size is not None and not size > 0:
        raise Error("The size %s is not positive; give a length, or None." % size)
    return size or 0.0


def chosen(pipeline: Pipeline, domain: Any, given: Singularities, size: Optional[float],
           corners: Union[Corners, Singularities],
           properties: Optional[dict[str, Any]] = None) -> Configuration:
    """Singularities that vtkConfigurationProposal, with these properties, chooses for a domain and moves to a minimum
    of the energy."""
    proposal = _proposal(pipeline, domain, given, size, corners)
    for name, value in (properties or {}).items():
        getattr(proposal, "Set" + name)(value)
    proposal.AutomaticOn()
    return configuration_of(pipeline.update(proposal))


def give(pipeline: Pipeline, algorithm: Any, domain: Any, singularities: Singularities,
         size: Optional[float], corners: Union[Corners, Singularities],
         properties: Optional[dict[str, Any]] = None) -> Optional[Configuration]:
    """Gives a filter its singularities and corners; returns the singularities if vtkConfigurationProposal, with these
    properties, had to choose them."""
    if singularities is None:
        choice = chosen(pipeline, domain, None, size, corners, properties)
        algorithm.SetSingularitiesData(choice.data)
        algorithm.SetCornersData(choice.corners)
        return choice
    algorithm.SetSingularitiesData(as_configuration(singularities))
    if corners is not None:
        algorithm.SetCornersData(corner_points(corners))
    return None


def _proposal(pipeline: Pipeline, domain: Any, given: Singularities, size: Optional[float],
              corners: Union[Corners, Singularities]) -> Any:
    proposal = pipeline.add(vtkConfigurationProposal())
    proposal.SetInputData(domain)
    proposal.SetMeshSize(checked(size))
    if given is not None:
        proposal.SetSingularitiesData(as_configuration(given))
    if corners is not None:
        proposal.SetCornersData(corner_points(corners))
    return proposal


def report_choice(report: dict[str, Any], chosen: Optional[Configuration], points: np.ndarray) -> None:
    """Adds chosen singularities as the program reports them: z only where the points of the result differ in it."""
    if chosen is None:
        return
    axes = "xyz" if np.ptp(points[:, 2]) > 0 else "xy"
    report["singularities"] = [
        {**dict(zip(axes, point)), "quarter_index": k}
        for point, k in zip(chosen.points.tolist(), chosen.quarter_index.tolist())]
    report["events"] = list(chosen.events)


def propose(domain: Domain, singularities: Singularities = None, *, size: Optional[float] = None,
            corners: Union[Corners, Singularities] = None, cancel_flat_corners: bool = False,
            automatic: bool = False, clearance: Optional[float] = None,
            keep_all: bool = False) -> Configuration:
    """Singularities that can exist on a domain: those given and what they lack.

    With `automatic` they are moved to where the energy is least, as `solve` does when none are given;
    `clearance` and `keep_all` are then those of `optimize`. The other arguments are those of `solve`.

    >>> propose("builtin:disk").quarter_index.tolist()
    [1, 1, 1, 1]
    """
    pipeline = Pipeline()
    proposal = _proposal(pipeline, as_domain(domain, size), singularities, size, corners)
    proposal.SetCancelFlatCorners(cancel_flat_corners)
    proposal.SetAutomatic(automatic)
    proposal.SetClearance(checked(clearance))
    proposal.SetKeepAll(keep_all)
    return configuration_of(pipeline.update(proposal))


def optimize(domain: Domain, singularities: Singularities = None, *, size: Optional[float] = None,
             corners: Union[Corners, Singularities] = None, iterations: int = 200,
             even: bool = False, pairs: int = 0, size_array: Optional[str] = None,
             clearance: Optional[float] = None, keep_all: bool = False) -> Configuration:
    """Moves singularities to where the renormalised energy of their field is least.

    `clearance` is their least distance to the boundary and to each other, 1/400 of the diagonal if it is
    None; with `keep_all` none of them moves into the boundary or out of it, or is taken out.

    With `even` it then moves on to where the sizes of quads that follow the field are most even:
    report["size_spread_before"] and ["size_spread_after"] are the standard deviations of log size. With `pairs`
    up to so many pairs of indices 1 and -1 are added after that, while they bring something; the lists
    report["front_singularities"], ["front_size_spread"], ["front_renormalized_energy"] and
    ["front_holonomy_defect"] have an entry for the least energy, for even sizes, and for each pair.
    `size_array`, with `even` or `pairs`, is the name of a point array of the domain with wanted sizes, as for `quads`:
    sizes are then to be in proportion to these, and the spread is that of log(size / wanted size).

    The arguments are those of `solve`; it starts from a proposal if no singularities are given. Where
    they do not come to rest there is a RuntimeWarning, and report["converged"] is False.

    >>> better = optimize("builtin:disk", [(0.1, 0.2, 1), (-0.3, 0.5, 1), (-0.5, -0.6, 1), (0.3, 0, 1)])
    >>> better.report["converged"], better.points.shape
    (True, (4, 3))
    """
    if size_array is not None and not (even or pairs > 0):
        raise Error("A size_array says which sizes are even; give it with even or pairs.")
    pipeline = Pipeline()
    data = as_domain(domain, size)
    if singularities is None:
        start = pipeline.update(_proposal(pipeline, data, None, size, corners)).GetOutput()
    else:
        start = as_configuration(singularities)
    optimizer = pipeline.add(vtkSingularityOptimizer())
    optimizer.SetInputData(data)
    optimizer.SetSingularitiesData(start)
    optimizer.SetMeshSize(checked(size))
    optimizer.SetMaximumIterations(iterations)
    optimizer.SetUniformSizes(even)
    optimizer.SetPairs(pairs)
    if size_array is not None:
        optimizer.SetSizingToField()
        optimizer.SetSizeArray(size_array)
    optimizer.SetClearance(checked(clearance))
    optimizer.SetKeepAll(keep_all)
    if corners is not None:
        optimizer.SetCornersData(corner_points(corners))
    return configuration_of(pipeline.update(optimizer))


def energy(domain: Domain, *configurations: Singularities, size: Optional[float] = None,
           corners: Union[Corners, Singularities] = None) -> list[dict[str, Any]]:
    """Energies of configurations, the best first, under the names of `crossfield energy --json`.

    Each entry says which `configuration` it is, counted from 0, and whether it is `consistent`; if not,
    its energies are not numbers. Without configurations that of a chosen one.

    >>> inner = [(0.3, 0.3, 1), (-0.3, 0.3, 1), (-0.3, -0.3, 1), (0.3, -0.3, 1)]
    >>> [row["configuration"] for row in energy("builtin:disk", inner, None)]
    [1, 0]
    """
    pipeline = Pipeline()
    data = as_domain(domain, size)
    filter_ = pipeline.add(vtkSingularityEnergy())
    filter_.SetInputData(data)
    filter_.SetMeshSize(checked(size))
    if corners is not None:
        filter_.SetCornersData(corner_points(corners))
    for rows in configurations or (None,):
        filter_.AddConfigurationData(
            chosen(pipeline, data, None, size, corners).data if rows is None
            else as_configuration(rows))
    table = pipeline.update(filter_).GetOutput()
    rows_of_table = []
    for row in range(table.GetNumberOfRows()):
        values: dict[str, Any] = {}
        for column in range(table.GetNumberOfColumns()):
            name = table.GetColumnName(column)
            cell = table.GetValue(row, column)
            values[snake_case(name)] = (
                cell.ToInt() if name == names.Configuration
                else cell.ToInt() != 0 if name == names.Consistent else cell.ToDouble())
        rows_of_table.append(values)
    return rows_of_table
