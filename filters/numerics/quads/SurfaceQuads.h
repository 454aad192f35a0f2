#pragma once

#include "Layout.h"
#include "QuadResult.h"

namespace crossfield
{
struct SurfaceQuadOptions
{
  /// Target side length of quads in the map, whose area is the surface's; 0: set by quadCount.
  double quadSize = 0.0;
  int quadCount = 1000; ///< Target number of quads if quadSize is 0.
};

/// Makes quads of the layout of a surface whose nodes are at their places in the map (docs/method.md §14):
/// edge counts, quads, blocks and quality. The sides of the boundary are called outer0, outer1, ... between
/// corners of the longest loop, and hole0, ... of the others. Throws Error if the size or count is not positive, if more quads
/// would be built than fit into memory, and as Quantise and BuildQuadsInSpace do.
QuadResult MakeSurfaceQuads(
  const Layout& layout, const SurfaceQuadOptions& options, const Progress& progress = {});
}
