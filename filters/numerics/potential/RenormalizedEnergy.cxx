#include "RenormalizedEnergy.h"

#include <Eigen/LU>

#include <cmath>

namespace crossfield
{
RenormalizedEnergyValue EvaluateRenormalizedEnergy(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const std::vector<LogSource>& logs = solution.logs;
  const auto count =
    static_cast<Eigen::Index>(logs.size() - potential.GetBoundaryLogs().size()); // singularities
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
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
  energy += 0.5 * solution.sources.dot(regular);
  std::vector<Eigen::Matrix2Xd> carriedGradient(
    static_cast<std::size_t>(periods), Eigen::Matrix2Xd::Zero(2, count));
  for (const BoundaryHalf& half : potential.GetHalves())
  {
    const Point& vertex = mesh.points[static_cast<std::size_t>(half.vertex)];
    // The vertex stands for the half, but the logarithms of the boundary are integrated.
    double flux = half.logFlux;
    double value = half.logMean;
    for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j)
    {
      flux += logs[j].strength * logs[j].Turn(half.from, half.to);
      value += logs[j].Value(vertex);
    }
    energy += value * (half.growth - 0.5 * flux);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const LogSource& log = logs[static_cast<std::size_t>(j)];
      const Point turn = log.strength *
        (LogSource::TurnDerivative(half.to, log.position) -
          LogSource::TurnDerivative(half.from, log.position));
      gradient.col(j) += -(regular[half.vertex] + 0.5 * value) * turn +
        (half.growth - 0.5 * flux) * log.strength * LogSource::LogDerivative(vertex, log.position);
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
    gradient += solution.periods[k] * derivative;
  }
  result.energy = energy + 0.5 * solution.offsets.dot(solution.periods);
  result.gradient = gradient;
  return result;
}
}
