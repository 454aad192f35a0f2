#pragma once

#include "QuadRequest.h"

#include <optional>
#include <string>

namespace crossfield
{
/// A domain whose sharpest corners, between short segments, are replaced by edges, as at the cusp of a
/// profile.
struct CutDomain
{
  PlanarDomain domain;
  QuadRequest request;
  std::string warning; ///< Sentence that says where corners were cut off.
};

/// Cuts off corners below 15° between curves or chains of short segments: each loses its vertex and
/// `vertices` − 1 more on both sides. Corners with a prescribed quarter index stay. Returns nothing if
/// there is no such corner.
std::optional<CutDomain> CutSharpTips(
  const PlanarDomain& domain, const QuadRequest& request, int vertices);
}
