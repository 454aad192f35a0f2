#include "AbsoluteCurvature.h"

#include "Index.h"
#include "TriangleBending.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// The tensor T/2 I + D times an area: D has the eigenvalues ±|D|, the larger one along half the argument of D.
struct Bending
{
  double trace = 0.0;
  std::complex<double> deviator = 0.0; ///< In the chart of a triangle.
  double area = 0.0;

  void Add(const Bending& other, double turn)
  {
    this->trace += other.trace;
    this->deviator += other.deviator * std::polar(1.0, 2.0 * turn);
    this->area += other.area;
  }
};

Bending TensorOf(const MeshTopology& topology, int triangle)
{
  const TriangleBending sides = BendingOf(topology, triangle);
  // The other half of each side is its neighbour's. A side of the boundary has no angle, and its third of the area does
  // not count.
  return { 0.5 * sides.sum, -0.25 * sides.directed, topology.AreaOf(triangle) * sides.sides / 3.0 };
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
    bending.push_back(TensorOf(topology, t));
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
