#include "GlobalSearch.h"

#include "BoundaryCorners.h"
#include "CandidateSites.h"
#include "DrillHoles.h"
#include "HolePattern.h"
#include "IndexSearch.h"
#include "LoopArc.h"
#include "LoopGap.h"
#include "OptimizerStage.h"
#include "PoincareHopf.h"
#include "SegmentSearch.h"
#include "StageBoundary.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace crossfield
{
namespace
{
/// Returns whether the boundary turns like a corner within quads where there is none, as at the end of
/// a profile. Minima of the energy have singularities in the boundary there, where the search has no
/// sites. Quads around circles have even rows without them.
bool HasRoundedCorners(const PlanarDomain& domain, double quadSize, double cornerAngle)
{
  for (const Loop& loop : domain.loops)
  {
    if (CircleOf(loop))
    {
      continue;
    }
    const LoopArc arc(loop);
    const double step = PartSeen * QuadSizeAt(quadSize, arc.Length());
    const std::vector<double> turns = arc.Turns();
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      if (IsCorner(turns[i], cornerAngle))
      {
        corners.push_back(i);
      }
    }
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const double at = arc.Start(i);
      const double seen = AngleBetween(loop[i] - arc.At(at - step), arc.At(at + step) - loop[i]);
      double turn = seen; // besides one corner
      for (const std::size_t corner : corners)
      {
        const double along = std::abs(arc.Start(corner) - at);
        const bool isSeen = std::min(along, arc.Length() - along) < step;
        const double other = seen - turns[corner];
        turn = isSeen && std::abs(other) < std::abs(turn) ? other : turn;
      }
      if (IsCorner(turn, cornerAngle))
      {
        return true;
      }
    }
  }
  return false;
}
}

double SiteClearance(const PlanarDomain& domain)
{
  double clearance = 0.01 * domain.Diagonal();
  std::vector<double> gaps;
  for (std::size_t loop = 1; loop < domain.loops.size(); ++loop)
  {
    gaps.push_back(GapAround(domain, loop));
  }
  if (!gaps.empty())
  {
    const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
    std::nth_element(gaps.begin(), middle, gaps.end());
    clearance = std::min(clearance, 0.25 * *middle);
  }
  return clearance;
}

std::vector<SearchedConfiguration> SearchConfigurations(
  const PlanarDomain& domain, const ProposalOptions& options, const Progress& progress)
{
  const double clearance = SiteClearance(domain);
  constexpr double Narrow = 0.004; // of the diagonal: the lattice of sites is not finer
  const double quadSize = options.quadSize > 0.0 ? options.quadSize : QuadsOfDefaultMesh(domain);
  if (clearance < Narrow * domain.Diagonal() ||
    HasRoundedCorners(domain, quadSize, options.cornerAngle))
  {
    return {};
  }
  const int total =
    CountQuarters(domain.loops, 0, options.cornerAngle, options.corners).requiredInteriorQuarters;
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
  const PlacedConfiguration placed = PlaceConfiguration(*topology, given, options.corners);
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
  for (const SiteIndices& one :
    SearchIndices(sites, form, ApartFactor * clearance, progress.Part(0.7, 1.0)))
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
    result.symmetries = one.kept.size();
    result.objective = one.objective;
    found.push_back(std::move(result));
  }
  progress.Report(1.0);
  return found;
}
}
