#include "ConformingPhase.h"

#include <algorithm>
#include <array>

namespace crossfield
{
ConformingPhase::Steps::Steps(const PotentialOperator& laplacian)
{
  const std::vector<Cycle>& cycles = laplacian.GetTopology().cycles;
  for (std::size_t k = 0; k < cycles.size(); ++k)
  {
    for (const Cycle::Step& step : cycles[k].steps)
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
  const MeshTopology& topology = this->Laplacian.GetTopology();
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
    const auto& v = this->Laplacian.GetTopology().mesh.triangles[triangle];
    const auto i = std::find(v.begin(), v.end(), vertex) - v.begin();
    for (const auto& [k, step] : found->second)
    {
      jump += this->Value[this->Laplacian.PeriodRow(k)] * step->Left()[i];
    }
  }
  return jump;
}

void ConformingPhase::SetLoop(const BoundaryLoop& loop, const Eigen::VectorXd& growth)
{
  const MeshTopology& topology = this->Laplacian.GetTopology();
  std::vector<int> along = loop.edges;
  if (loop.kind == BoundaryKind::Inner)
  {
    std::reverse(along.begin(), along.end());
  }
  for (std::size_t i = 0; i + 1 < along.size(); ++i)
  {
    const auto [from, to] = topology.BoundaryAt(along[i]).vertices;
    const int triangle = topology.SideOfBoundary(along[i]).first;
    this->Value[to] =
      this->Value[from] + growth[along[i]] - this->Jump(triangle, to) + this->Jump(triangle, from);
  }
}

double ConformingPhase::Transport(Eigen::Index k) const
{
  const MeshTopology& topology = this->Laplacian.GetTopology();
  double sum = 0.0;
  for (const Cycle::Step& step : topology.cycles[k].steps)
  {
    const auto& v = topology.mesh.triangles[step.triangle];
    const auto at = [&](int side)
    {
      const int vertex = v[side % 3];
      return this->Value[vertex] + this->Jump(step.triangle, vertex);
    };
    sum += 0.5 * (at(step.exit) + at(step.exit + 1) - at(step.entry + 1) - at(step.entry));
  }
  return sum;
}
}
