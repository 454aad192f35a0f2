#pragma once

#include "Layout.h"

namespace crossfield
{
/// The layouts of regions as one, whose mesh is not connected.
struct JoinedLayouts
{
  Layout layout; ///< Without separatrices and the factor of the potential.
  /// Per region, the number in the joined mesh of each of its aligned loops.
  std::vector<std::vector<int>> loops;
  std::vector<std::size_t> patches; ///< First patch of each region, and their number.
};

/// Joins the layouts of regions, whose meshes are all planar or all surfaces: vertices, triangles, boundary
/// edges, cones, nodes, arcs and patches have numbers that continue from region to region.
JoinedLayouts JoinLayouts(const std::vector<Layout>& regions);
}
