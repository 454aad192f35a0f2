#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// Throws Error, with the location, unless every triangle of the map is positively oriented and the
/// angles at every vertex add up to that of its cone: then the map is locally injective.
void RequireInjective(const SeamlessMap& map);
}
