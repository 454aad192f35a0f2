#include "AbsoluteCurvature.h"

#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
using Complex = std::complex<double>;

/// A symmetric tensor T/2 I + the one with the eigenvalues ±|D| and the larger one in half the direction of D, times
/// an area.
struct Bending
{
  double trace = 0.0;
  Complex deviator = 0.0; ///< In the chart of a triangle.
  double area = 0.0;

  void Add(const Bending& other, double turn)
  {
    this->trace += other.trace;
    this->deviator += other.deviator * std::polar(1.0, 2.0 * turn);
    this->area += other.area;
  }
};

Bending BendingOf(const MeshTopology& topology, int triangle)
{
  const SpacePoint normal = topology.NormalOf(triangle);
  const auto& v = topology.mesh.triangles[Index(triangle)];
  Bending bending;
  for (int side = 0; side < 3; ++side)
  {
    const int neighbour = topology.Neighbour(triangle, side);
    if (neighbour < 0)
    {
      continue;
    }
    // A side of the boundary has no angle, and its third of the area does not count.
    bending.area += topology.AreaOf(triangle) / 3.0;
    const SpacePoint edge =
      topology.PositionOf(v[Index((side + 1) % 3)]) - topology.PositionOf(v[Index(side)]);
    const SpacePoint other = topology.NormalOf(neighbour);
    const double angle = std::atan2(normal.cross(other).dot(edge), edge.norm() * normal.dot(other));
    const double part = 0.5 * angle * edge.norm(); // the other half is of the neighbour
    bending.trace += part;
    bending.deviator -= 0.5 * part * std::polar(1.0, 2.0 * topology.DirectionOf(triangle, side));
  }
  return bending;
}
}

Eigen::VectorXd AbsoluteCurvature(const MeshTopology& topology)
{
  // Each takes in one more ring of neighbours. A single triangle may have all or nothing of the curvature of its
  // surroundings; six rings have about a hundred.
  constexpr int Sweeps = 6;
  std::vector<Bending> bending;
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    bending.push_back(BendingOf(topology, t));
  }
  for (int sweep = 0; sweep < Sweeps; ++sweep)
  {
    std::vector<Bending> sums = bending;
    for (int t = 0; t < topology.TriangleCount(); ++t)
    {
      for (int side = 0; side < 3; ++side)
      {
        const int neighbour = topology.Neighbour(t, side);
        if (neighbour >= 0)
        {
          sums[Index(t)].Add(bending[Index(neighbour)], -topology.Hinge(t, side));
        }
      }
    }
    // Means, so that areas do not grow.
    for (Bending& sum : sums)
    {
      sum.trace *= 0.25;
      sum.deviator *= 0.25;
      sum.area *= 0.25;
    }
    bending = std::move(sums);
  }
  const Eigen::Index vertices = topology.VertexCount();
  Eigen::VectorXd curvature = Eigen::VectorXd::Zero(vertices);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(vertices);
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const Bending& one = bending[Index(t)];
    const double absolute = std::max(std::abs(one.trace), 2.0 * std::abs(one.deviator));
    for (const int vertex : topology.mesh.triangles[Index(t)])
    {
      curvature[vertex] += absolute;
      areas[vertex] += one.area;
    }
  }
  return (areas.array() > 0.0).select(curvature.array() / areas.array(), 0.0);
}
}
