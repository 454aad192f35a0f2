#pragma once

#include "QuadRequest.h"

#include <cstddef>
#include <vector>

namespace crossfield
{
/// One of the connected parts of a domain, which do not touch, with the sides and curves of its
/// boundary. Parts may have given names of sides in common, not generated ones.
struct DomainPart
{
  PlanarDomain domain;
  BoundarySides sides;
  CurvesOfSegments curves;
};

/// What a request means for one part.
struct PartRequest
{
  QuadRequest request;
  std::vector<std::size_t> rows; ///< Rows of the given singularities that are in the part.
  double share = 0.0;            ///< Share of the number of quads.
};

/// Divides a request: each part has what is prescribed for its sides and the singularities, corners
/// and rules inside it or nearest to it, and a share of the number of quads in proportion to its
/// area over the squared prescribed size. Singularities are chosen for parts in which none is
/// given. Throws Error if something is prescribed for a side that no part has.
std::vector<PartRequest> SplitRequest(
  const std::vector<DomainPart>& parts, const QuadRequest& request);
}
