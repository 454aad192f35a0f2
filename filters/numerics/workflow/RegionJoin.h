#pragma once

#include "LaidOutRegion.h"
#include "RegionSet.h"

namespace crossfield
{
/// The layouts of regions as one, with their sides, curves and prescriptions.
struct JoinedRegions
{
  /// Whose pairs are the two sides of each interface, in the order of the set, and then periodic sides.
  LayoutSet layouts;
  BoundarySides sides; ///< Sides of equal names are one, but for the two sides of an interface.
  CurvedBoundary curves;
  SidePrescriptions prescribed;
  std::vector<std::size_t> patches; ///< First patch of each region, and their number.
};

/// Joins the layouts of regions, which are moved out of them. The sizes of the sides `targets` are not prescribed.
JoinedRegions JoinRegions(
  const RegionSet& set, LaidOutRegions& regions, const std::vector<std::string>& targets);
}
