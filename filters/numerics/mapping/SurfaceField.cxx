#include "SurfaceField.h"

#include "BestAngle.h"
#include "SurfaceFrames.h"
#include "TargetSolve.h"

#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the angle by which frames are turned against the crosses of a map.
double TurnOf(const SeamlessMap& map, const TriangleFrames& frames)
{
  std::complex<double> sum = 0.0;
  for (int t = 0; t < map.topology->TriangleCount(); ++t)
  {
    sum += map.topology->AreaOf(t) * CrossOf(map, t) * std::polar(1.0, -4.0 * frames.angle[t]);
  }
  return 0.25 * std::arg(sum);
}

/// Returns the direction in space of a direction in the chart of a triangle.
SpacePoint DirectionInSpace(const MeshTopology& topology, int triangle, const Point& direction)
{
  const auto& v = topology.mesh.triangles[triangle];
  Eigen::Matrix<double, 3, 2> sides;
  sides << topology.PositionOf(v[1]) - topology.PositionOf(v[0]),
    topology.PositionOf(v[2]) - topology.PositionOf(v[0]);
  Eigen::Matrix2d inChart;
  inChart << topology.At(triangle, 1) - topology.At(triangle, 0),
    topology.At(triangle, 2) - topology.At(triangle, 0);
  return sides * (inChart.inverse() * direction);
}

/// Returns H at the vertices, with mean 0 over the area.
Eigen::VectorXd WithoutMean(const MeshTopology& topology, Eigen::VectorXd h)
{
  double sum = 0.0;
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const auto& v = topology.mesh.triangles[t];
    sum += topology.AreaOf(t) * (h[v[0]] + h[v[1]] + h[v[2]]) / 3.0;
  }
  h.array() -= sum / topology.Area();
  return h;
}
}

SurfaceField SolveSurfaceField(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress)
{
  SurfaceFrames solved = SolveSurfaceFrames(topology, cones, progress.Part(0.0, 0.5));
  const TriangleFrames& frames = solved.frames;
  double turn = 0.0;
  if (topology->loops.empty())
  {
    const SeamlessMap map =
      SolveTargets({ topology, frames.jump, TargetGradients(*topology, frames) }, cones,
        progress.Part(0.5, 1.0));
    turn = TurnOf(map, frames);
  }
  SurfaceField field;
  field.h = WithoutMean(*topology, std::move(solved.h));
  field.angle = (frames.angle.array() + turn).matrix();
  for (int t = 0; t < topology->TriangleCount(); ++t)
  {
    field.cross.push_back(
      DirectionInSpace(*topology, t, { std::cos(field.angle[t]), std::sin(field.angle[t]) }));
  }
  field.holonomyDefect = std::move(solved.holonomyDefect);
  progress.Report(1.0);
  return field;
}
}
