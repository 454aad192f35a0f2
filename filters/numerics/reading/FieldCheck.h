#pragma once

#include "FieldReading.h"

namespace crossfield
{
/// Result of checking a field against the generalised Poincaré-Hopf theorem.
struct FieldCheck
{
  /// Count with the indices that the field has at corners and other vertices of the boundary. Its
  /// given sum consists of the degrees of the holes and the indices inside. The two sums agree for
  /// every field.
  PoincareHopfCount count;
  std::vector<HoleReading> holes; ///< Holes in the order of the configuration.
  /// In the same order; empty if the field chose its singularities itself.
  std::vector<int> prescribedDegrees;
  int interiorQuarters = 0; ///< Sum of the indices of triangles and of vertices inside or on holes.
  /// As counted by the solvers (UnwantedSingularities.h).
  int unwantedSingularities = 0;
  /// Whether degrees and chosen corners are as prescribed, and there are no unwanted singularities.
  bool asPrescribed = false;
  std::string reason; ///< The result in one sentence.
};

/// Reads the degrees of holes, interior indices and indices of corners from a field. `choices` are
/// the prescribed quarter indices of corners, `points` the prescribed singularities that are not
/// holes; `byItself` as in FieldRequest. Throws Error when the field has a value that is not
/// finite, or is not aligned with the boundary.
FieldCheck CheckField(const CrossField& field, const std::vector<CornerChoice>& choices = {},
  const Configuration& points = {}, bool byItself = false);
}
