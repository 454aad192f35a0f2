#include "PositionEnergy.h"

#include "DenseProduct.h"
#include "Parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Minimum number of rows for two solves at the same time: they take a quarter of a millisecond.
constexpr Eigen::Index MinimumRowsInParallel = 4000;
}

PositionEnergy::PositionEnergy(std::shared_ptr<const PointPotential> potential)
  : Potential(std::move(potential))
  , OnEdges(*this->Potential->GetProblem().potential)
  , Samples(*this->Potential)
{
  const std::vector<LogSource>& logs = this->Potential->GetBoundaryLogs();
  for (std::size_t m = 0; m < logs.size(); ++m)
  {
    this->BoundaryCoefficient += 0.5 * logs[m].angle * logs[m].strength * logs[m].strength;
    for (std::size_t n = 0; n < m; ++n)
    {
      this->BoundaryInteraction -= 0.5 * (logs[m].angle + logs[n].angle) * logs[m].strength *
        logs[n].strength * std::log((logs[n].position - logs[m].position).norm());
    }
  }

  const LogSource* const begin = logs.data();
  const LogSource* const corners = begin + this->Potential->CurveLogCount();
  const LogSource* const end = begin + logs.size();
  this->BoundaryTurns = Eigen::VectorXd::Zero(this->Potential->GetPeriodBasis().cols());
  for (Eigen::Index k = 0; k < this->BoundaryTurns.size(); ++k)
  {
    // Points of curves see the path between points of curves.
    const std::vector<Point> onCurve = this->Potential->StripPath(k, true);
    this->Paths.push_back(this->Potential->StripPath(k, false));
    const std::vector<Point>& path = this->Paths.back();
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      this->BoundaryTurns[k] -= SumOfTurns(begin, corners, onCurve[i], onCurve[i + 1]) +
        SumOfTurns(corners, end, path[i], path[i + 1]);
    }
  }
}

const Eigen::MatrixXd& PositionEnergy::GetMidpointInfluence() const
{
  return this->MidpointInfluence.Get(
    [this]
    {
      const PeriodResponse& response = this->Potential->GetProblem().potential->GetPeriodResponse();
      const std::vector<BoundaryHalf>& halves = this->Potential->GetHalves();
      // Of the basis at the two ends of each edge.
      Eigen::MatrixXd differences(this->Samples.points.rows() / 2, response.basis.cols());
      for (Eigen::Index i = 0; i < differences.rows(); ++i)
      {
        const auto half = 2 * static_cast<std::size_t>(i);
        differences.row(i) =
          response.basis.row(halves[half + 1].vertex) - response.basis.row(halves[half].vertex);
      }
      return std::make_unique<const Eigen::MatrixXd>(
        DenseProduct(differences, response.schur.transpose()));
    });
}

PositionEnergy::Flows PositionEnergy::Solve(const Configuration& configuration,
  PointPotential::Solution& solution, Eigen::VectorXd& regular) const
{
  std::vector<LogSource>& logs = solution.logs;
  for (const Singularity& singularity : configuration)
  {
    logs.push_back(
      { singularity.position, static_cast<double>(singularity.quarterIndex), 2.0 * Pi });
  }
  const LogSource* const begin = logs.data();
  const LogSource* const end = begin + logs.size();
  const std::vector<BoundaryHalf>& halves = this->Potential->GetHalves();
  Eigen::VectorXd sums(this->Samples.points.rows());
  const std::ptrdiff_t pointsOfPart =
    BoundarySamples::LogsOfPart / static_cast<std::ptrdiff_t>(logs.size() + 1);
  ForRanges(
    sums.size(),
    [&](int first, int last)
    {
      for (Eigen::Index p = first; p < last; ++p)
      {
        sums[p] = SumOfLogs(logs, this->Samples.points.row(p).matrix().transpose());
      }
    },
    pointsOfPart);
  Flows flows;
  flows.flux.resize(static_cast<Eigen::Index>(halves.size()));
  flows.mean.resize(flows.flux.size());
  solution.sources = this->Potential->GetSources();
  Eigen::VectorXd turns(flows.flux.size());
  ForRanges(
    turns.size(),
    [&](int first, int last)
    {
      for (auto h = static_cast<std::size_t>(first); h < static_cast<std::size_t>(last); ++h)
      {
        turns[static_cast<Eigen::Index>(h)] = SumOfTurns(begin, end, halves[h].from, halves[h].to);
      }
    },
    pointsOfPart);
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    const BoundaryHalf& half = halves[h];
    const auto row = static_cast<Eigen::Index>(h);
    solution.sources[half.vertex] -= turns[row];
    flows.flux[row] = half.logFlux + turns[row];
    flows.mean[row] =
      half.logMean + 0.5 * (sums[this->Samples.starts[h]] + sums[this->Samples.ends[h]]);
  }
  Eigen::VectorXd fluxes = Eigen::VectorXd::Zero(flows.flux.size() / 2);
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    fluxes[static_cast<Eigen::Index>(h / 2)] +=
      halves[h].growth - flows.flux[static_cast<Eigen::Index>(h)];
  }

  // The solutions at vertices and on edges, which are independent of each other.
  Eigen::VectorXd atEdges;
  const auto solve = [&](std::size_t part)
  {
    if (part == 1)
    {
      atEdges = this->OnEdges.Solve(fluxes);
      return;
    }
    this->Potential->Complete(solution,
      [&](Eigen::Index k, double phase)
      {
        const std::vector<Point>& path = this->Paths[k];
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
        {
          phase += SumOfTurns(begin, end, path[i], path[i + 1]);
        }
        return phase - this->BoundaryTurns[k];
      });
  };
  if (solution.sources.size() >= MinimumRowsInParallel)
  {
    ForParts(2, solve);
  }
  else
  {
    solve(0);
    solve(1);
  }
  logs.insert(logs.end(), this->Potential->GetBoundaryLogs().begin(),
    this->Potential->GetBoundaryLogs().end());
  regular.resize(flows.flux.size());
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    regular[static_cast<Eigen::Index>(h)] =
      0.5 * (solution.regular[halves[h].vertex] + atEdges[static_cast<Eigen::Index>(h / 2)]);
  }
  return flows;
}

void PositionEnergy::AddInteraction(
  const std::vector<LogSource>& logs, std::size_t inside, RenormalizedEnergyValue& value) const
{
  value.logarithmCoefficient = this->BoundaryCoefficient;
  value.singleValuedEnergy = this->BoundaryInteraction;
  const bool derivatives = value.singleValuedGradient.cols() > 0;
  for (std::size_t m = 0; m < inside; ++m)
  {
    value.logarithmCoefficient += 0.5 * logs[m].angle * logs[m].strength * logs[m].strength;
    for (std::size_t n = m + 1; n < logs.size(); ++n)
    {
      const Point offset = logs[n].position - logs[m].position;
      const double square = offset.squaredNorm();
      const double factor =
        -0.5 * (logs[m].angle + logs[n].angle) * logs[m].strength * logs[n].strength;
      value.singleValuedEnergy += 0.5 * factor * std::log(square);
      if (derivatives)
      {
        value.singleValuedGradient.col(static_cast<Eigen::Index>(m)) -= factor / square * offset;
        if (n < inside)
        {
          value.singleValuedGradient.col(static_cast<Eigen::Index>(n)) += factor / square * offset;
        }
      }
    }
  }
}

void PositionEnergy::AddDerivatives(const PointPotential::Solution& solution, std::size_t inside,
  const Flows& flows, const Eigen::VectorXd& regular, RenormalizedEnergyValue& value) const
{
  const auto [ofTurns, ofLogs] = this->FindFactors(flows, regular);

  // 1. Sums over the points. With y = x − b the derivatives are (y₂, −y₁) / |y|² and −y / |y|².
  const Eigen::Index middles = this->Samples.points.rows() / 2;
  const Eigen::MatrixXd& influence = this->GetMidpointInfluence();
  const Eigen::Index periods = influence.cols();
  const auto count = static_cast<Eigen::Index>(inside);
  Eigen::MatrixXd atMiddles(middles, periods > 0 ? 2 * count : 0);
  ForRanges(
    count,
    [&, &turnFactors = ofTurns, &logFactors = ofLogs](int begin, int end)
    {
      Eigen::ArrayXd x(this->Samples.points.rows());
      Eigen::ArrayXd y(this->Samples.points.rows());
      for (Eigen::Index j = begin; j < end; ++j)
      {
        const LogSource& log = solution.logs[j];
        this->Samples.InvertOffsets(log.position, x, y);
        value.singleValuedGradient(0, j) += log.strength * (turnFactors * y - logFactors * x).sum();
        value.singleValuedGradient(1, j) -= log.strength * (turnFactors * x + logFactors * y).sum();
        if (periods > 0)
        {
          atMiddles.col(2 * j) = log.strength * y.tail(middles);
          atMiddles.col(2 * j + 1) = -log.strength * x.tail(middles);
        }
      }
    },
    this->Samples.SingularitiesOfPart());

  // 2. Holonomy defects, which are linear in the sources.
  const Eigen::MatrixXd carried = AdjointProduct(influence, atMiddles);
  for (Eigen::Index k = 0; k < periods; ++k)
  {
    const std::vector<Point>& path = this->Paths[k];
    Eigen::Matrix2Xd derivative(2, count);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const LogSource& log = solution.logs[j];
      derivative.col(j) = Point(carried(k, 2 * j), carried(k, 2 * j + 1)) -
        log.strength *
          (LogSource::TurnDerivative(path.front(), log.position) -
            LogSource::TurnDerivative(path.back(), log.position));
    }
    value.defectGradient.push_back(std::move(derivative));
  }
}

PositionEnergy::PointFactors PositionEnergy::FindFactors(
  const Flows& flows, const Eigen::VectorXd& regular) const
{
  const std::vector<BoundaryHalf>& halves = this->Potential->GetHalves();
  PointFactors factors{ Eigen::ArrayXd::Zero(this->Samples.points.rows()),
    Eigen::ArrayXd::Zero(this->Samples.points.rows()) };
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    const auto row = static_cast<Eigen::Index>(h);
    const double turn = regular[row] + 0.5 * flows.mean[row];
    const double log = 0.5 * (halves[h].growth - 0.5 * flows.flux[row]);
    factors.ofTurns[this->Samples.starts[h]] += turn;
    factors.ofTurns[this->Samples.ends[h]] -= turn;
    factors.ofLogs[this->Samples.starts[h]] += log;
    factors.ofLogs[this->Samples.ends[h]] += log;
  }
  return factors;
}

PositionEnergy::Value PositionEnergy::Evaluate(
  const Configuration& configuration, bool derivatives) const
{
  Value result;
  PointPotential::Solution& solution = result.solution;
  RenormalizedEnergyValue& value = result.renormalized;
  const std::size_t inside = configuration.size();
  result.flows = this->Solve(configuration, solution, result.regular);
  const Flows& flows = result.flows;
  const std::vector<BoundaryHalf>& halves = this->Potential->GetHalves();
  const Eigen::VectorXd& regular = result.regular;

  value.singleValuedGradient =
    Eigen::Matrix2Xd::Zero(2, derivatives ? static_cast<Eigen::Index>(inside) : 0);
  this->AddInteraction(solution.logs, inside, value);
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    const auto row = static_cast<Eigen::Index>(h);
    value.singleValuedEnergy += 0.5 * (halves[h].growth - flows.flux[row]) * regular[row] +
      flows.mean[row] * (halves[h].growth - 0.5 * flows.flux[row]);
  }
  const Eigen::VectorXd meanPeriods =
    0.5 * (solution.periods + this->OnEdges.CouplingOfIslands() * solution.offsets);
  value.holonomyDefect = solution.holonomyDefect;
  value.energy = value.singleValuedEnergy + 0.5 * solution.offsets.dot(meanPeriods);
  if (derivatives)
  {
    this->AddDerivatives(solution, inside, flows, regular, value);
    value.gradient = value.singleValuedGradient;
    for (std::size_t k = 0; k < value.defectGradient.size(); ++k)
    {
      value.gradient += meanPeriods[static_cast<Eigen::Index>(k)] * value.defectGradient[k];
    }
  }
  return result;
}
}
