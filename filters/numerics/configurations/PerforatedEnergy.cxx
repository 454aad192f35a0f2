#include "PerforatedEnergy.h"

#include "AlignedPotential.h"
#include "ConjugateField.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// A continuous piecewise linear phase with periods, written like the potential as Ψ + Σ q_k η_k.
class ConformingPhase
{
public:
  ConformingPhase(const PotentialProblem& problem, const EdgePhases& phases)
    : Problem(problem)
    , Strips(problem.potential->GetStrips())
    , Value(Eigen::VectorXd::Zero(problem.potential->Rows()))
  {
    for (std::size_t k = 0; k < this->Strips.size(); ++k)
    {
      for (const LoopStrip::Step& step : this->Strips[k].steps)
      {
        this->StepsOf[step.triangle].push_back({ static_cast<Eigen::Index>(k), &step });
      }
    }
    const Eigen::VectorXd growth = phases.end - phases.start;
    this->SetPeriods(growth);
    for (const BoundaryLoop& loop : problem.Topology().loops)
    {
      if (loop.kind != BoundaryKind::Hole)
      {
        this->SetLoop(loop, growth);
      }
    }
  }

  /// Shifts every inner loop so that φ at the strip's first edge minus φ at its last is as given.
  void ShiftInnerLoops(const Eigen::VectorXd& differences)
  {
    Eigen::Index k = 0;
    for (const BoundaryLoop& loop : this->Problem.Topology().loops)
    {
      if (loop.kind == BoundaryKind::Inner)
      {
        const double shift = -differences[k] - this->Transport(k);
        ++k;
        for (int edge : loop.edges)
        {
          this->Value[this->Boundary(edge).vertices[0]] += shift;
        }
      }
    }
  }

  const Eigen::VectorXd& Get() const { return this->Value; }

private:
  const BoundaryEdge& Boundary(int edge) const { return this->Problem.Topology().BoundaryAt(edge); }
  const std::array<int, 3>& Triangle(int t) const
  {
    return this->Problem.Topology().mesh.triangles[static_cast<std::size_t>(t)];
  }

  /// Going counter-clockwise around a loop one crosses its strip from the left to the right, which
  /// takes q away: q is minus the growth.
  void SetPeriods(const Eigen::VectorXd& growth)
  {
    Eigen::Index k = 0;
    for (const BoundaryLoop& loop : this->Problem.Topology().loops)
    {
      if (loop.kind == BoundaryKind::Outer)
      {
        continue;
      }
      double& period = this->Value[this->Problem.potential->PeriodRow(k)];
      ++k;
      if (loop.kind == BoundaryKind::Hole)
      {
        period = -2.0 * Pi * loop.quarterIndex;
        continue;
      }
      for (int edge : loop.edges)
      {
        period += growth[edge]; // of a clockwise edge
      }
    }
  }

  /// Σ q_k η_k in a triangle at one of its vertices.
  double Jump(int triangle, int vertex) const
  {
    const auto found = this->StepsOf.find(triangle);
    double jump = 0.0;
    if (found != this->StepsOf.end())
    {
      const auto& v = this->Triangle(triangle);
      const auto i = static_cast<std::size_t>(std::find(v.begin(), v.end(), vertex) - v.begin());
      for (const auto& [k, step] : found->second)
      {
        jump += this->Value[this->Problem.potential->PeriodRow(k)] * step->left[i];
      }
    }
    return jump;
  }

  /// The values at a loop's vertices, from 0 at its first one.
  void SetLoop(const BoundaryLoop& loop, const Eigen::VectorXd& growth)
  {
    std::vector<int> along = loop.edges;
    if (loop.kind == BoundaryKind::Inner)
    {
      std::reverse(along.begin(), along.end());
    }
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
    {
      const auto [from, to] = this->Boundary(along[i]).vertices;
      const int edge =
        this->Problem.Topology().edges.ofBoundary[static_cast<std::size_t>(along[i])];
      const int triangle =
        this->Problem.Topology().edges.triangles[static_cast<std::size_t>(edge)][0];
      this->Value[to] = this->Value[from] + growth[along[i]] - this->Jump(triangle, to) +
        this->Jump(triangle, from);
    }
  }

  /// φ at the midpoint of the strip's last edge minus that of its first, along the strip.
  double Transport(Eigen::Index k) const
  {
    const LoopStrip& strip = this->Strips[static_cast<std::size_t>(k)];
    std::array<int, 2> side = this->Boundary(strip.firstBoundaryEdge).vertices;
    double sum = 0.0;
    for (const LoopStrip::Step& step : strip.steps)
    {
      const auto& v = this->Triangle(step.triangle);
      const auto at = [&](int vertex)
      { return this->Value[vertex] + this->Jump(step.triangle, vertex); };
      // The way leaves by the other side that has one end on the left and one on the right.
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

  const PotentialProblem& Problem;
  const std::vector<LoopStrip>& Strips;
  std::map<int, std::vector<std::pair<Eigen::Index, const LoopStrip::Step*>>> StepsOf;
  Eigen::VectorXd Value;
};
}

PerforatedEnergy ComputePerforatedEnergy(
  const SharedTopology& topology, const std::vector<CornerChoice>& corners)
{
  PerforatedEnergy result;
  constexpr auto Everywhere = PotentialSolver::Periods::IslandsAndHoles;
  Alignment alignment = AlignWithBoundary(*topology, corners);
  RequireConsistent(alignment.count);
  const PotentialProblem problem(
    std::make_shared<const PotentialSolver>(topology), std::move(alignment));
  const AlignedPotential linear = SolveAligned(problem, LinearPhase(problem));
  result.alignedLower = linear.energy;
  result.holonomyDefect = linear.holonomyDefect;

  const PotentialSolver given(topology, PotentialSolver::Boundary::Given);
  ConformingPhase phase(problem, LinearEdgePhases(problem));
  if (topology->LoopCount(BoundaryKind::Inner) > 0)
  {
    phase.ShiftInnerLoops(linear.carriedPhase);
  }
  const Eigen::VectorXd inside = given.Solve(-given.Apply(phase.Get()), Everywhere);
  result.alignedUpper = GradientEnergy(topology->mesh, given.Gradient(phase.Get() + inside));

  // Free along the boundary. Of Φ only the constants on the holes matter, of φ only the periods
  // around them, which come last: both are in the trailing blocks of the factors.
  const Eigen::MatrixXd merge = MergeHoles(problem);
  const Eigen::Index holes = merge.cols() - topology->LoopCount(BoundaryKind::Inner);
  Eigen::VectorXd turns(holes);
  Eigen::Index hole = 0;
  for (const BoundaryLoop& loop : problem.Topology().loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      turns[hole++] = 2.0 * Pi * loop.quarterIndex;
    }
  }
  const Eigen::MatrixXd lower = given.TrailingFactor(Everywhere);
  const Eigen::MatrixXd root =
    lower.triangularView<Eigen::Lower>().transpose() * merge.topLeftCorner(lower.rows(), holes);
  result.degreeOnlyLower =
    0.5 * turns.dot(Eigen::LLT<Eigen::MatrixXd>(root.transpose() * root).solve(turns));
  const Eigen::MatrixXd periods =
    problem.potential->TrailingFactor(Everywhere).bottomRightCorner(holes, holes);
  result.degreeOnlyUpper =
    0.5 * (periods.triangularView<Eigen::Lower>().transpose() * turns).squaredNorm();
  return result;
}
}
