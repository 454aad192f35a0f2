#include "OptimizerSymmetry.h"

#include "Segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Tolerance relative to the diagonal, as for the symmetries of the domain itself.
constexpr double SymmetryTolerance = 1e-9;
/// Threshold relative to π: the error of meshes in defects is smaller than the remainder.
constexpr double NearHalfTurn = 0.9;

double DistanceTo(const Loop& loop, const Point& point)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    nearest =
      std::min(nearest, OffsetFromSegment(point, loop[i], loop[(i + 1) % loop.size()]).norm());
  }
  return nearest;
}

/// Returns the island that a symmetry of the domain maps an island to: the one onto which it maps a
/// vertex of the island.
Eigen::Index ImageOf(const PlanarDomain& domain, const Isometry& map, Eigen::Index island)
{
  const Point point = map(domain.loops[static_cast<std::size_t>(island) + 1][0]);
  double nearest = std::numeric_limits<double>::infinity();
  Eigen::Index image = island;
  for (std::size_t loop = 1; loop < domain.loops.size(); ++loop)
  {
    const double distance = DistanceTo(domain.loops[loop], point);
    if (distance < nearest)
    {
      nearest = distance;
      image = static_cast<Eigen::Index>(loop) - 1;
    }
  }
  return image;
}

Eigen::MatrixXd DefectProjection(
  const PlanarDomain& domain, const std::vector<Isometry>& elements, Eigen::Index islands)
{
  Eigen::MatrixXd projection = Eigen::MatrixXd::Zero(islands, islands);
  for (const Isometry& map : elements)
  {
    for (Eigen::Index island = 0; island < islands; ++island)
    {
      projection(island, ImageOf(domain, map, island)) += map.reflects ? -1.0 : 1.0;
    }
  }
  return projection / static_cast<double>(elements.size());
}
}

ConfigurationSymmetry MatchWithBoundary(const PointPotential& potential, const SymmetryGroup& group,
  const Configuration& interior, double distance, const IsometryTest& keeps)
{
  Configuration all = interior;
  const PlanarTopology& topology = potential.GetProblem().Topology();
  for (const auto& [vertex, quarters] : potential.GetProblem().alignment.chosenQuarters)
  {
    all.push_back({ topology.PointAt(vertex), quarters, 0.0 });
  }
  ConfigurationSymmetry symmetry = MatchSymmetry(all, group, distance, keeps);
  for (std::vector<std::size_t>& images : symmetry.images)
  {
    // singularities at the clearance are never images of ones on the boundary
    images.resize(interior.size());
  }
  return symmetry;
}

OptimizerSymmetry TrivialSymmetry(const PointPotential& potential, const Configuration& interior)
{
  const Eigen::Index islands = potential.GetPeriodBasis().cols();
  return { MatchSymmetry(interior, SymmetryGroup(), 0.0),
    Eigen::MatrixXd::Identity(islands, islands) };
}

OptimizerSymmetry FindKeptSymmetry(const PointPotential& potential, const PlanarDomain& domain,
  const Configuration& interior, const IsometryTest& keeps)
{
  if (interior.empty())
  {
    return TrivialSymmetry(potential, interior);
  }
  const double distance = SymmetryTolerance * domain.Diagonal();
  SymmetryGroup group = FindSymmetries(domain);
  OptimizerSymmetry symmetry;
  symmetry.positions = MatchWithBoundary(potential, group, interior, distance, keeps);
  if (!symmetry.IsTrivial() && group.reflects)
  {
    const std::vector<double> defects = potential.Solve(interior).holonomyDefect;
    if (std::any_of(defects.begin(), defects.end(),
          [](double defect) { return std::abs(defect) > NearHalfTurn * Pi; }))
    {
      group.reflects = false;
      symmetry.positions = MatchWithBoundary(potential, group, interior, distance, keeps);
    }
  }
  symmetry.defects = DefectProjection(
    potential.GetDomain(), symmetry.positions.elements, potential.GetPeriodBasis().cols());
  return symmetry;
}
}
