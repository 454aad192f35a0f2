#include "SurfaceIndices.h"

#include "Error.h"
#include "UnionFind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace crossfield
{
namespace
{
/// Joins the indices of vertices inside that edges connect to the one with the largest index: singularities of a
/// field are found up to a triangle.
void JoinNeighbours(const MeshTopology& topology, std::vector<int>& quarters)
{
  std::vector<bool> isInside(quarters.size(), true);
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    isInside[edge.vertices[0]] = false;
  }
  const auto isSingular = [&](int vertex) { return isInside[vertex] && quarters[vertex] != 0; };
  UnionFind groups(quarters.size());
  for (const auto& [from, to] : topology.edges.vertices)
  {
    if (isSingular(from) && isSingular(to))
    {
      groups.Join(from, to);
    }
  }
  std::vector<int> sums(quarters.size(), 0);
  std::vector<int> largest(quarters.size(), -1);
  for (int vertex = 0; vertex < static_cast<int>(quarters.size()); ++vertex)
  {
    if (isSingular(vertex))
    {
      const int group = groups.Find(vertex);
      sums[group] += quarters[vertex];
      int& best = largest[group];
      best = best < 0 || std::abs(quarters[vertex]) > std::abs(quarters[best]) ? vertex : best;
    }
  }
  for (int vertex = 0; vertex < static_cast<int>(quarters.size()); ++vertex)
  {
    quarters[vertex] = isInside[vertex] ? 0 : quarters[vertex];
  }
  for (std::size_t group = 0; group < largest.size(); ++group)
  {
    if (largest[group] >= 0)
    {
      quarters[largest[group]] = sums[group];
    }
  }
}
}

std::vector<int> ReadSurfaceIndices(const MeshTopology& topology, const Eigen::VectorXd& angle)
{
  Eigen::VectorXd around = Eigen::VectorXd::Zero(topology.VertexCount());
  for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
  {
    around[vertex] = 4.0 * topology.CurvatureAt(vertex);
  }
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    for (int side = 0; side < 3; ++side)
    {
      const int other = topology.Neighbour(t, side);
      if (other >= 0)
      {
        // The path leaves the triangle counter-clockwise around the end of the side.
        around[topology.mesh.triangles[t][(side + 1) % 3]] +=
          WrapAngle(4.0 * (angle[other] - angle[t] - topology.Hinge(t, side)));
      }
    }
  }
  for (int i = 0; i < static_cast<int>(topology.mesh.boundary.size()); ++i)
  {
    const auto [t, side] = topology.SideOfBoundary(i);
    const double step = WrapAngle(4.0 * (angle[t] - topology.DirectionOf(t, side)));
    const auto& [from, to] = topology.BoundaryAt(i).vertices;
    around[from] += step + 4.0 * topology.turning[i];
    around[to] -= step;
  }
  std::vector<int> quarters;
  for (const double turn : around)
  {
    quarters.push_back(static_cast<int>(std::lround(turn / (2.0 * Pi))));
  }
  return quarters;
}

std::vector<VertexSingularity> FindSurfaceSingularities(
  const MeshTopology& topology, const Eigen::VectorXd& angle, bool includesCorners)
{
  std::vector<int> quarters = ReadSurfaceIndices(topology, angle);
  JoinNeighbours(topology, quarters);
  std::vector<int> loopAt(quarters.size(), -1);
  for (std::size_t loop = 0; loop < topology.loops.size(); ++loop)
  {
    for (const int position : topology.loops[loop].edges)
    {
      loopAt[topology.BoundaryAt(position).vertices[0]] = static_cast<int>(loop);
    }
  }
  std::vector<VertexSingularity> singularities;
  for (const bool isInside : { true, false })
  {
    for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
    {
      const bool isLeftOut = topology.corners[vertex] && !includesCorners;
      if (quarters[vertex] != 0 && (loopAt[vertex] < 0) == isInside && !isLeftOut)
      {
        singularities.push_back({ vertex, quarters[vertex], loopAt[vertex] });
      }
    }
  }
  return singularities;
}

int CountUnwanted(
  const MeshTopology& topology, const Eigen::VectorXd& angle, const std::vector<int>& quarters)
{
  std::vector<int> difference = ReadSurfaceIndices(topology, angle);
  for (std::size_t vertex = 0; vertex < difference.size(); ++vertex)
  {
    difference[vertex] -= quarters[vertex];
  }
  JoinNeighbours(topology, difference);
  return static_cast<int>(difference.size()) -
    static_cast<int>(std::count(difference.begin(), difference.end(), 0));
}

Eigen::VectorXd AnglesInCharts(
  const MeshTopology& topology, const std::vector<SpacePoint>& directions)
{
  Eigen::VectorXd angle(topology.TriangleCount());
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const auto& v = topology.mesh.triangles[t];
    const SpacePoint side = topology.PositionOf(v[1]) - topology.PositionOf(v[0]);
    const Point along(directions[t].dot(side), directions[t].dot(topology.NormalOf(t).cross(side)));
    if (!(along.norm() > 0.0))
    {
      throw Error("The cross on the triangle at " + topology.Where(v[0]) +
        " has no direction along it; correct it.");
    }
    angle[t] = std::atan2(along.y(), along.x()) + topology.DirectionOf(t, 0);
  }
  return angle;
}
}
