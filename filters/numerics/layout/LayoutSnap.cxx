#include "LayoutSnap.h"

#include "Error.h"
#include "NearMisses.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
using ConePair = std::pair<int, int>; ///< Two cones, the smaller number first.

ConePair KeyOf(const NearMiss& miss)
{
  return std::minmax(miss.from, miss.to);
}

/// Functions of the positions that should vanish, on one mesh whose vertices at singularities move
/// with them.
class SnapProblem
{
public:
  SnapProblem(const FactoredDomain& domain, Configuration singularities,
    const SeamlessMapOptions& options, double tolerance, const std::set<ConePair>& excluded)
    : Singularities(std::move(singularities))
    , Options(options)
    , Mesh(domain.MeshOn(this->Singularities))
  {
    const SeamlessMap map = this->Solve(this->Singularities);
    for (const Cone& cone : map.cones)
    {
      if (cone.row >= 0 && !cone.onBoundary)
      {
        this->MovingCones.push_back(cone);
      }
    }
    this->Extent = map.Extent();
    std::vector<NearMiss> found = FindNearMisses(TraceSeparatrices(map), tolerance);
    // Two separatrices that run towards each other give the same condition: one is enough.
    std::set<ConePair> known;
    for (NearMiss& miss : found)
    {
      if (excluded.count(KeyOf(miss)) == 0 && known.insert(KeyOf(miss)).second)
      {
        this->Misses.push_back(std::move(miss));
      }
    }
    std::sort(this->Misses.begin(), this->Misses.end(),
      [](const NearMiss& a, const NearMiss& b) { return KeyOf(a) < KeyOf(b); });
    this->Defects = map.holonomyDefect;
  }

  const std::vector<NearMiss>& GetMisses() const { return this->Misses; }
  const Configuration& GetSingularities() const { return this->Singularities; }
  double GetExtent() const { return this->Extent; }

  /// Returns the offsets of separatrices, followed by the changes of the holonomy defects.
  Eigen::VectorXd Values(const Eigen::VectorXd& moves) const
  {
    const SeamlessMap map = this->Solve(this->At(moves));
    Eigen::VectorXd values(static_cast<Eigen::Index>(this->Misses.size() + this->Defects.size()));
    Eigen::Index row = 0;
    for (const NearMiss& miss : this->Misses)
    {
      values[row++] = miss.Offset(map);
    }
    for (std::size_t k = 0; k < this->Defects.size(); ++k)
    {
      values[row++] = WrapAngle(map.holonomyDefect[k] - this->Defects[k]);
    }
    return values;
  }

  /// Computes the derivatives by central differences, which remain accurate for large steps.
  Eigen::MatrixXd Derivatives(double step, const Progress& progress) const
  {
    const auto count = static_cast<Eigen::Index>(2 * this->MovingCones.size());
    Eigen::MatrixXd derivatives(
      static_cast<Eigen::Index>(this->Misses.size() + this->Defects.size()), count);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const Eigen::VectorXd move = step * Eigen::VectorXd::Unit(count, j);
      derivatives.col(j) = (this->Values(move) - this->Values(-move)) / (2.0 * step);
      progress.Report(static_cast<double>(j + 1) / static_cast<double>(count));
    }
    return derivatives;
  }

  /// Returns the singularities displaced by the moves.
  Configuration At(const Eigen::VectorXd& moves) const
  {
    Configuration moved = this->Singularities;
    for (std::size_t i = 0; i < this->MovingCones.size(); ++i)
    {
      moved[static_cast<std::size_t>(this->MovingCones[i].row)].position +=
        moves.segment<2>(static_cast<Eigen::Index>(2 * i));
    }
    return moved;
  }

  /// Returns the number of coordinates of singularities that may move.
  Eigen::Index CoordinateCount() const
  {
    return static_cast<Eigen::Index>(2 * this->MovingCones.size());
  }

private:
  SeamlessMap Solve(const Configuration& moved) const
  {
    TriangleMesh mesh = this->Mesh;
    for (const Cone& cone : this->MovingCones)
    {
      mesh.points[static_cast<std::size_t>(cone.vertex)] =
        moved[static_cast<std::size_t>(cone.row)].position;
    }
    return SolveSeamlessMap(ShareTopology(std::move(mesh)), moved, this->Options);
  }

  Configuration Singularities;
  const SeamlessMapOptions& Options;
  TriangleMesh Mesh;
  std::vector<Cone> MovingCones;
  std::vector<NearMiss> Misses;
  std::vector<double> Defects;
  double Extent = 0.0;
};

/// Result of an attempt to join separatrices.
struct Attempt
{
  Configuration singularities;
  bool joined = false; ///< Whether all separatrices meet, and no singularity has moved too far.
};

/// Returns the maximum distance between corresponding singularities.
double LargestMove(const Configuration& from, const Configuration& to)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    largest = std::max(largest, (to[i].position - from[i].position).norm());
  }
  return largest;
}

/// Tries to join all near misses except the excluded ones. Iterates with constant derivatives
/// (chord method) on a sequence of meshes, each with vertices at the present positions; the last
/// mesh is that of a layout of the result.
Attempt TryToJoin(const FactoredDomain& domain, const Configuration& start,
  const SeamlessMapOptions& options, double tolerance, const std::set<ConePair>& excluded,
  const Progress& progress)
{
  constexpr int MaximumMeshes = 6;
  constexpr int MaximumIterations = 12;
  // Distance that the tracer considers as one isoline, and the rounding of a map.
  constexpr double Tolerance = 1e-13;
  Attempt attempt;
  attempt.singularities = start;
  // Near misses for which the derivatives were computed; these hardly change between meshes.
  std::vector<ConePair> differentiated;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> derivatives;
  // Conditions may be dependent, as the fourth side of a rectangle follows from the other three;
  // errors of differences must not make them independent.
  derivatives.setThreshold(1e-3);
  for (int i = 0; i < MaximumMeshes; ++i)
  {
    const SnapProblem problem(domain, attempt.singularities, options, tolerance, excluded);
    const auto& misses = problem.GetMisses();
    const auto worst = std::max_element(misses.begin(), misses.end(),
      [](const NearMiss& a, const NearMiss& b) { return a.across < b.across; });
    attempt.joined = worst == misses.end() || worst->across <= Tolerance * problem.GetExtent();
    if (attempt.joined || problem.CoordinateCount() == 0)
    {
      return attempt;
    }
    // A vertex may move by a considerable fraction of an edge; differences of this step are far
    // above the rounding of maps.
    const double longestMove = 0.25 * domain.GetMeshSize();
    const double step = 1e-3 * domain.GetMeshSize();
    std::vector<ConePair> keys;
    std::transform(misses.begin(), misses.end(), std::back_inserter(keys), KeyOf);
    if (i == 0 || keys != differentiated)
    {
      derivatives.compute(problem.Derivatives(
        step, progress.Part(0.9 * i / MaximumMeshes, 0.9 * (i + 1) / MaximumMeshes)));
      differentiated = std::move(keys);
    }
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(problem.CoordinateCount());
    for (int j = 0; j < MaximumIterations; ++j)
    {
      const Eigen::VectorXd values = problem.Values(moves);
      if (values.lpNorm<Eigen::Infinity>() <= 0.1 * Tolerance * problem.GetExtent())
      {
        break;
      }
      const Eigen::VectorXd next = moves - derivatives.solve(values);
      const double longest = next.lpNorm<Eigen::Infinity>();
      if (longest > longestMove)
      {
        moves = next * (longestMove / longest);
        break; // continue with another mesh
      }
      moves = next;
    }
    attempt.singularities = problem.At(moves);
    if (LargestMove(start, attempt.singularities) > tolerance)
    {
      return attempt;
    }
  }
  return attempt;
}
}

LayoutSnap SnapLayout(const FactoredDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double tolerance, const Progress& progress)
{
  LayoutSnap result;
  result.singularities = singularities;
  std::vector<NearMiss> misses =
    SnapProblem(domain, singularities, options, tolerance, {}).GetMisses();
  misses.erase(
    std::remove_if(misses.begin(), misses.end(), [](const NearMiss& miss) { return miss.meets; }),
    misses.end());
  std::stable_sort(misses.begin(), misses.end(),
    [](const NearMiss& a, const NearMiss& b) { return a.across > b.across; });
  // Join all near misses if possible, otherwise all but the widest ones.
  std::set<ConePair> excluded;
  const auto count = static_cast<double>(misses.size());
  for (const NearMiss& widest : misses)
  {
    const Progress part = progress.Part(result.leftOut / count, (result.leftOut + 1) / count);
    Attempt attempt;
    try
    {
      attempt = TryToJoin(domain, singularities, options, tolerance, excluded, part);
    }
    catch (const Error&)
    {
      attempt.joined = false; // the iteration led to an invalid configuration
    }
    if (attempt.joined)
    {
      result.singularities = attempt.singularities;
      result.joined = static_cast<int>(misses.size()) - result.leftOut;
      result.largestMove = LargestMove(singularities, attempt.singularities);
      break;
    }
    excluded.insert(KeyOf(widest));
    ++result.leftOut;
  }
  progress.Report(1.0);
  return result;
}
}
