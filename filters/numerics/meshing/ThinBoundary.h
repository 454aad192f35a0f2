#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// A boundary with less detail.
struct SimplifiedBoundary
{
  PlanarDomain domain;
  double moved = 0.0; ///< The largest distance of a vertex of the old boundary to the new one.
};

/// The length that is thinned unless one is given (docs/method.md §10.5), of a domain that is meant for a mesh size, 0 for
/// the default one: 0.02 of it, and of the default one where that is less. Throws Error as ResolveMeshSize does.
double DefaultThinning(const PlanarDomain& domain, double meshSize = 0.0);

/// Takes detail out of a boundary that is shorter than a length (docs/method.md §10.5): corners within it become
/// one, in the middle of the boundary between them, which turns by the sum of their turns; between
/// corners, sides become longer, up to that length, while they turn by at most a sixth of the corner angle.
///
/// Corners that would make one sharper than the corner angle, as the end of a narrow channel, stay.
/// Vertices at the places of `keep` that lie on the boundary stay, and corners within the length of one of them become one
/// there. Nothing moves by more than the length, and nothing at all where all sides are longer. The
/// symmetries of a domain stay, to rounding. A loop that would have fewer than three vertices stays as it is, and so does a
/// domain whose new loops would touch.
SimplifiedBoundary ThinBoundary(const PlanarDomain& domain, double length,
  const std::vector<Point>& keep = {}, double cornerAngle = DefaultCornerAngle);
}
