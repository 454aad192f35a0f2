#include "PatchColours.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace crossfield
{
namespace
{
/// Returns the outline of a patch in the plane, counter-clockwise.
Loop OutlineOf(const TMesh& mesh, const TPatch& patch)
{
  Loop outline;
  for (const std::vector<int>& side : patch.sides)
  {
    for (const int half : side)
    {
      std::vector<SpacePoint> path = mesh.arcs[half / 2].polyline;
      if (half % 2 == 1)
      {
        std::reverse(path.begin(), path.end());
      }
      std::transform(path.begin(), path.end() - 1, std::back_inserter(outline),
        [](const SpacePoint& place) { return place.head<2>(); });
    }
  }
  return outline;
}

/// Computes area and centroid of a patch; a patch without area has its first point as the centre.
PatchColour Measure(const Loop& outline)
{
  PatchColour result;
  const Point& origin = outline.front();
  Point moment = Point::Zero();
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
  {
    const Point a = outline[i] - origin;
    const Point b = outline[i + 1] - origin;
    result.area += 0.5 * Cross(a, b);
    moment += Cross(a, b) / 6.0 * (a + b);
  }
  result.centre = origin;
  if (result.area > 0.0)
  {
    result.centre += moment / result.area;
  }
  return result;
}

/// Gives patches the colours of the earlier patches that they continue, −1 to the others.
void KeepColours(const std::vector<PatchColour>& earlier, std::vector<PatchColour>& patches)
{
  using Match = std::tuple<double, std::size_t, std::size_t>;
  std::vector<Match> matches;
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    patches[i].colour = -1;
    for (std::size_t j = 0; j < earlier.size(); ++j)
    {
      const auto [smaller, larger] = std::minmax(patches[i].area, earlier[j].area);
      const double distance = (patches[i].centre - earlier[j].centre).norm();
      if (distance < 0.5 * std::sqrt(smaller) && larger <= 3.0 * smaller)
      {
        matches.emplace_back(distance, i, j);
      }
    }
  }
  std::sort(matches.begin(), matches.end());
  std::vector<bool> isTaken(earlier.size());
  for (const auto& [distance, i, j] : matches)
  {
    if (patches[i].colour < 0 && !isTaken[j])
    {
      patches[i].colour = earlier[j].colour;
      isTaken[j] = true;
    }
  }
}

/// Returns the colour that the fewest neighbours of a patch have, the smallest if there are
/// several.
int RarestColour(const TMesh& mesh, const TPatch& patch, const std::vector<PatchColour>& patches)
{
  std::array<int, PatchColourCount> counts{};
  for (const std::vector<int>& side : patch.sides)
  {
    for (const int half : side)
    {
      const int neighbour = mesh.halfEdges[TMesh::Twin(half)].patch;
      const int colour = neighbour < 0 ? -1 : patches[neighbour].colour;
      if (colour >= 0)
      {
        ++counts[colour];
      }
    }
  }
  return static_cast<int>(std::min_element(counts.begin(), counts.end()) - counts.begin());
}
}

std::vector<PatchColour> ColourPatches(const TMesh& mesh, const std::vector<PatchColour>& earlier)
{
  std::vector<PatchColour> patches;
  patches.reserve(mesh.patches.size());
  for (const TPatch& patch : mesh.patches)
  {
    patches.push_back(Measure(OutlineOf(mesh, patch)));
  }
  KeepColours(earlier, patches);
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    if (patches[i].colour < 0)
    {
      patches[i].colour = RarestColour(mesh, mesh.patches[i], patches);
    }
  }
  return patches;
}
}
