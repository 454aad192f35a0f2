#pragma once

#include "QuadMesh.h"

#include <vector>

namespace crossfield
{
/// The corners of quads at each point of a mesh. Corner c of quad q has number 4 q + c.
class PointCorners
{
public:
  explicit PointCorners(const QuadMesh& mesh);

  /// The corners of point p are Get(i) for i from Begin(p) to Begin(p + 1) − 1, in increasing order.
  int Begin(int p) const { return this->First[p]; }
  int Get(int i) const { return this->Corners[i]; }

private:
  std::vector<int> First;
  std::vector<int> Corners;
};
}
