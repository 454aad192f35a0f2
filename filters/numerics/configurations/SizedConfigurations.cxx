#include "SizedConfigurations.h"

#include "CandidateSites.h"
#include "IndexSearch.h"
#include "SizeForm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Weights of holonomy defects, of which a tenth counts without symmetries (MakeOrbitForm). In the search it is
/// small: otherwise no pair would pay, since at sites its defects do not vanish.
constexpr double WeightOfDefects = 250.0;
constexpr double WeightWhenRefined = 25000.0;
/// Minimum distance of two singularities, in target sizes.
constexpr double Apart = 1.6;
constexpr double ApartWhenRefined = 1.2;

/// Returns the symmetries of a domain that preserve its target sizes: log s at the images of the vertices
/// differs by at most 0.02 in the root mean square.
SymmetryGroup SymmetriesOf(
  const PlanarDomain& domain, const TriangleMesh& mesh, const SizeFunction& size)
{
  constexpr double Noticeable = 0.02;
  const SymmetryGroup all = SearchedSymmetries(domain);
  SymmetryGroup kept;
  kept.centre = all.centre;
  kept.order = 0;
  for (const Isometry& map : all.Elements())
  {
    double squares = 0.0;
    for (const Point& point : mesh.points)
    {
      squares += std::pow(std::log(size(map(point)) / size(point)), 2);
    }
    if (squares > Noticeable * Noticeable * static_cast<double>(mesh.points.size()))
    {
      continue;
    }
    if (map.reflects && !kept.reflects)
    {
      kept.reflects = true;
      kept.axis = 0.5 * map.angle;
    }
    kept.order += map.reflects ? 0 : 1;
  }
  kept.axis = std::fmod(kept.axis + 2.0 * Pi, Pi / kept.order);
  return kept;
}

/// Returns which places are closer to each other than a factor of the larger of their sizes.
SitePairs NearPairs(const std::vector<Point>& places, const SizeFunction& size, double factor)
{
  const auto count = static_cast<Eigen::Index>(places.size());
  std::vector<double> reach;
  for (const Point& place : places)
  {
    reach.push_back(factor * size(place));
  }
  SitePairs isNear(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      const double apart = std::max(reach[a], reach[b]);
      isNear(i, j) = i != j && (places[a] - places[b]).squaredNorm() < apart * apart ? 1 : 0;
    }
  }
  return isNear;
}

Configuration ConfigurationOf(const std::vector<Point>& positions, const Eigen::VectorXi& indices)
{
  Configuration configuration;
  for (Eigen::Index i = 0; i < indices.size(); ++i)
  {
    if (indices[i] != 0)
    {
      configuration.push_back({ positions[static_cast<std::size_t>(i)], indices[i], 0.0 });
    }
  }
  return configuration;
}

/// Moves singularities to the best of nine places each, which are closer together from round to round.
SizedConfiguration Refine(const PlanarDomain& domain, const SizeForm& form,
  const SizeSearchOptions& options, const std::vector<Isometry>& symmetries,
  const Configuration& start)
{
  const SizeFunction& size = options.size;
  SizedConfiguration result{ start, 0.0, symmetries.size() };
  Subgroup all;
  for (std::size_t g = 0; g < symmetries.size(); ++g)
  {
    all.push_back(g);
  }
  for (const double radius : { 0.8, 0.5, 0.5, 0.3, 0.2 }) // target sizes
  {
    std::vector<Point> places;
    for (const Singularity& one : result.singularities)
    {
      places.push_back(one.position);
    }
    for (const Singularity& one : result.singularities)
    {
      for (int direction = 0; direction < 8; ++direction)
      {
        const double angle = 0.25 * Pi * direction;
        const Point place =
          one.position + radius * size(one.position) * Point(std::cos(angle), std::sin(angle));
        if (!options.isFree || options.isFree(place))
        {
          places.push_back(place);
        }
      }
    }
    const CandidateSites sites =
      CloseUnderSymmetries(domain, symmetries, places, result.singularities.size(), size);
    Eigen::VectorXi indices =
      Eigen::VectorXi::Zero(static_cast<Eigen::Index>(sites.positions.size()));
    for (const Singularity& one : result.singularities)
    {
      const auto nearest = std::min_element(sites.positions.begin(), sites.positions.end(),
        [&](const Point& a, const Point& b)
        { return (a - one.position).squaredNorm() < (b - one.position).squaredNorm(); });
      indices[nearest - sites.positions.begin()] = one.quarterIndex;
    }
    const SizeForm::AtSites local = form.FormAt(sites.positions, WeightWhenRefined);
    const SiteIndices moved = ShiftIndices(
      sites, local.form, NearPairs(sites.positions, size, ApartWhenRefined), indices, all);
    result.singularities = ConfigurationOf(sites.positions, moved.indices);
    result.spread = local.SpreadOf(moved.indices);
  }
  return result;
}
}

double SpreadOfSizes(const PlanarDomain& domain, const SizeSearchOptions& options)
{
  return SizeForm(domain, options, {}).FormAt({}, WeightOfDefects).SpreadOf(Eigen::VectorXi());
}

std::vector<SizedConfiguration> SearchForSizes(
  const PlanarDomain& domain, const SizeSearchOptions& options, const Progress& progress)
{
  const SizeForm form(domain, options, progress.Part(0.0, 0.2));
  const TriangleMesh& mesh = form.Mesh();
  std::vector<Point> places = mesh.points;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    places.push_back((mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0);
  }
  const auto isTaken = [&](const Point& place)
  {
    return (options.isFree && !options.isFree(place)) ||
      std::any_of(options.given.begin(), options.given.end(),
        [&](const Singularity& given)
        { return (place - given.position).norm() < Apart * options.size(given.position); });
  };
  places.erase(std::remove_if(places.begin(), places.end(), isTaken), places.end());
  // Given singularities may have no symmetry.
  const SymmetryGroup symmetries =
    options.given.empty() ? SymmetriesOf(domain, mesh, options.size) : SymmetryGroup();
  const CandidateSites sites = FindSitesForSizes(domain, symmetries, places, options.size);
  if (sites.positions.empty())
  {
    return {};
  }
  const SizeForm::AtSites atSites = form.FormAt(sites.positions, WeightOfDefects);
  progress.Report(0.5);
  const std::vector<double> costs = { 100.0, 40.0, 15.0, 6.0, 2.5 };
  // Nearly all meshes with less have 90 % of their area and of their quads within 25 % of the target size.
  constexpr double Enough = 0.15;
  struct Candidate
  {
    SiteIndices indices;
    int nodes = 0;
    double spread = 0.0;
  };
  std::vector<Candidate> candidates;
  for (SiteIndices& found : SearchIndicesAtCosts(
         sites, atSites.form, NearPairs(sites.positions, options.size, Apart), costs,
         [&](const Eigen::VectorXi& indices) { return atSites.SpreadOf(indices) <= Enough; },
         progress.Part(0.5, 0.7)))
  {
    const double spread = atSites.SpreadOf(found.indices);
    const int nodes = found.indices.cwiseAbs().sum();
    candidates.push_back({ std::move(found), nodes, spread });
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b)
    { return std::tie(a.nodes, a.spread) < std::tie(b.nodes, b.spread); });
  std::vector<SizedConfiguration> results;
  int enough = std::numeric_limits<int>::max(); // number of nodes that suffices
  for (const Candidate& candidate : candidates)
  {
    if (candidate.nodes > enough && options.given.empty())
    {
      break;
    }
    progress.Report(0.7);
    std::vector<Isometry> kept;
    for (const std::size_t g : candidate.indices.kept)
    {
      kept.push_back(sites.elements[g]);
    }
    results.push_back(Refine(
      domain, form, options, kept, ConfigurationOf(sites.positions, candidate.indices.indices)));
    if (results.back().spread <= Enough)
    {
      enough = candidate.nodes;
    }
  }
  for (SizedConfiguration& result : results)
  {
    result.singularities.insert(
      result.singularities.begin(), options.given.begin(), options.given.end());
  }
  progress.Report(1.0);
  return results;
}
}
