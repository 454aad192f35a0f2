#include "PairSearch.h"

#include "DomainQueries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// Positions and their approximate spacing.
struct SpacedPositions
{
  std::vector<Point> positions;
  double spacing = 0.0;
};

/// Selects vertices of the mesh, each the farthest from the previous ones and from the
/// singularities.
SpacedPositions FindPositions(
  const PointPotential& potential, const Configuration& interior, const PairSearchOptions& options)
{
  std::vector<Point> candidates;
  std::vector<double> distances; // to singularities and selected positions
  for (const Point& point : potential.GetProblem().Topology().mesh.points)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Singularity& singularity : interior)
    {
      nearest = std::min(nearest, (singularity.position - point).norm());
    }
    if (nearest > options.clearance &&
      SignedDistance(point, potential.GetDomain()) > options.clearance)
    {
      candidates.push_back(point);
      distances.push_back(nearest);
    }
  }
  SpacedPositions result;
  while (result.positions.size() < options.positions && !candidates.empty())
  {
    const auto farthest = std::max_element(distances.begin(), distances.end());
    if (*farthest <= options.clearance)
    {
      break;
    }
    result.spacing = *farthest;
    const Point position = candidates[farthest - distances.begin()];
    result.positions.push_back(position);
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      distances[i] = std::min(distances[i], (candidates[i] - position).norm());
    }
  }
  return result;
}

/// Contribution of a singularity of index 1 at each position to H and to the holonomy defects,
/// relative to the first position.
struct PositionInfluences
{
  Eigen::MatrixXd sizes;   ///< At vertices, one column per position.
  Eigen::MatrixXd defects; ///< One row per inner loop.
};

PositionInfluences Evaluate(const PointPotential& potential, const SizeUniformity& uniformity,
  const Configuration& interior, const std::vector<Point>& positions, const Eigen::VectorXd& h,
  const Eigen::VectorXd& defects)
{
  const auto count = static_cast<Eigen::Index>(positions.size());
  PositionInfluences result{ Eigen::MatrixXd::Zero(h.size(), count),
    Eigen::MatrixXd::Zero(defects.size(), count) };
  for (Eigen::Index p = 1; p < count; ++p)
  {
    Configuration extended = interior;
    extended.push_back({ positions[p], 1, 0.0 });
    extended.push_back({ positions[0], -1, 0.0 });
    const PointPotential::Solution solution = potential.Solve(extended);
    result.sizes.col(p) = uniformity.LogSizeDeviations(potential, solution) - h;
    result.defects.col(p) = Eigen::Map<const Eigen::VectorXd>(solution.holonomyDefect.data(),
                              static_cast<Eigen::Index>(solution.holonomyDefect.size())) -
      defects;
  }
  return result;
}

bool AreNear(const SingularityPair& a, const SingularityPair& b, double distance)
{
  return (a.positive - b.positive).norm() < distance && (a.negative - b.negative).norm() < distance;
}
}

std::vector<SingularityPair> FindPairs(const PointPotential& potential,
  const SizeUniformity& uniformity, const Configuration& interior, const PairSearchOptions& options)
{
  const auto [positions, spacing] = FindPositions(potential, interior, options);
  const PointPotential::Solution solution = potential.Solve(interior);
  const Eigen::VectorXd h = uniformity.LogSizeDeviations(potential, solution);
  const Eigen::VectorXd defects = Eigen::Map<const Eigen::VectorXd>(
    solution.holonomyDefect.data(), static_cast<Eigen::Index>(solution.holonomyDefect.size()));
  const PositionInfluences influences =
    Evaluate(potential, uniformity, interior, positions, h, defects);

  // J for each pair, from products.
  const Eigen::VectorXd weighted = uniformity.GetMasses().cwiseProduct(h);
  const double energy = 0.5 * weighted.dot(h);
  const Eigen::VectorXd slope = influences.sizes.transpose() * weighted;
  const Eigen::MatrixXd gram =
    influences.sizes.transpose() * uniformity.GetMasses().asDiagonal() * influences.sizes;
  std::vector<SingularityPair> pairs;
  for (Eigen::Index x = 0; x < slope.size(); ++x)
  {
    for (Eigen::Index y = 0; y < slope.size(); ++y)
    {
      if (x == y)
      {
        continue;
      }
      SingularityPair pair;
      pair.positive = positions[x];
      pair.negative = positions[y];
      pair.energy =
        energy + slope[x] - slope[y] + 0.5 * (gram(x, x) + gram(y, y) - 2.0 * gram(x, y));
      pair.score = pair.energy;
      for (Eigen::Index k = 0; k < defects.size(); ++k)
      {
        const double defect =
          WrapAngle(defects[k] + influences.defects(k, x) - influences.defects(k, y));
        pair.largestDefect = std::max(pair.largestDefect, std::abs(defect));
        pair.score += 0.25 * defect * defect;
      }
      pairs.push_back(pair);
    }
  }

  std::stable_sort(pairs.begin(), pairs.end(),
    [](const SingularityPair& a, const SingularityPair& b) { return a.score < b.score; });
  // relative to the spacing; closer pairs usually converge to the same minimum
  constexpr double MinimumSpacing = 2.0;
  std::vector<SingularityPair> best;
  for (const SingularityPair& pair : pairs)
  {
    if (best.size() == options.count)
    {
      break;
    }
    if (std::none_of(best.begin(), best.end(),
          [&pair, distance = MinimumSpacing * spacing](const SingularityPair& better)
          { return AreNear(better, pair, distance); }))
    {
      best.push_back(pair);
    }
  }
  return best;
}
}
