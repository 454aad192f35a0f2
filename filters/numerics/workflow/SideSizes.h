#pragma once

#include "ResolvedRequest.h"

namespace crossfield
{
/// Growth of sizes per distance beside a side with a prescribed size.
constexpr double SizeGrowth = 0.25;

/// Returns the request with the sizes of sides and the bounds of sizes as
/// prescribed sizes (docs/method.md §14.8); unchanged if there are none.
///
/// On the boundary the size at a distance d from a side of size s is between s and the target size h
/// elsewhere: min(h, s + d / 4) or max(h, s − d / 4). Inside, the logarithm of its ratio to h is
/// harmonic (ExtendSizes). If a number of quads is requested, h has the factor that gives this
/// number. Throws Error as RequireConsistent does, and if the minimum size exceeds the maximum.
ResolvedRequest WithSideSizes(const PlanarDomain& domain, ResolvedRequest request);
}
