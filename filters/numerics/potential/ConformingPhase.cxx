#include "ConformingPhase.h"

#include <algorithm>
#include <array>

namespace crossfield
{
ConformingPhase::Steps::Steps(const PotentialOperator& laplacian)
{
  const std::vector<LoopStrip>& strips = laplacian.GetStrips();
  for (std::size_t k = 0; k < strips.size(); ++k)
  {
    for (const LoopStrip::Step& step : strips[k].steps)
    {
      this->OfTriangle[step.triangle].push_back({ static_cast<Eigen::Index>(k), &step });
    }
  }
}

ConformingPhase::ConformingPhase(
  const PotentialOperator& laplacian, const Steps& steps, const Eigen::VectorXd& growth)
  : Laplacian(laplacian)
  , StepsOf(steps)
  , Value(Eigen::VectorXd::Zero(laplacian.Rows()))
{
  this->SetPeriods(growth);
  for (const BoundaryLoop& loop : laplacian.GetTopology().loops)
  {
    if (loop.kind != BoundaryKind::Hole)
    {
      this->SetLoop(loop, growth);
    }
  }
}

void ConformingPhase::ShiftInnerLoops(const Eigen::VectorXd& differences)
{
  const PlanarTopology& topology = this->Laplacian.GetTopology();
  Eigen::Index k = 0;
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind == BoundaryKind::Inner)
    {
      const double shift = -differences[k] - this->Transport(k);
      ++k;
      for (int edge : loop.edges)
      {
        this->Value[topology.BoundaryAt(edge).vertices[0]] += shift;
      }
    }
  }
}

void ConformingPhase::SetPeriods(const Eigen::VectorXd& growth)
{
  Eigen::Index k = 0;
  for (const BoundaryLoop& loop : this->Laplacian.GetTopology().loops)
  {
    if (loop.kind == BoundaryKind::Outer)
    {
      continue;
    }
    double& period = this->Value[this->Laplacian.PeriodRow(k)];
    ++k;
    if (loop.kind == BoundaryKind::Hole)
    {
      period = -2.0 * Pi * loop.quarterIndex;
      continue;
    }
    for (int edge : loop.edges)
    {
      period += growth[edge]; // edges of inner loops are clockwise
    }
  }
}

double ConformingPhase::Jump(int triangle, int vertex) const
{
  const auto found = this->StepsOf.OfTriangle.find(triangle);
  double jump = 0.0;
  if (found != this->StepsOf.OfTriangle.end())
  {
    const auto& v =
      this->Laplacian.GetTopology().mesh.triangles[static_cast<std::size_t>(triangle)];
    const auto i = static_cast<std::size_t>(std::find(v.begin(), v.end(), vertex) - v.begin());
    for (const auto& [k, step] : found->second)
    {
      jump += this->Value[this->Laplacian.PeriodRow(k)] * step->left[i];
    }
  }
  return jump;
}

void ConformingPhase::SetLoop(const BoundaryLoop& loop, const Eigen::VectorXd& growth)
{
  const PlanarTopology& topology = this->Laplacian.GetTopology();
  std::vector<int> along = loop.edges;
  if (loop.kind == BoundaryKind::Inner)
  {
    std::reverse(along.begin(), along.end());
  }
  for (std::size_t i = 0; i + 1 < along.size(); ++i)
  {
    const auto [from, to] = topology.BoundaryAt(along[i]).vertices;
    const int edge = topology.EdgeOfBoundary(along[i]);
    const int triangle = topology.edges.triangles[static_cast<std::size_t>(edge)][0];
    this->Value[to] =
      this->Value[from] + growth[along[i]] - this->Jump(triangle, to) + this->Jump(triangle, from);
  }
}

double ConformingPhase::Transport(Eigen::Index k) const
{
  const PlanarTopology& topology = this->Laplacian.GetTopology();
  const LoopStrip& strip = this->Laplacian.GetStrips()[static_cast<std::size_t>(k)];
  std::array<int, 2> side = topology.BoundaryAt(strip.firstBoundaryEdge).vertices;
  double sum = 0.0;
  for (const LoopStrip::Step& step : strip.steps)
  {
    const auto& v = topology.mesh.triangles[static_cast<std::size_t>(step.triangle)];
    const auto at = [&](int vertex)
    { return this->Value[vertex] + this->Jump(step.triangle, vertex); };
    // The strip leaves the triangle by the other side with one end on the left and one on the
    // right.
    const auto isLeft = [&](std::size_t i) { return step.left[i] > 0.5; };
    std::array<int, 2> out = side;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::array<int, 2> candidate = { v[i], v[(i + 1) % 3] };
      const bool same = std::is_permutation(candidate.begin(), candidate.end(), side.begin());
      if (isLeft(i) != isLeft((i + 1) % 3) && !same)
      {
        out = candidate;
      }
    }
    sum += 0.5 * (at(out[0]) + at(out[1]) - at(side[0]) - at(side[1]));
    side = out;
  }
  return sum;
}
}
