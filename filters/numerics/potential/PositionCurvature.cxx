#include "PositionCurvature.h"

#include "DenseProduct.h"
#include "Parts.h"

namespace crossfield
{
namespace
{
/// Returns the real and imaginary part of 1/y², y as a complex number.
Eigen::Vector2d InverseSquare(const Point& y)
{
  const Eigen::Vector2d inverse = y / y.squaredNorm();
  return { inverse.x() * inverse.x() - inverse.y() * inverse.y(),
    -2.0 * inverse.x() * inverse.y() };
}

/// Returns the response of R on every half to fluxes through the halves, and sets R at vertices.
Eigen::MatrixXd Respond(const PointPotential& points, const BoundarySamples& samples,
  const Eigen::MatrixXd& fluxes, Eigen::MatrixXd& atVertices)
{
  const std::vector<BoundaryHalf>& halves = points.GetHalves();
  const PotentialSolver& potential = *points.GetProblem().potential;
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
          sources(halves[h].vertex, column) += fluxes(h, column);
        }
      }
    },
    samples.SingularitiesOfPart());
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
          response(h, column) = atVertices(halves[h].vertex, column);
        }
      }
    },
    samples.SingularitiesOfPart());
  return response;
}

}

PositionCurvature Differentiate(const PositionEnergy& energy, const Configuration& configuration,
  const Eigen::VectorXd& multipliers)
{
  const BoundarySamples& samples = energy.Samples;
  PointPotential::Solution solution;
  Eigen::VectorXd regular;
  const PositionEnergy::Flows flows = energy.Solve(configuration, solution, regular);
  auto [ofTurns, ofLogs] = energy.FindFactors(flows, regular);
  if (multipliers.size() > 0)
  {
    ofTurns.tail(samples.points.rows() / 2) +=
      (energy.GetMidpointInfluence() * multipliers).array();
  }

  // 1. First derivatives of fluxes and means, and the second derivatives of all terms by the
  //    position of one singularity. Those of log(x − b) are −1/y² and its multiples by i and −1,
  //    y = x − b: with 1/y² = a + ic they are −a, c, a for the logarithm and −c, −a, c for the angle.
  const auto count = static_cast<Eigen::Index>(configuration.size());
  const auto halves = static_cast<Eigen::Index>(samples.starts.size());
  Eigen::MatrixXd fluxes(halves, 2 * count);
  Eigen::MatrixXd means(halves, 2 * count);
  PositionCurvature result{ Eigen::MatrixXd::Zero(2 * count, 2 * count), {} };
  const auto add = [&](Eigen::Index j, Eigen::Index l, double s, double t)
  { result.hessian.block<2, 2>(2 * j, 2 * l) += (Eigen::Matrix2d() << -s, t, t, s).finished(); };
  ForRanges(
    count,
    [&, &turnFactors = ofTurns, &logFactors = ofLogs](int first, int last)
    {
      Eigen::ArrayXd x(samples.points.rows());
      Eigen::ArrayXd y(samples.points.rows());
      Eigen::ArrayXd a(samples.points.rows());
      for (Eigen::Index j = first; j < last; ++j)
      {
        const LogSource& log = solution.logs[j];
        samples.InvertOffsets(log.position, x, y);
        for (Eigen::Index h = 0; h < halves; ++h)
        {
          const Eigen::Index start = samples.starts[h];
          const Eigen::Index end = samples.ends[h];
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
    samples.SingularitiesOfPart());
  for (Eigen::Index j = 0; j < count; ++j)
  {
    const LogSource& log = solution.logs[j];
    for (Eigen::Index k = 0; k < multipliers.size(); ++k)
    {
      const std::vector<Point>& path = energy.Paths[k];
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
  means = Respond(*energy.Potential, samples, fluxes, result.regular) - means;
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
}
