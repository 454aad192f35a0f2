#include "TriangleBending.h"

#include "Index.h"

#include <Eigen/Geometry>

#include <cmath>

namespace crossfield
{
TriangleBending BendingOf(const MeshTopology& topology, int triangle)
{
  const SpacePoint normal = topology.NormalOf(triangle);
  const auto& v = topology.mesh.triangles[Index(triangle)];
  TriangleBending bending;
  for (int side = 0; side < 3; ++side)
  {
    const int neighbour = topology.Neighbour(triangle, side);
    if (neighbour < 0)
    {
      continue;
    }
    const SpacePoint edge =
      topology.PositionOf(v[Index((side + 1) % 3)]) - topology.PositionOf(v[Index(side)]);
    const SpacePoint other = topology.NormalOf(neighbour);
    const double part =
      std::atan2(normal.cross(other).dot(edge), edge.norm() * normal.dot(other)) * edge.norm();
    bending.directed += part * std::polar(1.0, 2.0 * topology.DirectionOf(triangle, side));
    bending.sum += part;
    bending.absolute += std::abs(part);
    ++bending.sides;
  }
  return bending;
}
}
