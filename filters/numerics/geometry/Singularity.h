#pragma once

#include "Plane.h"

namespace crossfield
{
/// Prescribed singularity of index quarterIndex / 4. +1 becomes a node of valence 3 of the quad
/// mesh, −1 one of valence 5 (docs/method.md §1.2).
struct Singularity
{
  Point position = Point::Zero();
  int quarterIndex = 1;
  double radius = 0.0; ///< Radius of its hole; 0 if not given.
};

using Configuration = std::vector<Singularity>;

/// Returns the sum of the quarter indices.
inline int TotalQuarters(const Configuration& configuration)
{
  int sum = 0;
  for (const Singularity& singularity : configuration)
  {
    sum += singularity.quarterIndex;
  }
  return sum;
}
}
