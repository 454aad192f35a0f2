#include "BoundaryCorners.h"

#include "Error.h"
#include "LoopTurning.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace crossfield
{
Corner MakeCorner(const std::vector<Loop>& loops, std::size_t loop, std::size_t vertex)
{
  const Loop& points = loops[loop];
  const Point& here = points[vertex];
  const Point after = points[(vertex + 1) % points.size()] - here;
  Corner corner;
  corner.position = here;
  corner.loop = static_cast<int>(loop);
  corner.vertex = static_cast<int>(vertex);
  corner.angle = Pi - TurningAt(points, vertex);
  // The domain lies counter-clockwise from the next segment to the previous one.
  corner.inward = Eigen::Rotation2Dd(0.5 * corner.angle) * after.normalized();
  return corner;
}

std::vector<Corner> FindCorners(const std::vector<Loop>& loops, double cornerAngle)
{
  std::vector<Corner> corners;
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
  {
    for (std::size_t vertex = 0; vertex < loops[loop].size(); ++vertex)
    {
      const Corner corner = MakeCorner(loops, loop, vertex);
      if (IsCorner(corner.Turning(), cornerAngle))
      {
        corners.push_back(corner);
      }
    }
  }
  return corners;
}

std::vector<std::size_t> MatchChoices(
  const std::vector<Point>& vertices, const std::vector<CornerChoice>& choices)
{
  std::vector<std::size_t> matches;
  const double reach = BoundaryReach * BoundingDiagonal({ vertices });
  for (const CornerChoice& choice : choices)
  {
    const auto distance = [&choice](const Point& point)
    { return (point - choice.position).squaredNorm(); };
    const auto nearest = std::min_element(vertices.begin(), vertices.end(),
      [&distance](const Point& a, const Point& b) { return distance(a) < distance(b); });
    if (nearest == vertices.end() || !(distance(*nearest) <= reach * reach))
    {
      throw Error("The corner with a chosen quarter index at " + Describe(choice.position) +
        " is not a vertex of the boundary; give the corners of this domain.");
    }
    const auto match = static_cast<std::size_t>(nearest - vertices.begin());
    if (std::find(matches.begin(), matches.end(), match) != matches.end())
    {
      throw Error("The vertex of the boundary at " + Describe(*nearest) +
        " has two chosen quarter indices; give one.");
    }
    matches.push_back(match);
  }
  return matches;
}
}
