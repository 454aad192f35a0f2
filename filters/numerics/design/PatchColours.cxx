#include "PatchColours.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace crossfield
{
namespace
{
/// Returns the outline of a patch, counter-clockwise.
std::vector<SpacePoint> OutlineOf(const TMesh& mesh, const TPatch& patch)
{
  std::vector<SpacePoint> outline;
  for (const std::vector<int>& side : patch.sides)
  {
    for (const int half : side)
    {
      std::vector<SpacePoint> path = mesh.arcs[half / 2].polyline;
      if (half % 2 == 1)
      {
        std::reverse(path.begin(), path.end());
      }
      outline.insert(outline.end(), path.begin(), path.end() - 1);
    }
  }
  return outline;
}

/// Computes area and centroid of a patch, on a surface those of its projection along its mean normal; a patch without
/// area has its first point as the centre.
PatchColour Measure(const std::vector<SpacePoint>& outline)
{
  PatchColour result;
  const SpacePoint& origin = outline.front();
  std::vector<SpacePoint> areas; // of triangles with the origin, as vectors
  SpacePoint area = SpacePoint::Zero();
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
  {
    areas.emplace_back(0.5 * (outline[i] - origin).cross(outline[i + 1] - origin));
    area += areas.back();
  }
  result.area = area.norm();
  result.centre = origin;
  if (result.area > 0.0)
  {
    const SpacePoint normal = area / result.area;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    {
      result.centre += areas[i - 1].dot(normal) / (3.0 * result.area) *
        (outline[i] - origin + outline[i + 1] - origin);
    }
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
