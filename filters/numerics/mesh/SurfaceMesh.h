#pragma once

#include "Plane.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// Triangles in space.
struct SurfaceMesh
{
  std::vector<SpacePoint> points;
  std::vector<std::array<int, 3>> triangles; ///< Counter-clockwise seen from outside.
  /// Per triangle the number of its region; empty if there is only one.
  std::vector<int> regions = {};
  /// Per triangle and side (from point i to i + 1) the number of the named line along it, −1 without one; given for
  /// one side of an edge or for both. Empty without named lines.
  std::vector<std::array<int, 3>> lines = {};

  int RegionOf(std::size_t triangle) const
  {
    return this->regions.empty() ? 0 : this->regions[triangle];
  }
  std::array<int, 3> LinesOf(std::size_t triangle) const
  {
    return this->lines.empty() ? std::array<int, 3>{ -1, -1, -1 } : this->lines[triangle];
  }
  /// Appends the regions and lines of a triangle of another mesh to those here, for a triangle that is appended.
  void AppendLabels(const SurfaceMesh& from, std::size_t triangle)
  {
    if (!from.regions.empty())
    {
      this->regions.push_back(from.regions[triangle]);
    }
    if (!from.lines.empty())
    {
      this->lines.push_back(from.lines[triangle]);
    }
  }
};

/// Names of the regions and lines of a surface.
struct SurfaceNames
{
  std::vector<std::string> regions; ///< Empty if the surface is one region.
  std::vector<std::string> lines;
};
}
