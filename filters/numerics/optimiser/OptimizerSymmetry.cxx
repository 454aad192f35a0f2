#include "OptimizerSymmetry.h"

#include "Segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Of the diagonal, as for the symmetries of the domain itself.
constexpr double Rounding = 1e-9;
/// Of half a turn: meshes change defects by less than the rest.
constexpr double HalfTurn = 0.9;

double DistanceTo(const Loop& loop, const Point& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    least = std::min(least, WayFromSegment(place, loop[i], loop[(i + 1) % loop.size()]).norm());
  }
  return least;
}

/// The island that a symmetry of the domain takes an island to: the one that it takes a vertex onto.
Eigen::Index ImageOf(const PlanarDomain& domain, const Isometry& map, Eigen::Index island)
{
  const Point place = map(domain.loops[static_cast<std::size_t>(island) + 1][0]);
  double least = std::numeric_limits<double>::infinity();
  Eigen::Index image = island;
  for (std::size_t loop = 1; loop < domain.loops.size(); ++loop)
  {
    const double distance = DistanceTo(domain.loops[loop], place);
    if (distance < least)
    {
      least = distance;
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
  const MeshTopology& topology = potential.GetProblem().Topology();
  for (const auto& [vertex, quarters] : potential.GetProblem().alignment.chosenQuarters)
  {
    all.push_back({ topology.PointAt(vertex), quarters, 0.0 });
  }
  ConfigurationSymmetry symmetry = MatchSymmetry(all, group, distance, keeps);
  for (std::vector<std::size_t>& images : symmetry.images)
  {
    images.resize(interior.size()); // at the clearance none is the image of one on the boundary
  }
  return symmetry;
}

OptimizerSymmetry NoSymmetry(const PointPotential& potential, const Configuration& interior)
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
    return NoSymmetry(potential, interior);
  }
  const double distance = Rounding * domain.Diagonal();
  SymmetryGroup group = FindSymmetries(domain);
  OptimizerSymmetry symmetry;
  symmetry.places = MatchWithBoundary(potential, group, interior, distance, keeps);
  if (!symmetry.IsTrivial() && group.reflects)
  {
    const std::vector<double> defects = potential.Solve(interior).holonomyDefect;
    if (std::any_of(defects.begin(), defects.end(),
          [](double defect) { return std::abs(defect) > HalfTurn * Pi; }))
    {
      group.reflects = false;
      symmetry.places = MatchWithBoundary(potential, group, interior, distance, keeps);
    }
  }
  symmetry.defects = DefectProjection(
    potential.GetDomain(), symmetry.places.elements, potential.GetPeriodBasis().cols());
  return symmetry;
}
}
