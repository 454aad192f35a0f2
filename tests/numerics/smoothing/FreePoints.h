#pragma once

#include "QuadMesh.h"

#include <vector>

namespace crossfield::test
{
/// Returns for each point whether it may move.
inline std::vector<bool> AllButFixed(const QuadMesh& mesh)
{
  std::vector<bool> moves;
  for (const QuadPoint& point : mesh.points)
  {
    moves.push_back(!point.fixed);
  }
  return moves;
}
}
