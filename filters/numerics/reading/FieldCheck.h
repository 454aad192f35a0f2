#pragma once

#include "FieldReading.h"

namespace crossfield
{
/// What a solved field says about the generalised Poincaré-Hopf theorem.
struct FieldCheck
{
  /// Counted with the indices that the field takes at corners and other vertices of the boundary;
  /// given: degrees of the holes and indices inside. The two sums agree for every field.
  PoincareHopfCount count;
  std::vector<HoleReading> holes;     ///< In the order of the configuration.
  std::vector<int> prescribedDegrees; ///< Likewise; empty where the field chose by itself.
  int interiorQuarters = 0; ///< Sum of the indices of triangles and of vertices inside or on holes.
  /// As solvers count them (UnwantedSingularities.h).
  int unwantedSingularities = 0;
  /// Degrees and chosen corners are as prescribed, and there are no unwanted singularities.
  bool asPrescribed = false;
  std::string reason; ///< One sentence.
};

/// Reads degrees of holes, interior indices and the indices of corners from a field; `choices` are the
/// quarter indices that it was asked to take, `points` its singularities that are not holes; `byItself` as in
/// FieldRequest. Throws Error when it has a value that is not finite, or is not aligned with the boundary.
FieldCheck CheckField(const CrossField& field, const std::vector<CornerChoice>& choices = {},
  const Configuration& points = {}, bool byItself = false);
}
