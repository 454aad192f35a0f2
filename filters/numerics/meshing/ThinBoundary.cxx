#include "ThinBoundary.h"

#include "BoundaryCorners.h"
#include "CanonicalFrame.h"
#include "DrillHoles.h"
#include "Error.h"
#include "LoopArc.h"
#include "LoopDivision.h"
#include "MakePlanarDomain.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Default length of thinning relative to the mesh size.
constexpr double PartOfMeshSize = 0.02;

/// Returns the start points of a loop without corners, chosen to preserve symmetries of the domain:
/// the vertices farthest from the domain's centre or, for a circle around it, those at the extremes
/// of the coordinates of the domain's frame.
std::vector<double> FindSeeds(
  const LoopArc& arc, const CanonicalFrame& frame, const Point& centre, double rounding)
{
  const Loop& loop = arc.Vertices();
  double farthest = 0.0;
  for (const Point& point : loop)
  {
    farthest = std::max(farthest, (point - centre).norm());
  }
  std::vector<double> seeds;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    if ((loop[i] - centre).norm() > farthest - rounding)
    {
      seeds.push_back(arc.Start(i));
    }
  }
  if (seeds.size() <= 8) // symmetries about the centre map one vertex to two, four or eight
  {
    return seeds;
  }
  seeds.clear();
  for (const Point& direction : { Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1) })
  {
    const auto extreme = std::max_element(loop.begin(), loop.end(),
      [&](const Point& a, const Point& b)
      { return frame.ToFrame(a).dot(direction) < frame.ToFrame(b).dot(direction); });
    seeds.push_back(arc.Start(static_cast<std::size_t>(extreme - loop.begin())));
  }
  return seeds;
}

/// Returns the vertices of the thinned loop; none if the loop is unchanged.
std::vector<ArcVertex> ThinLoop(const LoopArc& arc, const std::vector<double>& given,
  const CanonicalFrame& frame, const Point& centre, double cornerAngle, const Thinning& thinning)
{
  const Loop& loop = arc.Vertices();
  double shortest = arc.Length();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    shortest = std::min(shortest, arc.Start(i + 1) - arc.Start(i));
  }
  if (shortest >= thinning.length)
  {
    return {};
  }
  const std::vector<double> turns = arc.Turns();
  KeptPlaces kept = FindKeptPlaces(arc, turns, cornerAngle, given, thinning);
  if (kept.places.empty())
  {
    kept.places = FindSeeds(arc, frame, centre, thinning.rounding);
  }
  return DivideLoop(arc, turns, kept, thinning);
}
}

//------------------------------------------------------------------------------
double ThinningFor(double size)
{
  return PartOfMeshSize * size;
}

//------------------------------------------------------------------------------
double DefaultThinning(const PlanarDomain& domain, double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  return PartOfMeshSize * std::min(ResolveMeshSize(options, domain), ResolveMeshSize({}, domain));
}

//------------------------------------------------------------------------------
SimplifiedBoundary ThinBoundary(
  const PlanarDomain& domain, double length, const std::vector<Point>& keep, double cornerAngle)
{
  return ThinLoops(domain, std::vector<double>(domain.loops.size(), length), keep, cornerAngle);
}

//------------------------------------------------------------------------------
SimplifiedBoundary ThinLoops(const PlanarDomain& domain, const std::vector<double>& lengths,
  const std::vector<Point>& keep, double cornerAngle)
{
  const double diagonal = domain.Diagonal();
  SimplifiedBoundary result;
  std::vector<Loop> loops;
  bool isThinned = false;
  const CanonicalFrame frame(domain.loops);
  Eigen::AlignedBox2d box;
  for (const Point& point : domain.loops[0])
  {
    box.extend(frame.ToFrame(point));
  }
  const Point centre = frame.FromFrame(box.center());
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    const Loop& loop = domain.loops[l];
    const LoopArc arc(loop);
    // Coordinates of symmetric domains may be stored with ten digits.
    const Thinning thinning{ lengths[l], cornerAngle / 6.0,
      std::min(1e-9 * diagonal, 1e-3 * lengths[l]) };
    const std::vector<double> given = arc.FindAll(keep, BoundaryReach * diagonal);
    const std::vector<ArcVertex> vertices =
      ThinLoop(arc, given, frame, centre, cornerAngle, thinning);
    if (vertices.size() < 3)
    {
      loops.push_back(loop); // nothing to thin, or the entire loop is short detail
      continue;
    }
    isThinned = true;
    result.moved = std::max(result.moved, LargestDistance(arc, vertices));
    loops.push_back(PositionsOf(vertices));
  }
  if (!isThinned)
  {
    return { domain, 0.0 };
  }
  try
  {
    result.domain = MakePlanarDomain(std::move(loops)); // throws if the loops touch
  }
  catch (const Error&)
  {
    return { domain, 0.0 };
  }
  return result;
}
}
