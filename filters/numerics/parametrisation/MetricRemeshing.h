#pragma once

#include "ConeMetric.h"

namespace crossfield
{
/// Number of local changes of a triangulation.
struct RemeshingCount
{
  int flips = 0;
  int splits = 0;
};

/// Divides sides opposite to vertices that have too few triangles for the angle they should have
/// (docs/method.md §12.6).
RemeshingCount SplitNarrowFans(ConeMetric& metric);

/// Removes angles near π from a metric by flips and splits that are valid on the surface as well
/// (docs/method.md §12.6). At most `maximumSplits` splits.
RemeshingCount ImproveTriangles(ConeMetric& metric, int maximumSplits);
}
