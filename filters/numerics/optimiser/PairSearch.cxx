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
/// Places, and about how far they are from each other.
struct SpacedPlaces
{
  std::vector<Point> places;
  double spacing = 0.0;
};

/// Vertices of the mesh, each the farthest one from those before it and from the singularities.
SpacedPlaces FindPlaces(
  const PointPotential& potential, const Configuration& interior, const PairSearchOptions& options)
{
  std::vector<Point> candidates;
  std::vector<double> room; // to what is taken already
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
      room.push_back(nearest);
    }
  }
  SpacedPlaces result;
  while (result.places.size() < options.places && !candidates.empty())
  {
    const auto farthest = std::max_element(room.begin(), room.end());
    if (*farthest <= options.clearance)
    {
      break;
    }
    result.spacing = *farthest;
    const Point place = candidates[static_cast<std::size_t>(farthest - room.begin())];
    result.places.push_back(place);
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      room[i] = std::min(room[i], (candidates[i] - place).norm());
    }
  }
  return result;
}

/// What one of index 1 at every place adds to H and to the holonomy defects, all less that of the first place.
struct Influences
{
  Eigen::MatrixXd sizes;   ///< At vertices; a column for every place.
  Eigen::MatrixXd defects; ///< Per inner loop.
};

Influences Evaluate(const PointPotential& potential, const SizeUniformity& evenness,
  const Configuration& interior, const std::vector<Point>& places, const Eigen::VectorXd& h,
  const Eigen::VectorXd& defects)
{
  const auto count = static_cast<Eigen::Index>(places.size());
  Influences result{ Eigen::MatrixXd::Zero(h.size(), count),
    Eigen::MatrixXd::Zero(defects.size(), count) };
  for (Eigen::Index p = 1; p < count; ++p)
  {
    Configuration with = interior;
    with.push_back({ places[static_cast<std::size_t>(p)], 1, 0.0 });
    with.push_back({ places[0], -1, 0.0 });
    const PointPotential::Solution solution = potential.Solve(with);
    result.sizes.col(p) = evenness.SizesOf(potential, solution) - h;
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
  const SizeUniformity& evenness, const Configuration& interior, const PairSearchOptions& options)
{
  const auto [places, spacing] = FindPlaces(potential, interior, options);
  const PointPotential::Solution solution = potential.Solve(interior);
  const Eigen::VectorXd h = evenness.SizesOf(potential, solution);
  const Eigen::VectorXd defects = Eigen::Map<const Eigen::VectorXd>(
    solution.holonomyDefect.data(), static_cast<Eigen::Index>(solution.holonomyDefect.size()));
  const Influences all = Evaluate(potential, evenness, interior, places, h, defects);

  // J of every pair from products.
  const Eigen::VectorXd weighted = evenness.GetMasses().cwiseProduct(h);
  const double energy = 0.5 * weighted.dot(h);
  const Eigen::VectorXd slope = all.sizes.transpose() * weighted;
  const Eigen::MatrixXd gram =
    all.sizes.transpose() * evenness.GetMasses().asDiagonal() * all.sizes;
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
      pair.positive = places[static_cast<std::size_t>(x)];
      pair.negative = places[static_cast<std::size_t>(y)];
      pair.energy =
        energy + slope[x] - slope[y] + 0.5 * (gram(x, x) + gram(y, y) - 2.0 * gram(x, y));
      pair.score = pair.energy;
      for (Eigen::Index k = 0; k < defects.size(); ++k)
      {
        const double defect = WrapAngle(defects[k] + all.defects(k, x) - all.defects(k, y));
        pair.largestDefect = std::max(pair.largestDefect, std::abs(defect));
        pair.score += 0.25 * defect * defect;
      }
      pairs.push_back(pair);
    }
  }

  std::stable_sort(pairs.begin(), pairs.end(),
    [](const SingularityPair& a, const SingularityPair& b) { return a.score < b.score; });
  constexpr double Apart = 2.0; // of the spacing; nearer ones end at the same minimum, as a rule
  std::vector<SingularityPair> best;
  for (const SingularityPair& pair : pairs)
  {
    if (best.size() == options.count)
    {
      break;
    }
    if (std::none_of(best.begin(), best.end(),
          [&pair, distance = Apart * spacing](const SingularityPair& better)
          { return AreNear(better, pair, distance); }))
    {
      best.push_back(pair);
    }
  }
  return best;
}
}
