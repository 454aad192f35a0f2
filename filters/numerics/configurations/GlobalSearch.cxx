#include "GlobalSearch.h"

#include "BoundarySingularities.h"
#include "CornerSets.h"
#include "DrillHoles.h"
#include "IndexSearch.h"
#include "LoopGap.h"
#include "OptimizerStage.h"
#include "OptimizerSymmetry.h"
#include "PoincareHopf.h"
#include "SegmentSearch.h"
#include "StageBoundary.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace crossfield
{
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

namespace
{
/// Returns the changes of the index of a boundary vertex that make it nearer to that of the angle
/// which quads see.
IndexRange RangeAt(const BoundaryVertices& boundary, std::size_t v)
{
  constexpr double Rounding = 1e-6; // of a quarter turn
  const int present = boundary.quarters[v];
  const double quarters = (Pi - boundary.AngleForQuads(v, boundary.vertices.size())) / (0.5 * Pi);
  const int lowest = static_cast<int>(std::floor(quarters + Rounding));
  const int highest = static_cast<int>(std::ceil(quarters - Rounding));
  IndexRange range{ 0, 0 };
  while (present + range.lowest > lowest && boundary.Allows(v, present + range.lowest - 1))
  {
    --range.lowest;
  }
  while (present + range.highest < highest && boundary.Allows(v, present + range.highest + 1))
  {
    ++range.highest;
  }
  return range;
}
}

std::vector<SearchedConfiguration> SearchConfigurations(
  const PlanarDomain& domain, const ProposalOptions& options, const Progress& progress)
{
  const double clearance = SiteClearance(domain);
  constexpr double Narrow = 0.004; // of the diagonal: the lattice of sites is not finer
  if (clearance < Narrow * domain.Diagonal())
  {
    return {};
  }
  const int total =
    CountQuarters(domain.loops, 0, options.cornerAngle, options.corners).requiredInteriorQuarters;
  const double quadSize = options.quadSize > 0.0 ? options.quadSize : QuadsOfDefaultMesh(domain);
  const CandidateSites sites = FindCandidateSites(domain, clearance, quadSize);
  if (sites.inside == 0)
  {
    return {};
  }
  DrillOptions drill;
  const double edge = ResolveMeshSize(drill, domain);
  const SegmentSearch boundary(domain);
  Configuration onBoundary;
  for (std::size_t i = 0; i < sites.positions.size(); ++i)
  {
    const Point& site = sites.positions[i];
    if (i >= sites.inside)
    {
      onBoundary.push_back({ site, 0, 0.0 });
      continue;
    }
    const double length = 0.5 * boundary.SignedDistance(site);
    if (length < edge)
    {
      drill.refinements.push_back({ site, length });
    }
  }
  const SharedPlanarTopology topology = ShareTopology(DrillHoles(
    InsertBoundarySingularities(domain, onBoundary), {}, drill, progress.Part(0.0, 0.3)));
  const Configuration given = { { sites.positions[0], total, 0.0 } };
  const PlacedConfiguration placed = PlaceConfiguration(*topology, given, options.corners);
  Alignment alignment = AlignWithBoundary(*topology, placed.corners, total);
  const auto points = std::make_shared<const PointPotential>(
    std::make_shared<const PotentialSolver>(topology), std::move(alignment));
  const StrengthChanges changes(std::make_shared<const PositionEnergy>(points), given);
  const BoundaryVertices vertices(*points, quadSize);
  std::vector<StrengthChanges::Place> places;
  IndexForm form;
  form.total = total;
  std::vector<int> present; // indices of boundary vertices
  for (std::size_t i = 0; i < sites.positions.size(); ++i)
  {
    const Point& site = sites.positions[i];
    if (i < sites.inside)
    {
      places.push_back({ site, -1 });
      form.ranges.emplace_back();
      present.push_back(0);
      continue;
    }
    const std::size_t v = vertices.At(site);
    const bool isGiven = FindChoice(options.corners, site, domain) != nullptr;
    places.push_back({ site, topology->VertexOf(vertices.vertices[v]) });
    present.push_back(vertices.quarters[v]);
    form.ranges.push_back(isGiven ? IndexRange{ 0, 0 } : RangeAt(vertices, v));
  }
  form.form = changes.FormAt(places, CoreRadius(domain));
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
        const auto site = static_cast<std::size_t>(i);
        result.singularities.push_back(
          { sites.positions[site], present[site] + one.indices[i], 0.0 });
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
