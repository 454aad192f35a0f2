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
/// Minimum number of logarithms or of their derivatives in a part.
constexpr std::ptrdiff_t LogsOfPart = 10000;

/// Minimum number of rows for two solves at the same time: they take a quarter of a millisecond.
constexpr Eigen::Index MinimumRowsInParallel = 4000;

/// Returns the real and imaginary part of 1/y², y as a complex number.
Eigen::Vector2d InverseSquare(const Point& y)
{
  const Eigen::Vector2d inverse = y / y.squaredNorm();
  return { inverse.x() * inverse.x() - inverse.y() * inverse.y(),
    -2.0 * inverse.x() * inverse.y() };
}

/// Returns the minimum number of singularities in a part of a loop over all points for each of them.
std::ptrdiff_t PositionsOfPart(Eigen::Index points)
{
  return std::max<std::ptrdiff_t>(1, LogsOfPart / std::max<std::ptrdiff_t>(1, points));
}

/// Computes y / |y|² for the offsets y of points from a position.
void InvertOffsets(
  const Eigen::ArrayX2d& points, const Point& position, Eigen::ArrayXd& x, Eigen::ArrayXd& y)
{
  x = points.col(0) - position.x();
  y = points.col(1) - position.y();
  const Eigen::ArrayXd inverse = 1.0 / (x * x + y * y);
  x *= inverse;
  y *= inverse;
}
}

PositionEnergy::PositionEnergy(std::shared_ptr<const PointPotential> potential)
  : Potential(std::move(potential))
  , OnEdges(*this->Potential->GetProblem().potential)
{
  const std::vector<BoundaryHalf>& halves = this->Potential->GetHalves();
  const std::vector<std::size_t>& next = this->Potential->GetNext();
  const auto count = static_cast<Eigen::Index>(next.size());
  this->Points.resize(2 * count, 2);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const BoundaryHalf& first = halves[2 * static_cast<std::size_t>(i)];
    this->Points.row(i) = first.from.transpose();
    this->Points.row(count + i) = first.to.transpose();
    const auto following = static_cast<Eigen::Index>(next[static_cast<std::size_t>(i)]);
    this->Starts.insert(this->Starts.end(), { i, count + i });
    this->Ends.insert(this->Ends.end(), { count + i, following });
  }

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
      Eigen::MatrixXd differences(this->Points.rows() / 2, response.basis.cols());
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
  Eigen::VectorXd sums(this->Points.rows());
  const std::ptrdiff_t pointsOfPart = LogsOfPart / static_cast<std::ptrdiff_t>(logs.size() + 1);
  ForRanges(
    sums.size(),
    [&](int first, int last)
    {
      for (Eigen::Index p = first; p < last; ++p)
      {
        sums[p] = SumOfLogs(logs, this->Points.row(p).matrix().transpose());
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
    flows.mean[row] = half.logMean + 0.5 * (sums[this->Starts[h]] + sums[this->Ends[h]]);
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
        const std::vector<Point>& path = this->Paths[static_cast<std::size_t>(k)];
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
  const Eigen::Index middles = this->Points.rows() / 2;
  const Eigen::MatrixXd& influence = this->GetMidpointInfluence();
  const Eigen::Index periods = influence.cols();
  const auto count = static_cast<Eigen::Index>(inside);
  Eigen::MatrixXd atMiddles(middles, periods > 0 ? 2 * count : 0);
  ForRanges(
    count,
    [&, &turnFactors = ofTurns, &logFactors = ofLogs](int begin, int end)
    {
      Eigen::ArrayXd x(this->Points.rows());
      Eigen::ArrayXd y(this->Points.rows());
      for (Eigen::Index j = begin; j < end; ++j)
      {
        const LogSource& log = solution.logs[static_cast<std::size_t>(j)];
        InvertOffsets(this->Points, log.position, x, y);
        value.singleValuedGradient(0, j) += log.strength * (turnFactors * y - logFactors * x).sum();
        value.singleValuedGradient(1, j) -= log.strength * (turnFactors * x + logFactors * y).sum();
        if (periods > 0)
        {
          atMiddles.col(2 * j) = log.strength * y.tail(middles);
          atMiddles.col(2 * j + 1) = -log.strength * x.tail(middles);
        }
      }
    },
    PositionsOfPart(this->Points.rows()));

  // 2. Holonomy defects, which are linear in the sources.
  const Eigen::MatrixXd carried = AdjointProduct(influence, atMiddles);
  for (Eigen::Index k = 0; k < periods; ++k)
  {
    const std::vector<Point>& path = this->Paths[static_cast<std::size_t>(k)];
    Eigen::Matrix2Xd derivative(2, count);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const LogSource& log = solution.logs[static_cast<std::size_t>(j)];
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
  PointFactors factors{ Eigen::ArrayXd::Zero(this->Points.rows()),
    Eigen::ArrayXd::Zero(this->Points.rows()) };
  for (std::size_t h = 0; h < halves.size(); ++h)
  {
    const auto row = static_cast<Eigen::Index>(h);
    const double turn = regular[row] + 0.5 * flows.mean[row];
    const double log = 0.5 * (halves[h].growth - 0.5 * flows.flux[row]);
    factors.ofTurns[this->Starts[h]] += turn;
    factors.ofTurns[this->Ends[h]] -= turn;
    factors.ofLogs[this->Starts[h]] += log;
    factors.ofLogs[this->Ends[h]] += log;
  }
  return factors;
}

Eigen::MatrixXd PositionEnergy::Respond(
  const Eigen::MatrixXd& fluxes, Eigen::MatrixXd& atVertices) const
{
  const std::vector<BoundaryHalf>& halves = this->Potential->GetHalves();
  const PotentialSolver& potential = *this->Potential->GetProblem().potential;
  Eigen::MatrixXd sources(potential.Rows(), fluxes.cols());
  ForRanges(
    fluxes.cols(),
    [&](int begin, int end)
    {
      sources.middleCols(begin, end - begin).setZero();
      for (Eigen::Index column = begin; column < end; ++column)
      {
        for (Eigen::Index h = 0; h < fluxes.rows(); ++h)
        {
          sources(halves[static_cast<std::size_t>(h)].vertex, column) += fluxes(h, column);
        }
      }
    },
    PositionsOfPart(this->Points.rows()));
  atVertices = potential.SolveSingleValued(sources);
  Eigen::MatrixXd response(fluxes.rows(), fluxes.cols());
  ForRanges(
    fluxes.cols(),
    [&](int begin, int end)
    {
      for (Eigen::Index column = begin; column < end; ++column)
      {
        for (Eigen::Index h = 0; h < fluxes.rows(); ++h)
        {
          response(h, column) = atVertices(halves[static_cast<std::size_t>(h)].vertex, column);
        }
      }
    },
    PositionsOfPart(this->Points.rows()));
  return response;
}

PositionEnergy::Curvature PositionEnergy::Differentiate(
  const Configuration& configuration, const Eigen::VectorXd& multipliers) const
{
  PointPotential::Solution solution;
  Eigen::VectorXd regular;
  const Flows flows = this->Solve(configuration, solution, regular);
  auto [ofTurns, ofLogs] = this->FindFactors(flows, regular);
  if (multipliers.size() > 0)
  {
    ofTurns.tail(this->Points.rows() / 2) += (this->GetMidpointInfluence() * multipliers).array();
  }

  // 1. First derivatives of fluxes and means, and the second derivatives of all terms by the
  //    position of one singularity. Those of log(x − b) are −1/y² and its multiples by i and −1,
  //    y = x − b: with 1/y² = a + ic they are −a, c, a for the logarithm and −c, −a, c for the angle.
  const auto count = static_cast<Eigen::Index>(configuration.size());
  const auto halves = static_cast<Eigen::Index>(this->Starts.size());
  Eigen::MatrixXd fluxes(halves, 2 * count);
  Eigen::MatrixXd means(halves, 2 * count);
  Curvature result{ Eigen::MatrixXd::Zero(2 * count, 2 * count), {} };
  const auto add = [&](Eigen::Index j, Eigen::Index l, double s, double t)
  { result.hessian.block<2, 2>(2 * j, 2 * l) += (Eigen::Matrix2d() << -s, t, t, s).finished(); };
  ForRanges(
    count,
    [&, &turnFactors = ofTurns, &logFactors = ofLogs](int first, int last)
    {
      Eigen::ArrayXd x(this->Points.rows());
      Eigen::ArrayXd y(this->Points.rows());
      Eigen::ArrayXd a(this->Points.rows());
      for (Eigen::Index j = first; j < last; ++j)
      {
        const LogSource& log = solution.logs[static_cast<std::size_t>(j)];
        InvertOffsets(this->Points, log.position, x, y);
        for (Eigen::Index h = 0; h < halves; ++h)
        {
          const Eigen::Index start = this->Starts[static_cast<std::size_t>(h)];
          const Eigen::Index end = this->Ends[static_cast<std::size_t>(h)];
          fluxes(h, 2 * j) = log.strength * (y[end] - y[start]);
          fluxes(h, 2 * j + 1) = log.strength * (x[start] - x[end]);
          means(h, 2 * j) = -0.5 * log.strength * (x[start] + x[end]);
          means(h, 2 * j + 1) = -0.5 * log.strength * (y[start] + y[end]);
        }
        a = x * x - y * y;
        x *= -2.0 * y; // c
        add(j, j, log.strength * (turnFactors * x + logFactors * a).sum(),
          log.strength * (logFactors * x - turnFactors * a).sum());
      }
    },
    PositionsOfPart(this->Points.rows()));
  for (Eigen::Index j = 0; j < count; ++j)
  {
    const LogSource& log = solution.logs[static_cast<std::size_t>(j)];
    for (Eigen::Index k = 0; k < multipliers.size(); ++k)
    {
      const std::vector<Point>& path = this->Paths[static_cast<std::size_t>(k)];
      const Eigen::Vector2d change =
        InverseSquare(path.back() - log.position) - InverseSquare(path.front() - log.position);
      add(j, j, log.strength * multipliers[k] * change.y(),
        -log.strength * multipliers[k] * change.x());
    }
    for (std::size_t n = static_cast<std::size_t>(j) + 1; n < solution.logs.size(); ++n)
    {
      const LogSource& other = solution.logs[n];
      const Eigen::Vector2d second = -0.5 * (log.angle + other.angle) * log.strength *
        other.strength * InverseSquare(other.position - log.position);
      add(j, j, second.x(), second.y());
      if (const auto l = static_cast<Eigen::Index>(n); l < count)
      {
        add(l, l, second.x(), second.y());
        add(j, l, -second.x(), -second.y());
        add(l, j, -second.x(), -second.y());
      }
    }
  }

  // 2. Products of first derivatives. W has the quadratic part ½ f·Rf − m·f/2 in the fluxes f and
  //    means m.
  means = this->Respond(fluxes, result.regular) - means;
  Eigen::MatrixXd product(fluxes.cols(), fluxes.cols());
  constexpr Eigen::Index ColumnsOfPart = 16;
  ForRanges(
    product.cols(),
    [&](int begin, int end)
    {
      product.middleCols(begin, end - begin) =
        AdjointProduct(fluxes, means.middleCols(begin, end - begin));
    },
    ColumnsOfPart);
  result.hessian += 0.5 * (product + product.transpose());
  result.regular *= -1.0;
  return result;
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
