#include "LoopAlignment.h"

#include "Cycle.h"
#include "TriangleSearch.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
using Side = ConeMetric::Side;

/// Returns, per triangle, the side through which a breadth-first search from a triangle reached it:
/// a side of the triangle before it on the path.
std::vector<Side> SearchFrom(const ConeMetric& metric, int start)
{
  std::vector<Side> reached(metric.Triangles().size());
  SearchTriangles(
    static_cast<int>(reached.size()), { start },
    [&metric](int t, int side) { return metric.Triangles()[t].neighbours[side]; },
    [&reached](int t, int side, int next) {
      reached[next] = { t, side };
    });
  return reached;
}

/// Follows the direction of directed sides through triangles.
class DirectionWalk
{
public:
  explicit DirectionWalk(const MetricDerivatives& derivatives)
    : Derivatives(derivatives)
  {
  }

  /// Adds the turn from one side of a triangle to another.
  void Turn(int triangle, int from, int to)
  {
    if (from == to)
    {
      return;
    }
    // Between consecutive sides the direction turns by π minus the angle at their common vertex.
    const bool forward = to == NextSide(from);
    const int corner = forward ? to : from;
    const double sign = forward ? 1.0 : -1.0;
    this->Direction += sign * (Pi - this->Derivatives.AnglesOf(triangle).angle[corner]);
    for (const auto& [edge, value] : this->Derivatives.AngleDerivative(triangle, corner))
    {
      this->Row.emplace_back(edge, -sign * value);
    }
  }
  /// Adds the change of chart across a side.
  void Cross(const Side& side)
  {
    const auto& triangle = this->Derivatives.GetMetric().Triangles()[side.triangle];
    this->Direction += Pi + 0.5 * Pi * triangle.jumps[side.side];
  }

  double Direction = 0.0;
  std::vector<MetricDerivatives::Term> Row;

private:
  const MetricDerivatives& Derivatives;
};

/// Returns 2g closed strips of triangles that generate the cycles of handles.
std::vector<Cycle> FindHandles(const ConeMetric& metric)
{
  // χ = 2 − 2g − b, with as many corners as sides
  const auto loops = static_cast<int>(metric.LoopStarts().size());
  const int characteristic = static_cast<int>(metric.Points().size()) -
    static_cast<int>(metric.LogLengths().size()) + static_cast<int>(metric.Triangles().size());
  if (characteristic + loops == 2)
  {
    return {};
  }
  const TriangleMesh mesh = metric.Triangulation();
  std::vector<Cycle> cycles = FindCycles(mesh, NumberEdges(mesh), FindBoundaryLoops(mesh));
  cycles.erase(std::remove_if(cycles.begin(), cycles.end(),
                 [](const Cycle& cycle) { return !cycle.IsClosed(); }),
    cycles.end());
  return cycles;
}
}

LoopAlignment MeasureAlignment(const MetricDerivatives& derivatives)
{
  const ConeMetric& metric = derivatives.GetMetric();
  LoopAlignment alignment;
  std::vector<double> defects;
  const auto add = [&](DirectionWalk& walk, double prescribed)
  {
    defects.push_back(WrapAngle(walk.Direction - prescribed));
    alignment.rows.push_back(std::move(walk.Row));
  };
  const std::vector<int>& starts = metric.LoopStarts();
  if (starts.size() > 1)
  {
    const auto directionOf = [&metric](const Side& side)
    { return 0.5 * Pi * metric.Triangles()[side.triangle].jumps[side.side]; };
    const Side outer = metric.AtBoundary(starts.front());
    const std::vector<Side> reached = SearchFrom(metric, outer.triangle);
    for (std::size_t loop = 1; loop < starts.size(); ++loop)
    {
      const Side inner = metric.AtBoundary(starts[loop]);
      std::vector<Side> crossed;
      for (int t = inner.triangle; t != outer.triangle; t = crossed.back().triangle)
      {
        crossed.push_back(reached[t]);
      }
      DirectionWalk walk(derivatives);
      walk.Direction = directionOf(outer);
      Side here = outer;
      for (auto side = crossed.rbegin(); side != crossed.rend(); ++side)
      {
        walk.Turn(here.triangle, here.side, side->side);
        walk.Cross(*side);
        here = metric.Across(*side);
      }
      walk.Turn(here.triangle, here.side, inner.side);
      add(walk, directionOf(inner));
    }
    alignment.innerLoops = static_cast<int>(starts.size()) - 1;
  }
  for (const Cycle& cycle : FindHandles(metric))
  {
    DirectionWalk walk(derivatives);
    for (const Cycle::Step& step : cycle.steps)
    {
      walk.Turn(step.triangle, step.entry, step.exit);
      walk.Cross({ step.triangle, step.exit });
    }
    add(walk, 0.0);
  }
  alignment.defects =
    Eigen::Map<Eigen::VectorXd>(defects.data(), static_cast<Eigen::Index>(defects.size()));
  return alignment;
}

Eigen::VectorXd LoopAlignment::Changes(const Eigen::VectorXd& edges) const
{
  Eigen::VectorXd changes = Eigen::VectorXd::Zero(this->defects.size());
  for (std::size_t j = 0; j < this->rows.size(); ++j)
  {
    for (const auto& [edge, value] : this->rows[j])
    {
      changes[static_cast<Eigen::Index>(j)] += value * edges[edge];
    }
  }
  return changes;
}
}
