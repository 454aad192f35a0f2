#include "MapTargets.h"

#include "PlanarTopology.h"
#include "SurfaceTopology.h"
#include "TriangleSearch.h"

#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the direction of side 0 of every triangle in its chart, continued breadth-first from the
/// outer loop.
std::vector<double> DirectionsOfSides(const ConeMetric& metric)
{
  const auto& triangles = metric.Triangles();
  std::vector<double> directions(triangles.size());
  // Direction of a side relative to side 0.
  const auto relative = [&metric](int t, int side)
  {
    const auto angles = metric.AnglesOf(t).angle;
    return side == 0 ? 0.0 : side == 1 ? Pi - angles[1] : angles[0] - Pi;
  };
  const auto set = [&](const ConeMetric::Side& side, double direction)
  { directions[side.triangle] = WrapAngle(direction - relative(side.triangle, side.side)); };
  ConeMetric::Side start = { 0, 0 };
  if (metric.LoopStarts().empty())
  {
    set(start, 0.0); // the angle of a map of a closed surface is free
  }
  else
  {
    start = metric.AtBoundary(metric.LoopStarts().front());
    set(start, 0.5 * Pi * triangles[start.triangle].jumps[start.side]);
  }
  SearchTriangles(
    static_cast<int>(triangles.size()), { start.triangle },
    [&](int t, int side) { return triangles[t].neighbours[side]; },
    [&](int t, int side, int)
    {
      set(metric.Across({ t, side }),
        directions[t] + relative(t, side) + Pi + 0.5 * Pi * triangles[t].jumps[side]);
    });
  return directions;
}
}

MapTargets LayOut(const ConeMetric& metric)
{
  MapTargets result;
  TriangleMesh mesh = metric.Triangulation();
  if (metric.IsInPlane())
  {
    result.topology = ShareTopology(std::move(mesh));
  }
  else
  {
    result.topology = std::make_shared<const SurfaceTopology>(
      SurfaceMesh{ metric.Points(), std::move(mesh.triangles) });
  }
  const std::vector<double> directions = DirectionsOfSides(metric);
  for (int t = 0; t < static_cast<int>(metric.Triangles().size()); ++t)
  {
    const ConeMetric::Triangle& triangle = metric.Triangles()[t];
    result.jumps.push_back(triangle.jumps);
    const double direction = directions[t];
    const double toThird = direction + metric.AnglesOf(t).angle[0];
    Eigen::Matrix<double, 3, 2> corners = Eigen::Matrix<double, 3, 2>::Zero();
    corners.row(1) = metric.Length(triangle.edges[0]) *
      Point(std::cos(direction), std::sin(direction)).transpose();
    corners.row(2) =
      metric.Length(triangle.edges[2]) * Point(std::cos(toThird), std::sin(toThird)).transpose();
    result.poisson.target.push_back(corners);
    result.poisson.weights.push_back(result.topology->AreaOf(t) / metric.AreaOf(t));
  }
  LimitWeights(result.poisson.weights);
  return result;
}
}
