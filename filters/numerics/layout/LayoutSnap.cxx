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
using Pair = std::pair<int, int>; ///< Cones, the smaller number first.

Pair KeyOf(const NearMiss& miss)
{
  return std::minmax(miss.from, miss.to);
}

/// What is to be zero, on one mesh whose vertices at singularities move with them.
class SnapProblem
{
public:
  SnapProblem(const FactoredDomain& domain, Configuration singularities,
    const SeamlessMapOptions& options, double tolerance, const std::set<Pair>& excluded)
    : Singularities(std::move(singularities))
    , Options(options)
    , Mesh(domain.MeshOn(this->Singularities))
  {
    const SeamlessMap map = this->Solve(this->Singularities);
    for (const Cone& cone : map.cones)
    {
      if (cone.row >= 0 && !cone.onBoundary)
      {
        this->Moving.push_back(cone);
      }
    }
    this->Extent = map.Extent();
    std::vector<NearMiss> found = FindNearMisses(TraceLines(map), tolerance);
    // The two lines of a pair that runs towards each other say the same: one is enough.
    std::set<Pair> known;
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

  /// Offsets of lines, then what the holonomy defects have become more.
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

  /// Central differences, since the steps can be that large.
  Eigen::MatrixXd Derivatives(double step, const Progress& progress) const
  {
    const auto count = static_cast<Eigen::Index>(2 * this->Moving.size());
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

  Configuration At(const Eigen::VectorXd& moves) const
  {
    Configuration moved = this->Singularities;
    for (std::size_t i = 0; i < this->Moving.size(); ++i)
    {
      moved[static_cast<std::size_t>(this->Moving[i].row)].position +=
        moves.segment<2>(static_cast<Eigen::Index>(2 * i));
    }
    return moved;
  }

  Eigen::Index Count() const { return static_cast<Eigen::Index>(2 * this->Moving.size()); }

private:
  SeamlessMap Solve(const Configuration& moved) const
  {
    TriangleMesh mesh = this->Mesh;
    for (const Cone& cone : this->Moving)
    {
      mesh.points[static_cast<std::size_t>(cone.vertex)] =
        moved[static_cast<std::size_t>(cone.row)].position;
    }
    return SolveSeamlessMap(ShareTopology(std::move(mesh)), moved, this->Options);
  }

  Configuration Singularities;
  const SeamlessMapOptions& Options;
  TriangleMesh Mesh;
  std::vector<Cone> Moving;
  std::vector<NearMiss> Misses;
  std::vector<double> Defects;
  double Extent = 0.0;
};

/// How a try ended.
struct Trial
{
  Configuration singularities;
  bool arrived = false; ///< All lines meet, and no singularity has moved too far.
};

double LargestMove(const Configuration& from, const Configuration& to)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    largest = std::max(largest, (to[i].position - from[i].position).norm());
  }
  return largest;
}

/// Chord iterations on a few meshes, each with the vertices where the singularities have come to: the last one is then that of a
/// layout of the result.
Trial Try(const FactoredDomain& domain, const Configuration& start, const SeamlessMapOptions& options,
  double tolerance, const std::set<Pair>& excluded, const Progress& progress)
{
  constexpr int Meshes = 6;
  constexpr int Iterations = 12;
  // What the tracer takes for one isoline, and rounding of a map.
  constexpr double Arrived = 1e-13;
  Trial trial;
  trial.singularities = start;
  std::vector<Pair> derived; // what the derivatives are of: they hardly change on the way
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> derivatives;
  // Conditions may follow from each other, as that of the fourth side of a rectangle from the other three; what differences are off by
  // must not make them independent.
  derivatives.setThreshold(1e-3);
  for (int i = 0; i < Meshes; ++i)
  {
    const SnapProblem problem(domain, trial.singularities, options, tolerance, excluded);
    const auto& misses = problem.GetMisses();
    const auto worst = std::max_element(misses.begin(), misses.end(),
      [](const NearMiss& a, const NearMiss& b) { return a.across < b.across; });
    trial.arrived = worst == misses.end() || worst->across <= Arrived * problem.GetExtent();
    if (trial.arrived || problem.Count() == 0)
    {
      return trial;
    }
    // A vertex may move by a good part of an edge; rounding of maps is far below such differences.
    const double furthest = 0.25 * domain.GetMeshSize();
    const double step = 1e-3 * domain.GetMeshSize();
    std::vector<Pair> keys;
    std::transform(misses.begin(), misses.end(), std::back_inserter(keys), KeyOf);
    if (i == 0 || keys != derived)
    {
      derivatives.compute(
        problem.Derivatives(step, progress.Part(0.9 * i / Meshes, 0.9 * (i + 1) / Meshes)));
      derived = std::move(keys);
    }
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(problem.Count());
    for (int j = 0; j < Iterations; ++j)
    {
      const Eigen::VectorXd values = problem.Values(moves);
      if (values.lpNorm<Eigen::Infinity>() <= 0.1 * Arrived * problem.GetExtent())
      {
        break;
      }
      const Eigen::VectorXd next = moves - derivatives.solve(values);
      const double longest = next.lpNorm<Eigen::Infinity>();
      if (longest > furthest)
      {
        moves = next * (furthest / longest);
        break; // and on with another mesh
      }
      moves = next;
    }
    trial.singularities = problem.At(moves);
    if (LargestMove(start, trial.singularities) > tolerance)
    {
      return trial;
    }
  }
  return trial;
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
  // All of them if that is possible, else without the widest ones.
  std::set<Pair> excluded;
  const auto count = static_cast<double>(misses.size());
  for (const NearMiss& widest : misses)
  {
    const Progress part = progress.Part(result.leftOut / count, (result.leftOut + 1) / count);
    Trial trial;
    try
    {
      trial = Try(domain, singularities, options, tolerance, excluded, part);
    }
    catch (const Error&)
    {
      trial.arrived = false; // the way led to singularities that cannot be
    }
    if (trial.arrived)
    {
      result.singularities = trial.singularities;
      result.joined = static_cast<int>(misses.size()) - result.leftOut;
      result.largestMove = LargestMove(singularities, trial.singularities);
      break;
    }
    excluded.insert(KeyOf(widest));
    ++result.leftOut;
  }
  progress.Report(1.0);
  return result;
}
}
