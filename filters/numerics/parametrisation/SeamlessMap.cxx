#include "SeamlessMap.h"

#include "Error.h"
#include "TriangleWalk.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdlib>

namespace crossfield
{
void RequireAngle(const Cone& cone, const std::string& where)
{
  const std::string index = " has quarter index " + std::to_string(cone.quarterIndex);
  if (cone.onBoundary && cone.quarterIndex > 1)
  {
    throw Error("The corner at " + where + index +
      " and so no angle in a seamless map; cap corners, or choose index 1 for it, and add the "
      "difference to the singularities inside.");
  }
  if (!cone.onBoundary && cone.quarterIndex > 2)
  {
    throw Error("The singularity at " + where + index +
      ", which no node of a quad mesh has; split it into several of index 1.");
  }
}

std::vector<int> QuartersOfVertices(const MeshTopology& topology, const std::vector<Cone>& cones)
{
  std::vector<int> quarters(static_cast<std::size_t>(topology.VertexCount()), 0);
  for (const Cone& cone : cones)
  {
    quarters[cone.vertex] += cone.quarterIndex;
  }
  return quarters;
}

SeamTransition SeamlessMap::Across(int triangle, int side) const
{
  const int seam = this->seams[triangle][side];
  if (seam == 0)
  {
    return {};
  }
  const SeamTransition& transition = this->transitions[std::abs(seam) - 1];
  return seam > 0 ? transition : transition.Inverse();
}

SpacePoint SeamlessMap::PlaceOf(int triangle, const Point& w) const
{
  const std::array<double, 3> weights =
    WeightsAt({ this->At(triangle, 0), this->At(triangle, 1), this->At(triangle, 2) }, w);
  SpacePoint place = SpacePoint::Zero();
  for (std::size_t i = 0; i < 3; ++i)
  {
    place += weights[i] * this->topology->PositionOf(this->topology->mesh.triangles[triangle][i]);
  }
  return place;
}

double SeamlessMap::Extent() const
{
  Eigen::AlignedBox2d box;
  for (const Point& w : this->points)
  {
    box.extend(w);
  }
  return box.diagonal().norm();
}
}
