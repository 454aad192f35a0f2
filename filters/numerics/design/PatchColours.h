#pragma once

#include "TMesh.h"

namespace crossfield
{
/// Number of colours of patches.
constexpr int PatchColourCount = 5;

/// Colour of a patch, and its size and place, by which it is recognised after a move.
struct PatchColour
{
  int colour = 0; ///< From 0 to PatchColourCount − 1.
  SpacePoint centre = SpacePoint::Zero();
  double area = 0.0;
};

/// Chooses a colour for each patch of a T-mesh. A patch keeps the colour of the earlier patch that
/// it continues: their centres are closer than half the side of a square of the area of either, and
/// the larger area is at most three times the smaller one; among several the nearest. Other patches
/// take the colour that the fewest of their neighbours have.
std::vector<PatchColour> ColourPatches(
  const TMesh& mesh, const std::vector<PatchColour>& earlier = {});
}
