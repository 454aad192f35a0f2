#include "CandidateSites.h"

#include "CurveSymmetry.h"
#include "HolePattern.h"
#include "SegmentSearch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crossfield
{
namespace
{
/// Returns a group with at most twelve rotations: a part that is a circle has many more than its
/// singularities.
SymmetryGroup Reduced(SymmetryGroup group)
{
  constexpr int MostRotations = 12;
  constexpr int Usual = 8;
  if (group.order > MostRotations)
  {
    int order = Usual;
    while (group.order % order != 0)
    {
      --order;
    }
    group.order = order;
  }
  return group;
}

/// Collects sites.
class SiteCollection
{
public:
  SiteCollection(const PlanarDomain& domain, const SymmetryGroup& group)
    : SiteCollection(domain, group.Elements())
  {
    this->Sites.group = group;
  }
  SiteCollection(const PlanarDomain& domain, std::vector<Isometry> elements)
    : Boundary(domain)
    , Reach(SymmetryReach * domain.Diagonal())
  {
    this->Sites.elements = std::move(elements);
    this->Sites.images.resize(this->Sites.elements.size());
  }

  double DistanceAt(const Point& place) const { return this->Boundary.SignedDistance(place); }
  const SymmetryGroup& Group() const { return this->Sites.group; }
  std::size_t Count() const { return this->Sites.positions.size(); }

  /// Adds a position and its images, if all are `clearance` away from the boundary and `spacing` from other
  /// sites. A position that is closer to some of its images is moved between them.
  void Add(Point place, double spacing, double clearance)
  {
    place = this->MovedToFixed(place, spacing);
    if (this->DistanceAt(place) < clearance)
    {
      return;
    }
    const std::size_t first = this->Count();
    std::vector<Point> orbit;
    std::vector<std::size_t> images;
    for (const Isometry& map : this->Sites.elements)
    {
      const Point image = map(place);
      std::size_t known = 0;
      while (known < orbit.size() && (orbit[known] - image).norm() > this->Reach)
      {
        ++known;
      }
      if (known == orbit.size())
      {
        for (const std::vector<Point>* others : { &this->Sites.positions, &orbit })
        {
          for (const Point& other : *others)
          {
            if ((other - image).squaredNorm() < spacing * spacing)
            {
              return;
            }
          }
        }
        orbit.push_back(image);
      }
      images.push_back(first + known);
    }
    this->Sites.positions.insert(this->Sites.positions.end(), orbit.begin(), orbit.end());
    this->AddImages(orbit, first);
  }

  CandidateSites Release() { return std::move(this->Sites); }

private:
  /// Returns the centre if a rotation of the group moves a position by little, and the nearest point
  /// of an axis if only a reflection does.
  Point MovedToFixed(const Point& place, double spacing) const
  {
    constexpr double LittlePart = 0.45; // of the spacing: less than half of it
    Point moved = place;
    for (std::size_t g = 1; g < this->Sites.elements.size(); ++g)
    {
      const Isometry& map = this->Sites.elements[g];
      const Point image = map(place);
      if ((image - place).norm() > LittlePart * spacing)
      {
        continue;
      }
      if (!map.reflects)
      {
        return this->Sites.group.centre;
      }
      moved = 0.5 * (place + image);
    }
    return moved;
  }

  void AddImages(const std::vector<Point>& orbit, std::size_t first)
  {
    for (std::size_t g = 0; g < this->Sites.elements.size(); ++g)
    {
      for (const Point& place : orbit)
      {
        const Point image = this->Sites.elements[g](place);
        const auto nearest = std::min_element(orbit.begin(), orbit.end(),
          [&](const Point& a, const Point& b)
          { return (a - image).squaredNorm() < (b - image).squaredNorm(); });
        this->Sites.images[g].push_back(first + static_cast<std::size_t>(nearest - orbit.begin()));
      }
    }
  }

  SegmentSearch Boundary;
  double Reach;
  CandidateSites Sites;
};

/// Returns the direction of an axis of reflection through the centre of a hole, or of the longest
/// side of the boundary.
double FirstDirection(const PlanarDomain& domain, const SymmetryGroup& group, const Point& centre)
{
  const Point offset = centre - group.centre;
  const double angle = std::atan2(offset.y(), offset.x());
  const double reach = 1e-6 * domain.Diagonal();
  if (offset.norm() < reach)
  {
    return group.axis;
  }
  if (group.reflects)
  {
    const double turns = (angle - group.axis) * group.order / Pi;
    if (std::abs(turns - std::round(turns)) * offset.norm() < reach)
    {
      return angle;
    }
  }
  double longest = 0.0;
  double direction = 0.0;
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point side = loop[(i + 1) % loop.size()] - loop[i];
      if (side.norm() > (1.0 + 1e-9) * longest)
      {
        longest = side.norm();
        direction = std::atan2(side.y(), side.x());
      }
    }
  }
  return direction;
}

void AddAroundHoles(const PlanarDomain& domain, double clearance, SiteCollection& sites)
{
  const std::vector<RoundHole> holes = FindRoundHoles(domain);
  constexpr std::size_t ManyHoles = 20;
  const int count = holes.size() > ManyHoles ? 16 : 24;
  for (const RoundHole& hole : holes)
  {
    const double first = FirstDirection(domain, sites.Group(), hole.centre);
    // the sides of the polygon are closer to its centre than its corners
    const double radius = hole.radius + 1.001 * clearance;
    for (int i = 0; i < count; ++i)
    {
      const double angle = first + 2.0 * Pi * i / count;
      sites.Add(hole.centre + radius * Point(std::cos(angle), std::sin(angle)),
        std::min(clearance, 0.8 * 2.0 * Pi * radius / count), clearance);
    }
  }
}

void AddAlongAxes(const PlanarDomain& domain, double clearance, SiteCollection& sites)
{
  const SymmetryGroup group = sites.Group();
  if (group.IsTrivial())
  {
    return;
  }
  const double step = 1.05 * clearance;
  sites.Add(group.centre, step, clearance);
  if (!group.reflects)
  {
    return;
  }
  // The others are images of these.
  const int steps = static_cast<int>(std::ceil(domain.Diagonal() / step));
  for (const double angle : { group.axis, group.axis + Pi / group.order })
  {
    const Point direction(std::cos(angle), std::sin(angle));
    for (int i = -steps; i <= steps; ++i)
    {
      sites.Add(group.centre + i * step * direction, 0.95 * step, clearance);
    }
  }
}

void AddLattice(const PlanarDomain& domain, double clearance, SiteCollection& sites)
{
  struct Candidate
  {
    Point place;
    double spacing = 0.0;
  };
  const double diagonal = domain.Diagonal();
  const double largest = std::max(diagonal / 18.0, 1.5 * clearance);
  // A lattice in all of the domain that is fine enough for its narrowest part would be large.
  const double step = std::max(0.75 * clearance, diagonal / 250.0);
  Point lower = domain.loops[0][0];
  Point upper = lower;
  for (const Point& corner : domain.loops[0])
  {
    lower = lower.cwiseMin(corner);
    upper = upper.cwiseMax(corner);
  }
  std::vector<Candidate> candidates;
  int row = 0;
  for (double y = lower.y() + 0.5 * step; y < upper.y(); y += 0.5 * std::sqrt(3.0) * step, ++row)
  {
    for (double x = lower.x() + (row % 2 == 0 ? 0.25 : 0.75) * step; x < upper.x(); x += step)
    {
      const Point place(x, y);
      const double distance = sites.DistanceAt(place);
      if (distance >= 1.02 * clearance)
      {
        candidates.push_back({ place, std::clamp(0.6 * distance, 1.5 * clearance, largest) });
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.spacing < b.spacing; });
  for (const Candidate& candidate : candidates)
  {
    sites.Add(candidate.place, candidate.spacing, clearance);
  }
}
}

SymmetryGroup SearchedSymmetries(const PlanarDomain& domain)
{
  return Reduced(FindCurveSymmetries(domain));
}

CandidateSites FindSitesForSizes(const PlanarDomain& domain, const SymmetryGroup& symmetries,
  const std::vector<Point>& places, const SizeFunction& size)
{
  constexpr std::size_t MostSites = 900;
  constexpr double Clearance = 1.3;
  constexpr double Wider = 1.12;
  for (double spacing = 1.6;; spacing *= Wider)
  {
    SiteCollection sites(domain, symmetries);
    if (!symmetries.IsTrivial())
    {
      const double atCentre = size(symmetries.centre);
      sites.Add(symmetries.centre, spacing * atCentre, Clearance * atCentre);
    }
    for (const Point& place : places)
    {
      const double here = size(place);
      sites.Add(place, spacing * here, Clearance * here);
      if (sites.Count() > MostSites)
      {
        break;
      }
    }
    if (sites.Count() <= MostSites)
    {
      return sites.Release();
    }
  }
}

CandidateSites CloseUnderSymmetries(const PlanarDomain& domain,
  const std::vector<Isometry>& symmetries, const std::vector<Point>& places, std::size_t kept,
  const SizeFunction& size)
{
  SiteCollection sites(domain, symmetries);
  const double apart = 1e-7 * domain.Diagonal(); // only equal places are one
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    sites.Add(places[i], apart, i < kept ? 0.0 : size(places[i]));
  }
  return sites.Release();
}

CandidateSites FindCandidateSites(const PlanarDomain& domain, double clearance)
{
  SiteCollection sites(domain, SearchedSymmetries(domain));
  AddAroundHoles(domain, clearance, sites);
  AddAlongAxes(domain, clearance, sites);
  AddLattice(domain, clearance, sites);
  return sites.Release();
}
}
