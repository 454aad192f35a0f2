#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// How good a mesh is: first by the number of inverted quads, then by the minimum scaled Jacobian.
struct QuadRank
{
  int inverted = 0;
  double minimum = 1.0;

  bool IsBetterThan(const QuadRank& other) const
  {
    return this->inverted != other.inverted ? this->inverted < other.inverted
                                            : this->minimum > other.minimum;
  }
};

/// Returns the rank of a mesh.
QuadRank RankOf(const QuadMesh& mesh);
}
