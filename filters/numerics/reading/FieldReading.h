#pragma once

#include "FieldIndices.h"
#include "PoincareHopf.h"

namespace crossfield
{
/// Properties of a field on a mesh, independent of the method that computed it (docs/method.md §8).
struct FieldReading
{
  /// Poincaré-Hopf count, which follows from the boundary.
  PoincareHopfCount count;
  /// Holes, then imprinted circles, in the order of the configuration.
  std::vector<HoleReading> holes;
  int wrongDegrees = 0; ///< Number of holes whose degree is not the prescribed one.
  bool degreesReached =
    /// Whether all degrees are as prescribed, or their sum is where only the sum was prescribed.
    true;
  int unwantedSingularities = 0; ///< See UnwantedSingularities.h.
};

/// Prescribed properties of a field in addition to those given by its mesh.
struct FieldRequest
{
  PoincareHopfCount count; ///< Count with the chosen corners.
  Configuration points;    ///< Prescribed singularities that are points.
  bool onlyTheSum = false; ///< Whether only the sum of the degrees of all holes was prescribed.
  /// Whether the field chose its singularities itself; imprinted circles then prescribe nothing.
  bool byItself = false;
};

/// Reads a field. Where neither holes, circles nor points prescribe singularities, as many quarters
/// as the boundary leaves to the interior are expected anywhere. Throws Error if the indices of the
/// field do not add up to 4χ, which is impossible for a field aligned with the boundary unless it
/// vanishes on an edge.
FieldReading ReadField(const CrossField& field, const FieldRequest& request);
}
