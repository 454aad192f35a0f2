#include "BoundaryLoops.h"

#include "Error.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Returns the segments as sorted vertex pairs, without duplicates and degenerate segments.
std::vector<std::array<int, 2>> DistinctSegments(std::vector<std::array<int, 2>> segments)
{
  for (auto& segment : segments)
  {
    if (segment[0] > segment[1])
    {
      std::swap(segment[0], segment[1]);
    }
  }
  segments.erase(std::remove_if(segments.begin(), segments.end(),
                   [](const auto& segment) { return segment[0] == segment[1]; }),
    segments.end());
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  return segments;
}
}

std::vector<Loop> ChainLoops(
  const std::vector<Point>& points, const std::vector<std::array<int, 2>>& segments)
{
  constexpr int None = -1;
  std::vector<std::array<int, 2>> neighbours(points.size(), { None, None });
  for (const auto& segment : DistinctSegments(segments))
  {
    for (int side : { 0, 1 })
    {
      const int here = segment[side];
      const int there = segment[1 - side];
      const Point& point = points[here];
      if (!point.allFinite())
      {
        throw Error(
          "The boundary has a point whose coordinates are not finite numbers; remove it.");
      }
      auto& pair = neighbours[here];
      if (pair[1] != None)
      {
        throw Error("The boundary branches at " + Describe(point) +
          ": more than two segments meet there; keep one closed curve through each point.");
      }
      pair[pair[0] == None ? 0 : 1] = there;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (neighbours[i][0] != None && neighbours[i][1] == None)
    {
      throw Error("The boundary is an open curve that ends at " + Describe(points[i]) +
        "; join its ends so that every loop is closed, or, for a contour that ends where its data end, "
        "use Iso Volume or Clip of the surface.");
    }
  }

  std::vector<Loop> loops;
  std::vector<bool> visited(points.size(), false);
  for (std::size_t start = 0; start < points.size(); ++start)
  {
    if (visited[start] || neighbours[start][0] == None)
    {
      continue;
    }
    Loop loop;
    int previous = None;
    int here = static_cast<int>(start);
    while (!visited[here])
    {
      const auto index = static_cast<std::size_t>(here);
      visited[index] = true;
      loop.push_back(points[index]);
      const int next =
        neighbours[index][0] != previous ? neighbours[index][0] : neighbours[index][1];
      previous = here;
      here = next;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}
}
