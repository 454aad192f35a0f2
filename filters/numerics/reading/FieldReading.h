#pragma once

#include "FieldIndices.h"
#include "PoincareHopf.h"

namespace crossfield
{
/// What a field on a mesh shows, whoever computed it (docs/method.md §8).
struct FieldReading
{
  /// What its boundary asks of it.
  PoincareHopfCount count;
  /// Of holes, then imprinted circles, in the order of the configuration.
  std::vector<HoleReading> holes;
  int wrongDegrees = 0; ///< Holes whose degree is not the prescribed one.
  bool degreesReached =
    true; ///< None is wrong, or their sum is right where only that was asked for.
  int unwantedSingularities = 0; ///< See UnwantedSingularities.h.
};

/// What was asked of a field beside what its mesh says.
struct FieldRequest
{
  PoincareHopfCount count; ///< With the chosen corners.
  Configuration points;    ///< Singularities that are points.
  bool onlyTheSum = false; ///< Only the sum of the degrees of all holes was prescribed.
  /// The field chose its singularities by itself: imprinted circles ask for nothing.
  bool byItself = false;
};

/// Where neither holes, circles nor points say where singularities are wanted, as many quarters as the
/// boundary leaves to the inside are wanted anywhere. Throws Error if the indices of the field do not
/// add up to 4χ, which a field aligned with the boundary cannot do unless it vanishes on an edge.
FieldReading ReadField(const CrossField& field, const FieldRequest& question);
}
