#include "RenormalizedEnergy.h"

#include "EdgePotential.h"

#include <Eigen/LU>

#include <cmath>

namespace crossfield
{
namespace
{
/// What the logarithms are on a half of a boundary edge.
struct HalfFlow
{
  double flux = 0.0;
  double value = 0.0; ///< Mean.
};

std::vector<HalfFlow> FlowsOf(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const std::size_t inside = solution.logs.size() - potential.GetBoundaryLogs().size();
  std::vector<HalfFlow> flows;
  for (const BoundaryHalf& half : potential.GetHalves())
  {
    // The logarithms of the boundary are integrated where they are large.
    HalfFlow flow{ half.logFlux, half.logMean };
    for (std::size_t j = 0; j < inside; ++j)
    {
      const LogSource& log = solution.logs[j];
      flow.flux += log.strength * log.Turn(half.from, half.to);
      flow.value += 0.5 * (log.Value(half.from) + log.Value(half.to));
    }
    flows.push_back(flow);
  }
  return flows;
}

/// R at the midpoints of boundary edges, in the Crouzeix-Raviart space.
Eigen::VectorXd SolveOnEdges(
  const PointPotential& potential, const EdgePotential& onEdges, const std::vector<HalfFlow>& flows)
{
  Eigen::VectorXd fluxes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(flows.size() / 2));
  for (std::size_t h = 0; h < flows.size(); ++h)
  {
    fluxes[static_cast<Eigen::Index>(h / 2)] += potential.GetHalves()[h].growth - flows[h].flux;
  }
  return onEdges.Solve(fluxes);
}
}

RenormalizedEnergyValue EvaluateRenormalizedEnergy(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const std::vector<LogSource>& logs = solution.logs;
  const auto count =
    static_cast<Eigen::Index>(logs.size() - potential.GetBoundaryLogs().size()); // singularities
  const Eigen::VectorXd& regular = solution.regular;
  const auto periods = static_cast<Eigen::Index>(solution.holonomyDefect.size());

  RenormalizedEnergyValue result;
  Eigen::Matrix2Xd gradient = Eigen::Matrix2Xd::Zero(2, count);
  double energy = 0.0;

  // 1. The logarithms among each other.
  for (std::size_t m = 0; m < logs.size(); ++m)
  {
    result.logarithmCoefficient += 0.5 * logs[m].angle * logs[m].strength * logs[m].strength;
    for (std::size_t n = 0; n < logs.size(); ++n)
    {
      if (n != m)
      {
        const double factor =
          -0.5 * (logs[m].angle + logs[n].angle) * logs[m].strength * logs[n].strength;
        energy += 0.5 * factor * std::log((logs[n].position - logs[m].position).norm());
        if (static_cast<Eigen::Index>(m) < count)
        {
          gradient.col(static_cast<Eigen::Index>(m)) +=
            factor * LogSource::LogDerivative(logs[n].position, logs[m].position);
        }
      }
    }
  }

  // 2. On the boundary: ½ ∮ R ∂R/∂ν + ∮ Λ ∂R/∂ν + ½ ∮ Λ ∂Λ/∂ν with ∂R/∂ν = s − ∂Λ/∂ν.
  const std::vector<HalfFlow> flows = FlowsOf(potential, solution);
  const EdgePotential onEdges(*potential.GetProblem().potential);
  const Eigen::VectorXd atEdges = SolveOnEdges(potential, onEdges, flows);
  std::vector<Eigen::Matrix2Xd> carriedGradient(
    static_cast<std::size_t>(periods), Eigen::Matrix2Xd::Zero(2, count));
  for (std::size_t h = 0; h < flows.size(); ++h)
  {
    const BoundaryHalf& half = potential.GetHalves()[h];
    const HalfFlow& flow = flows[h];
    const double regularValue =
      0.5 * (regular[half.vertex] + atEdges[static_cast<Eigen::Index>(h / 2)]);
    energy +=
      0.5 * (half.growth - flow.flux) * regularValue + flow.value * (half.growth - 0.5 * flow.flux);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const LogSource& log = logs[static_cast<std::size_t>(j)];
      const Point turn = log.strength *
        (LogSource::TurnDerivative(half.to, log.position) -
          LogSource::TurnDerivative(half.from, log.position));
      gradient.col(j) += -(regularValue + 0.5 * flow.value) * turn +
        (half.growth - 0.5 * flow.flux) * 0.5 * log.strength *
          (LogSource::LogDerivative(half.from, log.position) +
            LogSource::LogDerivative(half.to, log.position));
      for (Eigen::Index k = 0; k < periods; ++k)
      {
        // The carried phase is linear in the sources, and its adjoint is the basis of the periods.
        carriedGradient[static_cast<std::size_t>(k)].col(j) -=
          potential.GetPeriodBasis()(half.vertex, k) * turn;
      }
    }
  }
  result.singleValuedEnergy = energy;
  result.singleValuedGradient = gradient;

  // 3. The harmonic field that the holonomy defects leave, and how the defects change.
  // Its energy is bounded by those of a potential and of a phase, too.
  const Eigen::VectorXd periodsOfBoth =
    0.5 * (solution.periods + onEdges.CouplingOfIslands() * solution.offsets);
  const Eigen::MatrixXd schur = potential.GetPeriodBasis().bottomRows(periods).inverse();
  result.holonomyDefect = solution.holonomyDefect;
  for (Eigen::Index k = 0; k < periods; ++k)
  {
    Eigen::Matrix2Xd derivative = Eigen::Matrix2Xd::Zero(2, count);
    for (Eigen::Index l = 0; l < periods; ++l)
    {
      derivative += schur(k, l) * carriedGradient[static_cast<std::size_t>(l)];
    }
    const auto [first, last] = potential.StripEnds(k);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const LogSource& log = logs[static_cast<std::size_t>(j)];
      derivative.col(j) -= log.strength *
        (LogSource::TurnDerivative(first, log.position) -
          LogSource::TurnDerivative(last, log.position));
    }
    result.defectGradient.push_back(derivative);
    gradient += periodsOfBoth[k] * derivative;
  }
  result.energy = energy + 0.5 * solution.offsets.dot(periodsOfBoth);
  result.gradient = gradient;
  return result;
}
}
