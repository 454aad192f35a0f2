#pragma once

#include "QuadRequest.h"

#include <array>
#include <optional>
#include <string>

namespace crossfield
{
/// A domain whose sharpest corners are replaced by edges, as at the trailing edge of a profile.
struct CutDomain
{
  PlanarDomain domain;
  QuadRequest request;
  std::string warning; ///< Sentence that says where corners were cut off.
};

/// Parts of the diagonal of a domain by which its sharp corners are cut off, one after the other until there are
/// quads: as little as possible, and the longest is less than one of a thousand quads.
constexpr std::array<double, 3> TipLengths = { 1.0 / 800.0, 1.0 / 200.0, 1.0 / 50.0 };

/// Cuts off corners below 45°: the boundary within a length of the corner on both sides, measured
/// along it, is replaced by an edge whose ends are on the curves of the domain. Corners with a
/// prescribed quarter index stay. Returns nothing if there is no such corner.
std::optional<CutDomain> CutSharpTips(
  const PlanarDomain& domain, const QuadRequest& request, double length);
}
