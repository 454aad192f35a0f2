#include "GlobalSearch.h"

#include "DrillHoles.h"
#include "HolePattern.h"
#include "IndexSearch.h"
#include "OptimizerStage.h"
#include "OptimizerSymmetry.h"
#include "PoincareHopf.h"
#include "SegmentSearch.h"

#include <algorithm>
#include <memory>

namespace crossfield
{
double SiteClearance(const PlanarDomain& domain)
{
  double clearance = 0.01 * domain.Diagonal();
  std::vector<RoundHole> holes = FindRoundHoles(domain);
  if (!holes.empty())
  {
    const auto middle = holes.begin() + static_cast<std::ptrdiff_t>(holes.size() / 2);
    std::nth_element(holes.begin(), middle, holes.end(),
      [](const RoundHole& a, const RoundHole& b) { return a.gap < b.gap; });
    clearance = std::min(clearance, 0.25 * middle->gap);
  }
  return clearance;
}

std::vector<SearchedConfiguration> SearchConfigurations(const PlanarDomain& domain,
  const std::vector<CornerChoice>& corners, double cornerAngle, const Progress& progress)
{
  const double clearance = SiteClearance(domain);
  constexpr double Narrow = 0.001; // of the diagonal: a mesh of such edges would be large
  if (clearance < Narrow * domain.Diagonal())
  {
    return {};
  }
  const int total = CountQuarters(domain.loops, 0, cornerAngle, corners).requiredInteriorQuarters;
  const CandidateSites sites = FindCandidateSites(domain, clearance);
  if (sites.positions.empty())
  {
    return {};
  }
  DrillOptions drill;
  const double edge = ResolveMeshSize(drill, domain);
  const SegmentSearch boundary(domain);
  for (const Point& site : sites.positions)
  {
    const double length = 0.5 * boundary.SignedDistance(site);
    if (length < edge)
    {
      drill.refinements.push_back({ site, length });
    }
  }
  const SharedPlanarTopology topology =
    ShareTopology(DrillHoles(domain, {}, drill, progress.Part(0.0, 0.3)));
  const Configuration given = { { sites.positions[0], total, 0.0 } };
  const PlacedConfiguration placed = PlaceConfiguration(*topology, given, corners);
  Alignment alignment = AlignWithBoundary(*topology, placed.corners, total);
  const auto points = std::make_shared<const PointPotential>(
    std::make_shared<const PotentialSolver>(topology), std::move(alignment));
  const StrengthChanges changes(std::make_shared<const PositionEnergy>(points), given);
  std::vector<StrengthChanges::Place> places;
  for (const Point& site : sites.positions)
  {
    places.push_back({ site, -1 });
  }
  IndexForm form{ changes.FormAt(places, CoreRadius(domain)), total };
  // In the indices themselves instead of changes.
  form.form.linear -= total * form.form.matrix.col(0);
  form.form.defects -= total * form.form.defectChanges.col(0);
  progress.Report(0.7);
  std::vector<SearchedConfiguration> found;
  constexpr double ApartFactor = 2.0;
  for (const SiteIndices& one : SearchIndices(sites, form, ApartFactor * clearance))
  {
    SearchedConfiguration result;
    for (Eigen::Index i = 0; i < one.indices.size(); ++i)
    {
      if (one.indices[i] != 0)
      {
        result.singularities.push_back(
          { sites.positions[static_cast<std::size_t>(i)], one.indices[i], 0.0 });
      }
    }
    result.symmetries = one.symmetries;
    result.objective = one.energy - WorthOfSymmetries(one.symmetries);
    found.push_back(std::move(result));
  }
  progress.Report(1.0);
  return found;
}
}
