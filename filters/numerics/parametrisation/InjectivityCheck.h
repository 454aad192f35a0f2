#pragma once

#include "SeamlessMap.h"

#include <optional>
#include <string>

namespace crossfield
{
/// Where a map is not locally injective.
struct MapFault
{
  int reversed = 0;  ///< Number of triangles that are not positive.
  std::string where; ///< Position, for messages.
  /// If all triangles are positive: the sum of the angles at a vertex, and what it should be.
  double angleSum = 0.0;
  double expectedSum = 0.0;
};

/// Returns a clause that says what is wrong, with the place.
std::string DescribeFault(const MapFault& fault);

/// Returns the first fault of a map: triangles that are not positive, or a vertex at which the
/// angles do not add up. Without a fault the map is locally injective (docs/method.md §12.1).
std::optional<MapFault> FindFault(const SeamlessMap& map);
}
