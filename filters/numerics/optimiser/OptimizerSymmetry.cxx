#include "OptimizerSymmetry.h"

#include "CurveSymmetry.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Threshold relative to π: the error of meshes in defects is smaller than the remainder.
constexpr double NearHalfTurn = 0.9;

Eigen::MatrixXd DefectProjection(
  const PlanarDomain& domain, const std::vector<Isometry>& elements, Eigen::Index islands)
{
  Eigen::MatrixXd projection = Eigen::MatrixXd::Zero(islands, islands);
  for (const Isometry& map : elements)
  {
    for (Eigen::Index island = 0; island < islands; ++island)
    {
      const std::size_t image = ImageOfInnerLoop(domain, map, static_cast<std::size_t>(island) + 1);
      projection(island, static_cast<Eigen::Index>(image) - 1) += map.reflects ? -1.0 : 1.0;
    }
  }
  return projection / static_cast<double>(elements.size());
}
}

double WorthOfSymmetries(std::size_t elements)
{
  return 8.0 * std::log(static_cast<double>(elements));
}

double WorthOfSymmetries(const std::vector<Isometry>& kept, const SymmetryGroup& ofDomain)
{
  const bool leans = ofDomain.reflects &&
    std::none_of(kept.begin(), kept.end(), [](const Isometry& map) { return map.reflects; });
  return WorthOfSymmetries(leans ? std::max<std::size_t>(1, kept.size() / 2) : kept.size());
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
  const double distance = SymmetryReach * domain.Diagonal();
  SymmetryGroup group = FindCurveSymmetries(domain);
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
