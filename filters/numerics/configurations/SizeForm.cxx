#include "SizeForm.h"

#include "BoundarySingularities.h"
#include "ConfigurationPlacement.h"
#include "DenseProduct.h"
#include "DrillHoles.h"
#include "Error.h"
#include "Parts.h"
#include "PoincareHopf.h"
#include "SegmentSearch.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Weight of sizes, and of the energy relative to it. With the full energy a node costs about 14, which
/// hides pairs that are worth it.
constexpr double SizeWeight = 1e4;
constexpr double EnergyWeight = 0.2;

/// Returns the vertices of a mesh at which sizes change, by at least a quarter of their largest change per
/// distance.
std::vector<bool> FindGraded(const TriangleMesh& mesh, const SizeFunction& size)
{
  constexpr double Part = 0.25;
  constexpr double Noticeable = 0.02; // two percent from quad to quad are no grading
  std::vector<double> sizes;
  for (const Point& point : mesh.points)
  {
    sizes.push_back(size(point));
    if (!(sizes.back() > 0.0))
    {
      throw Error("The target size at " + Describe(point) +
        " is not a positive number; give sizes that are positive in the whole domain.");
    }
  }
  std::vector<double> slopes(sizes.size(), 0.0);
  for (const std::array<int, 3>& triangle : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto from = static_cast<std::size_t>(triangle[i]);
      const auto to = static_cast<std::size_t>(triangle[(i + 1) % 3]);
      const double slope =
        std::abs(sizes[to] - sizes[from]) / (mesh.points[to] - mesh.points[from]).norm();
      slopes[from] = std::max(slopes[from], slope);
      slopes[to] = std::max(slopes[to], slope);
    }
  }
  const double least = std::max(Noticeable, Part * *std::max_element(slopes.begin(), slopes.end()));
  std::vector<bool> isGraded;
  for (const double slope : slopes)
  {
    isGraded.push_back(slope >= least);
  }
  return isGraded;
}

/// Meshes a domain with edges of about the target size where it changes. Sizes change slowly, so that a mesh
/// that is as fine as they are at the vertices of another one is at most a few times too coarse elsewhere.
TriangleMesh MeshFor(const PlanarDomain& domain, const SizeFunction& size, const Progress& progress)
{
  constexpr int MostMeshes = 6;
  constexpr double LittleChange = 1.05;
  DrillOptions options;
  const double usual = ResolveMeshSize(options, domain);
  TriangleMesh mesh = DrillHoles(domain, {}, options, progress);
  for (int i = 0; i < MostMeshes; ++i)
  {
    options.refinements.clear();
    const std::vector<bool> isGraded = FindGraded(mesh, size);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const double length = 1.1 * size(mesh.points[v]);
      if (isGraded[v] && length < usual)
      {
        options.refinements.push_back({ mesh.points[v], length });
      }
    }
    TriangleMesh finer = DrillHoles(domain, {}, options, progress);
    const bool isFineEnough = static_cast<double>(finer.points.size()) <
      LittleChange * static_cast<double>(mesh.points.size());
    mesh = std::move(finer);
    if (isFineEnough)
    {
      break;
    }
  }
  return mesh;
}

/// Returns the areas that the vertices of a mesh represent.
Eigen::VectorXd MassesOf(const TriangleMesh& mesh)
{
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.points.size()));
  for (const auto& triangle : mesh.triangles)
  {
    for (const int vertex : triangle)
    {
      masses[vertex] += TriangleArea(mesh, triangle) / 3.0;
    }
  }
  return masses;
}

/// Returns weights that count half by area and half by quads. Where sizes change counts at least a fifth: it may
/// be small and have few of the quads.
Eigen::VectorXd WeightsOf(
  const TriangleMesh& mesh, const Eigen::VectorXd& masses, const SizeFunction& size)
{
  constexpr double LeastPart = 0.2;
  Eigen::VectorXd quads(masses.size());
  for (Eigen::Index v = 0; v < masses.size(); ++v)
  {
    quads[v] = masses[v] / std::pow(size(mesh.points[static_cast<std::size_t>(v)]), 2);
  }
  Eigen::VectorXd weights = 0.5 * masses / masses.sum() + 0.5 * quads / quads.sum();
  const std::vector<bool> isGraded = FindGraded(mesh, size);
  double part = 0.0;
  for (Eigen::Index v = 0; v < weights.size(); ++v)
  {
    part += isGraded[static_cast<std::size_t>(v)] ? weights[v] : 0.0;
  }
  if (part > 0.0 && part < LeastPart)
  {
    for (Eigen::Index v = 0; v < weights.size(); ++v)
    {
      weights[v] *=
        isGraded[static_cast<std::size_t>(v)] ? LeastPart / part : (1.0 - LeastPart) / (1.0 - part);
    }
  }
  return weights;
}

/// Returns a place far from the boundary that is no vertex, no midpoint and no centre.
Point FindAnchor(const PlanarDomain& domain, const TriangleMesh& mesh)
{
  const SegmentSearch boundary(domain);
  Point deepest = Point::Zero();
  double depth = -1.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Point place = 0.2 * mesh.points[a] + 0.31 * mesh.points[b] + 0.49 * mesh.points[c];
    const double distance = boundary.SignedDistance(place);
    if (distance > depth)
    {
      depth = distance;
      deepest = place;
    }
  }
  return deepest;
}
}

double CountGradedQuads(const PlanarDomain& domain, const SizeFunction& size)
{
  const TriangleMesh mesh = MeshFor(domain, size, {});
  const Eigen::VectorXd masses = MassesOf(mesh);
  const std::vector<bool> isGraded = FindGraded(mesh, size);
  double count = 0.0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    count +=
      isGraded[v] ? masses[static_cast<Eigen::Index>(v)] / std::pow(size(mesh.points[v]), 2) : 0.0;
  }
  return count;
}

double SizeForm::AtSites::SpreadOf(const Eigen::VectorXi& indices) const
{
  const Eigen::VectorXd deviation = this->constant + this->columns * indices.cast<double>();
  return std::sqrt(this->weights.dot(deviation.cwiseAbs2()));
}

SizeForm::SizeForm(
  const PlanarDomain& domain, const SizeSearchOptions& options, const Progress& progress)
  : Size(options.size)
  , Topology(ShareTopology(
      MeshFor(InsertBoundarySingularities(domain, options.given), options.size, progress)))
{
  const TriangleMesh& mesh = this->Topology->mesh;
  const auto count = static_cast<Eigen::Index>(mesh.points.size());
  const Eigen::VectorXd masses = MassesOf(mesh);
  this->Weights = WeightsOf(mesh, masses, this->Size);
  // The mean of log r over a disk of the area m is log(0.35 h) for equilateral triangles of side h.
  constexpr double CoreFactor = 0.35;
  this->SquaredCores = CoreFactor * CoreFactor * 2.0 / std::sqrt(3.0) * masses;

  // Given singularities on the boundary are corners with other indices.
  std::vector<CornerChoice> corners = BoundaryChoices(domain, options.given);
  corners.insert(corners.end(), options.corners.begin(), options.corners.end());
  const int required =
    CountQuarters(this->Topology->AlignedLoops(), 0, options.cornerAngle, corners)
      .requiredInteriorQuarters;
  Configuration given;
  this->Total = required;
  for (const Singularity& one : options.given)
  {
    if (!IsOnBoundary(domain, one.position))
    {
      given.push_back(one);
      this->Total -= one.quarterIndex;
    }
  }
  this->Anchor = FindAnchor(domain, mesh);
  if (this->Total != 0)
  {
    given.push_back({ this->Anchor, this->Total, 0.0 });
  }
  const PlacedConfiguration placed = PlaceConfiguration(*this->Topology, given, corners);
  Alignment alignment = AlignWithBoundary(*this->Topology, placed.corners, required);
  const auto points = std::make_shared<const PointPotential>(
    std::make_shared<const PotentialSolver>(this->Topology), std::move(alignment));
  this->Changes =
    std::make_unique<const StrengthChanges>(std::make_shared<const PositionEnergy>(points), given);
  const PointPotential::Solution solution = points->Solve(given);
  this->Given = this->LogSizes(solution.regular.head(count), solution.logs);
  for (Eigen::Index v = 0; v < count; ++v)
  {
    this->Given[v] -= std::log(this->Size(mesh.points[static_cast<std::size_t>(v)]));
  }
}

Eigen::VectorXd SizeForm::LogSizes(
  const Eigen::VectorXd& regular, const std::vector<LogSource>& logs) const
{
  Eigen::VectorXd sizes = 0.25 * regular;
  for (Eigen::Index v = 0; v < sizes.size(); ++v)
  {
    const Point& place = this->Topology->mesh.points[v];
    for (const LogSource& log : logs)
    {
      sizes[v] += 0.125 * log.strength *
        std::log((place - log.position).squaredNorm() + this->SquaredCores[v]);
    }
  }
  return sizes;
}

SizeForm::AtSites SizeForm::FormAt(const std::vector<Point>& sites, double defectWeight) const
{
  std::vector<StrengthChanges::Place> places;
  for (const Point& site : sites)
  {
    places.push_back({ site, -1 });
  }
  places.push_back({ this->Anchor, -1 });
  const auto count = static_cast<Eigen::Index>(sites.size());
  Eigen::MatrixXd columns;
  StrengthChanges::Form energy = this->Changes->FormAt(places, 1.0, &columns);
  // Cores of the size s.
  for (Eigen::Index i = 0; i < count; ++i)
  {
    energy.matrix(i, i) -= 2.0 * Pi * std::log(this->Size(sites[static_cast<std::size_t>(i)]));
  }
  ForRanges(count + 1,
    [&](int begin, int end)
    {
      for (Eigen::Index i = begin; i < end; ++i)
      {
        const LogSource log{ places[static_cast<std::size_t>(i)].position, 1.0, 2.0 * Pi };
        columns.col(i) = this->LogSizes(columns.col(i), { log });
      }
    });
  AtSites result;
  result.weights = this->Weights;
  result.constant = this->Given - this->Total * columns.col(count);
  result.columns = columns.leftCols(count);
  result.constant.array() -= this->Weights.dot(result.constant);
  result.columns.rowwise() -= (this->Weights.transpose() * result.columns).eval();
  const Eigen::MatrixXd weighted = this->Weights.asDiagonal() * result.columns;
  StrengthChanges::Form& form = result.form.form;
  result.form.total = this->Total;
  // In the indices themselves instead of changes from all of them at the anchor.
  form.linear = EnergyWeight *
      (energy.linear.head(count) - this->Total * energy.matrix.col(count).head(count)) +
    SizeWeight * weighted.transpose() * result.constant;
  form.matrix = EnergyWeight * energy.matrix.topLeftCorner(count, count) +
    SizeWeight * AdjointProduct(result.columns, weighted);
  form.defects = energy.defects - this->Total * energy.defectChanges.col(count);
  form.defectChanges = energy.defectChanges.leftCols(count);
  form.defectEnergy =
    2.0 * defectWeight * Eigen::MatrixXd::Identity(form.defects.size(), form.defects.size());
  return result;
}
}
