#include "RenormalizedEnergy.h"

#include "EdgePotential.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Flux and mean of all logarithms on a half of a boundary edge.
struct HalfFlow
{
  double flux = 0.0;
  double mean = 0.0;
};

std::vector<HalfFlow> FlowsOf(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const std::size_t inside = solution.logs.size() - potential.GetBoundaryLogs().size();
  std::vector<HalfFlow> flows;
  for (const BoundaryHalf& half : potential.GetHalves())
  {
    // Logarithms at the boundary have been integrated where they are large.
    HalfFlow flow{ half.logFlux, half.logMean };
    for (std::size_t j = 0; j < inside; ++j)
    {
      const LogSource& log = solution.logs[j];
      flow.flux += log.strength * log.Turn(half.from, half.to);
      flow.mean += 0.5 * (log.Value(half.from) + log.Value(half.to));
    }
    flows.push_back(flow);
  }
  return flows;
}

/// Returns R at the midpoints of boundary edges, in the Crouzeix-Raviart space.
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
/// W, its gradient and that of the carried phases, summed up term by term.
struct Terms
{
  double energy = 0.0;
  double logarithmCoefficient = 0.0;
  Eigen::Matrix2Xd gradient; ///< One column per singularity.
  std::vector<Eigen::Matrix2Xd>
    carriedGradient; ///< Gradient of the phase carried along each strip.
};

/// Adds the interaction of the logarithms, −½ Σ_{m≠n} ω_m a_m a_n log|x_m − x_n|.
void AddInteraction(const std::vector<LogSource>& logs, Terms& terms)
{
  const Eigen::Index count = terms.gradient.cols();
  for (std::size_t m = 0; m < logs.size(); ++m)
  {
    terms.logarithmCoefficient += 0.5 * logs[m].angle * logs[m].strength * logs[m].strength;
    for (std::size_t n = 0; n < logs.size(); ++n)
    {
      if (n != m)
      {
        const double factor =
          -0.5 * (logs[m].angle + logs[n].angle) * logs[m].strength * logs[n].strength;
        terms.energy += 0.5 * factor * std::log((logs[n].position - logs[m].position).norm());
        if (static_cast<Eigen::Index>(m) < count)
        {
          terms.gradient.col(static_cast<Eigen::Index>(m)) +=
            factor * LogSource::LogDerivative(logs[n].position, logs[m].position);
        }
      }
    }
  }
}

/// Adds the boundary integrals ½ ∮ R ∂R/∂ν + ∮ Λ ∂R/∂ν + ½ ∮ Λ ∂Λ/∂ν with ∂R/∂ν = s − ∂Λ/∂ν.
void AddBoundaryIntegrals(const PointPotential& potential, const PointPotential::Solution& solution,
  const EdgePotential& onEdges, Terms& terms)
{
  const Eigen::Index count = terms.gradient.cols();
  const auto periods = static_cast<Eigen::Index>(terms.carriedGradient.size());
  const std::vector<HalfFlow> flows = FlowsOf(potential, solution);
  const Eigen::VectorXd atEdges = SolveOnEdges(potential, onEdges, flows);
  for (std::size_t h = 0; h < flows.size(); ++h)
  {
    const BoundaryHalf& half = potential.GetHalves()[h];
    const HalfFlow& flow = flows[h];
    const double regularValue =
      0.5 * (solution.regular[half.vertex] + atEdges[static_cast<Eigen::Index>(h / 2)]);
    terms.energy +=
      0.5 * (half.growth - flow.flux) * regularValue + flow.mean * (half.growth - 0.5 * flow.flux);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const LogSource& log = solution.logs[j];
      const Point turn = log.strength *
        (LogSource::TurnDerivative(half.to, log.position) -
          LogSource::TurnDerivative(half.from, log.position));
      terms.gradient.col(j) += -(regularValue + 0.5 * flow.mean) * turn +
        (half.growth - 0.5 * flow.flux) * 0.5 * log.strength *
          (LogSource::LogDerivative(half.from, log.position) +
            LogSource::LogDerivative(half.to, log.position));
      for (Eigen::Index k = 0; k < periods; ++k)
      {
        // The carried phase is linear in the sources, and its adjoint is the basis of the periods.
        terms.carriedGradient[k].col(j) -= potential.GetPeriodBasis()(half.vertex, k) * turn;
      }
    }
  }
}

/// Returns the gradient of each holonomy defect.
std::vector<Eigen::Matrix2Xd> DefectGradients(const PointPotential& potential,
  const std::vector<LogSource>& logs, const std::vector<Eigen::Matrix2Xd>& carriedGradient)
{
  const auto periods = static_cast<Eigen::Index>(carriedGradient.size());
  const Eigen::MatrixXd schur = potential.GetPeriodBasis().bottomRows(periods).inverse();
  std::vector<Eigen::Matrix2Xd> gradients;
  for (Eigen::Index k = 0; k < periods; ++k)
  {
    const Eigen::Index count = carriedGradient.front().cols();
    Eigen::Matrix2Xd derivative = Eigen::Matrix2Xd::Zero(2, count);
    for (Eigen::Index l = 0; l < periods; ++l)
    {
      derivative += schur(k, l) * carriedGradient[l];
    }
    const auto [first, last] = potential.StripEnds(k);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const LogSource& log = logs[j];
      derivative.col(j) -= log.strength *
        (LogSource::TurnDerivative(first, log.position) -
          LogSource::TurnDerivative(last, log.position));
    }
    gradients.push_back(derivative);
  }
  return gradients;
}
}

RenormalizedEnergyValue EvaluateRenormalizedEnergy(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const auto count = static_cast<Eigen::Index>(
    solution.logs.size() - potential.GetBoundaryLogs().size()); // singularities
  Terms terms;
  terms.gradient = Eigen::Matrix2Xd::Zero(2, count);
  terms.carriedGradient.assign(solution.holonomyDefect.size(), Eigen::Matrix2Xd::Zero(2, count));

  // 1. W without the harmonic field of the holonomy defects.
  AddInteraction(solution.logs, terms);
  const EdgePotential onEdges(*potential.GetProblem().potential);
  AddBoundaryIntegrals(potential, solution, onEdges, terms);
  RenormalizedEnergyValue result;
  result.logarithmCoefficient = terms.logarithmCoefficient;
  result.singleValuedEnergy = terms.energy;
  result.singleValuedGradient = terms.gradient;

  // 2. The harmonic field. Its energy, too, is the mean of those of a potential and of a phase,
  //    which bound it.
  const Eigen::VectorXd meanPeriods =
    0.5 * (solution.periods + onEdges.CouplingOfIslands() * solution.offsets);
  result.holonomyDefect = solution.holonomyDefect;
  result.defectGradient = DefectGradients(potential, solution.logs, terms.carriedGradient);
  result.energy = terms.energy + 0.5 * solution.offsets.dot(meanPeriods);
  result.gradient = terms.gradient;
  for (std::size_t k = 0; k < result.defectGradient.size(); ++k)
  {
    result.gradient += meanPeriods[static_cast<Eigen::Index>(k)] * result.defectGradient[k];
  }
  return result;
}

double CoreOverlapEnergy(const Configuration& interior, double radius)
{
  double energy = 0.0;
  for (std::size_t i = 0; i < interior.size(); ++i)
  {
    double square = 4.0 * radius * radius; // of the distance
    for (std::size_t j = 0; j < interior.size(); ++j)
    {
      square = i == j
        ? square
        : std::min(square, (interior[i].position - interior[j].position).squaredNorm());
    }
    const double core = 0.5 * std::sqrt(square);
    const double quarters = interior[i].quarterIndex;
    energy += core < radius ? Pi * quarters * quarters * std::log(radius / core) : 0.0;
  }
  return energy;
}
}
