#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// Domain with a simplified boundary.
struct SimplifiedBoundary
{
  PlanarDomain domain;
  double moved = 0.0; ///< Largest distance from a vertex of the original boundary to the new one.
};

/// Returns the default length of thinning (docs/method.md §10.5) for a mesh size, where 0 means the
/// default mesh size: 0.02 of the smaller of the given and the default mesh size. Throws Error as
/// ResolveMeshSize does.
double DefaultThinning(const PlanarDomain& domain, double meshSize = 0.0);

/// Removes boundary detail shorter than a length (docs/method.md §10.5). Corners within the length
/// are merged into one, at the middle of the boundary between them, which turns by the sum of their
/// turns. Between corners, sides become longer, up to the length, as long as they turn by at most a
/// sixth of the corner angle.
///
/// Corners that would merge into one sharper than the corner angle, such as the end of a narrow
/// channel, are retained. Vertices at the points of `keep` on the boundary are retained, and
/// corners within the length of one of them are merged there. No point moves by more than the
/// length. Symmetries of the domain are preserved, up to rounding. A loop is unchanged if all its
/// sides are longer than the length, or if fewer than three vertices would be left; a domain is
/// unchanged if its new loops would touch.
SimplifiedBoundary ThinBoundary(const PlanarDomain& domain, double length,
  const std::vector<Point>& keep = {}, double cornerAngle = DefaultCornerAngle);

/// Does the same with a length for each loop.
SimplifiedBoundary ThinLoops(const PlanarDomain& domain, const std::vector<double>& lengths,
  const std::vector<Point>& keep = {}, double cornerAngle = DefaultCornerAngle);

/// Returns the length of thinning for a target edge length: 0.02 of it.
double ThinningFor(double size);
}
