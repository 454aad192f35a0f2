#pragma once

#include "PlanarDomain.h"
#include "SizeField.h"

namespace crossfield
{
/// Returns size sources along the narrow parts of a domain, where edges of the length that `size`
/// requires would be longer than the local width divided by `edgesAcross` (docs/method.md §10.1).
///
/// The local width at a point of the boundary is the distance to the nearest boundary on the
/// opposite side: another loop, or a part of the same loop that is at least four times as far away
/// along the loop. Near a single sharp corner no width is measured. Sources are at most a local
/// width apart, and no size is below `smallest`. The result is empty if no part is narrow.
std::vector<SizeSource> FindNarrowParts(
  const PlanarDomain& domain, const SizeField& size, double edgesAcross, double smallest);
}
