"""Proposes, optimises and compares configurations."""
from __future__ import annotations

from typing import Any, Optional, Union

from ._arguments import checks_arguments
from ._input import Domain, Singularities, as_configuration, as_domain
from ._results import Configuration, Corners, configuration_of, report_of
from ._run import Error, Pipeline
from .vtkCrossFieldFilters import (
    vtkConfigurationProposal, vtkSingularityEnergy, vtkSingularityOptimizer)


def corner_points(corners: Union[Corners, Singularities]) -> Any:
    """Returns the points of corners with their quarter indices."""
    return corners.data if isinstance(corners, Corners) else as_configuration(corners, "corners")


def checked(size: Optional[float]) -> float:
    """Returns a length, or 0 for None; raises Error if it is not positive."""
    if size is not None and not size > 0:
        raise Error("The size %s is not positive; give a length, or None." % size)
    return size or 0.0


def chosen(pipeline: Pipeline, domain: Any, given: Singularities, size: Optional[float],
           corners: Union[Corners, Singularities],
           properties: Optional[dict[str, Any]] = None) -> Configuration:
    """Singularities that vtkConfigurationProposal, with these properties, chooses for a domain and
    moves to a minimum of the energy."""
    proposal = _proposal(pipeline, domain, given, size, corners)
    for name, value in (properties or {}).items():
        getattr(proposal, "Set" + name)(value)
    proposal.AutomaticOn()
    return configuration_of(pipeline.update(proposal))


def give(pipeline: Pipeline, algorithm: Any, domain: Any, singularities: Singularities,
         size: Optional[float], corners: Union[Corners, Singularities],
         properties: Optional[dict[str, Any]] = None) -> Optional[Configuration]:
    """Gives a filter its singularities and corners; returns the singularities if
    vtkConfigurationProposal, with these properties, had to choose them."""
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


@checks_arguments
def propose(domain: Domain, singularities: Singularities = None, *, size: Optional[float] = None,
            corners: Union[Corners, Singularities] = None, cancel_flat_corners: bool = False,
            automatic: bool = False, clearance: Optional[float] = None,
            keep_all: bool = False, feature_angle: float = 35.0) -> Configuration:
    """Proposes singularities that can exist on a domain: those given and those that the domain
    still needs.

    With `automatic` they are moved to a minimum of the energy, as `solve` does if none are given;
    `clearance` and `keep_all` are then those of `optimize`. `cancel_flat_corners` adds pairs that
    cancel corners of 135 to 180 degrees. `feature_angle` is as for `quads`. The other arguments are those of `solve`.

    >>> propose("builtin:disk").quarter_index.tolist()
    [1, 1, 1, 1]
    """
    pipeline = Pipeline()
    proposal = _proposal(pipeline, as_domain(domain, size), singularities, size, corners)
    proposal.SetCancelFlatCorners(cancel_flat_corners)
    proposal.SetAutomatic(automatic)
    proposal.SetClearance(checked(clearance))
    proposal.SetKeepAll(keep_all)
    proposal.SetFeatureAngle(feature_angle)
    return configuration_of(pipeline.update(proposal))


@checks_arguments
def optimize(domain: Domain, singularities: Singularities = None, *, size: Optional[float] = None,
             corners: Union[Corners, Singularities] = None, iterations: int = 200,
             even: bool = False, pairs: int = 0, size_array: Optional[str] = None,
             clearance: Optional[float] = None, keep_all: bool = False) -> Configuration:
    """Moves singularities to a minimum of the renormalised energy of their field.

    iterations  maximum number of iterations; default: 200
    clearance   minimum distance to the boundary and to each other; default: 1/400 of the diagonal
    keep_all    keeps every singularity in the interior or on the boundary where it started, and removes none that meet
    even        after the minimum of the energy, moves them to where the sizes of quads that follow the field are
                most uniform: report["size_spread_before"] and ["size_spread_after"] are the standard deviations of
                log size
    pairs       maximum number of pairs of quarter indices 1 and -1 to add then, where they make sizes more
                uniform; report["front"] has a row for the minimum energy, for uniform sizes, and for each pair
    size_array  with `even` or `pairs`: name of a point array of the domain with target sizes, as for `quads`; sizes
                are then in proportion to these, and the spread is that of log(size / target size)

    The other arguments are those of `solve`. Without singularities it starts from a proposal. If it
    does not converge, there is a RuntimeWarning, and report["converged"] is False.

    >>> better = optimize("builtin:disk", [(0.1, 0.2, 1), (-0.3, 0.5, 1), (-0.5, -0.6, 1), (0.3, 0, 1)])
    >>> better.report["converged"], better.points.shape
    (True, (4, 3))
    """
    if size_array is not None and not (even or pairs > 0):
        raise Error("A size_array sets the target sizes; give it with even or pairs.")
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


@checks_arguments
def energy(domain: Domain, *configurations: Singularities, size: Optional[float] = None,
           corners: Union[Corners, Singularities] = None) -> list[dict[str, Any]]:
    """Computes the energies of configurations, the best first, with the keys of `crossfield energy
    --json`.

    Each entry has the number of its `configuration`, counted from 0, and whether it is
    `consistent`; the energies of an inconsistent one are NaN. Without configurations the energy of
    a chosen one is computed.

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
    return report_of("energy", table, gradients=filter_.GetOutputDataObject(1))["configurations"]
