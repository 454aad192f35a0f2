#include "MetricCases.h"

#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
int NearestQuarters(double angle)
{
  return static_cast<int>(std::lround(angle / (0.5 * Pi)));
}

/// Returns whether the quadrilateral of the two triangles at a side is convex, in the metric and in
/// the plane.
bool IsConvex(const ConeMetric& metric, ConeMetric::Side side)
{
  constexpr double Margin = 0.05;
  const ConeMetric::Side across = metric.Across(side);
  const auto one = metric.AnglesOf(side.triangle).angle;
  const auto two = metric.AnglesOf(across.triangle).angle;
  for (const int end : { 0, 1 })
  {
    const int here = (side.side + end) % 3;
    const int there = (across.side + 1 - end) % 3;
    const double inMetric =
      one[static_cast<std::size_t>(here)] + two[static_cast<std::size_t>(there)];
    const double inPlane =
      metric.AngleOnSurface(side.triangle, here) + metric.AngleOnSurface(across.triangle, there);
    if (std::max(inMetric, inPlane) > Pi - Margin)
    {
      return false;
    }
  }
  return true;
}
}

SharedPlanarTopology SquareFrame(double turn, double meshSize)
{
  const Loop square = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } };
  const PlanarDomain domain =
    MakePlanarDomain({ square, Similarity{ turn, 0.5, Point::Zero() }(square) });
  return ShareTopology(MeshForPoints(domain, {}, meshSize));
}

ConeMetric PlaneMetric(const PlanarTopology& topology)
{
  std::vector<std::array<int, 3>> jumps(topology.mesh.triangles.size(), { 0, 0, 0 });
  std::vector<Cone> cones;
  for (int i = 0; i < static_cast<int>(topology.mesh.boundary.size()); ++i)
  {
    const int edge = topology.EdgeOfBoundary(i);
    const auto t =
      static_cast<std::size_t>(topology.edges.triangles[static_cast<std::size_t>(edge)][0]);
    const auto& [from, to] = topology.BoundaryAt(i).vertices;
    for (std::size_t side = 0; side < 3; ++side)
    {
      if (topology.edges.ofTriangle[t][side] == edge)
      {
        jumps[t][side] = NearestQuarters(
          AngleBetween({ 1.0, 0.0 }, topology.PointAt(to) - topology.PointAt(from)));
      }
    }
    if (const int quarters = NearestQuarters(topology.turning[i]); quarters != 0)
    {
      cones.push_back({ from, quarters, true, -1 });
    }
  }
  return { topology, jumps, cones };
}

void Perturb(Random& random, double size, ConeMetric& metric)
{
  std::vector<double> logs = metric.LogLengths();
  for (double& log : logs)
  {
    log += random.Uniform(-size, size);
  }
  metric.SetLogLengths(std::move(logs));
}

int ChangeAtRandom(Random& random, int count, ConeMetric& metric)
{
  int flips = 0;
  for (int i = 0; i < count; ++i)
  {
    const ConeMetric::Side side = {
      random.Integer(0, static_cast<int>(metric.Triangles().size()) - 1), random.Integer(0, 2)
    };
    const int neighbour = metric.Triangles()[static_cast<std::size_t>(side.triangle)]
                            .neighbours[static_cast<std::size_t>(side.side)];
    if (neighbour < 0 || i % 8 == 0)
    {
      metric.Split(side, random.Uniform(0.3, 0.7));
    }
    else if (IsConvex(metric, side))
    {
      metric.Flip(side);
      ++flips;
    }
  }
  return flips;
}

Eigen::VectorXd RandomNumbers(Random& random, std::size_t count)
{
  return Eigen::VectorXd::NullaryExpr(
    static_cast<Eigen::Index>(count), [&random] { return random.Uniform(-1.0, 1.0); });
}
}
