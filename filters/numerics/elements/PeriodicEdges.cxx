#include "PeriodicEdges.h"

#include "Error.h"
#include "Index.h"

#include <algorithm>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// Images of periodic points in files with 12 digits or more are within this part of the extent.
constexpr double Tolerance = 1e-9;

/// Edges by the coordinate of their end along a direction that usual meshes do not have.
using EdgesByKey = std::multimap<double, int>;

double KeyOf(const Point& place)
{
  return place.dot(Point(0.7413, 0.6712));
}

double ExtentOf(const StraightQuads& quads)
{
  Point low = quads.points.front();
  Point high = low;
  for (const Point& point : quads.points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).norm();
}
}

std::vector<int> MatchEdges(const StraightQuads& quads)
{
  std::vector<int> masters(quads.edges.size(), -1);
  const auto start = [&](std::size_t edge) -> const Point&
  { return quads.points[Index(quads.edges[edge].points[0])]; };
  const auto end = [&](std::size_t edge) -> const Point&
  { return quads.points[Index(quads.edges[edge].points[1])]; };
  for (const PeriodicSides& pair : quads.periodic)
  {
    const double reach = Tolerance * ExtentOf(quads);
    EdgesByKey images;
    for (std::size_t e = 0; e < quads.edges.size(); ++e)
    {
      if (quads.edges[e].side == pair.second)
      {
        images.emplace(KeyOf(end(e)), static_cast<int>(e));
      }
    }
    for (std::size_t e = 0; e < quads.edges.size(); ++e)
    {
      if (quads.edges[e].side != pair.first)
      {
        continue;
      }
      const Point from = pair.motion(start(e));
      const Point to = pair.motion(end(e));
      const auto found = std::find_if(images.lower_bound(KeyOf(from) - reach),
        images.upper_bound(KeyOf(from) + reach),
        [&](const auto& image)
        {
          return (end(Index(image.second)) - from).norm() <= reach &&
            (start(Index(image.second)) - to).norm() <= reach;
        });
      if (found == images.upper_bound(KeyOf(from) + reach))
      {
        throw Error("The periodic edge near " + Describe(start(e)) +
          " has no image on the other side; make the quads again, or remove the field data "
          "PeriodicSides.");
      }
      masters[Index(found->second)] = static_cast<int>(e);
    }
  }
  return masters;
}
}
