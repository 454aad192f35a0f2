#pragma once

#include "Layout.h"
#include "QuadResult.h"
#include "SurfaceTargets.h"

#include <string>
#include <vector>

namespace crossfield
{
/// A prescribed number of edges, or size of edges, of a side or line.
struct SurfaceSideRequest
{
  std::string side;
  int count = 0;     ///< 0: not prescribed.
  double size = 0.0; ///< Met within 20 %; 0: not prescribed.
};

struct SurfaceQuadOptions
{
  /// Target side length of quads in the map, whose area is the surface's; with target sizes, a factor of these. 0: set
  /// by quadCount.
  double quadSize = 0.0;
  int quadCount = 1000; ///< Target number of quads if quadSize is 0.
  bool hold = false;    ///< Keeps inner singularities at their positions in smoothing.
  bool smooth = true;   ///< If false, points keep their positions in the map (draft quads).
  /// Uses the fewest blocks that give a good mesh instead of the most accurate sizes; needs `smooth`.
  bool coarse = false;
  SurfaceTargets targets = {}; ///< Sizes of quads; empty: those of the map.
  std::vector<SurfaceSideRequest> sides = {};
};

/// Makes quads of the layout of a surface (docs/method.md §14, §22.8): edge counts, smooth quads, blocks and
/// quality. The sides of the boundary are called outer0, outer1, ... between corners of the longest loop, and
/// hole0, ... of the others. With pairs, the two sides of lines of sharp edges, the mesh is one across these
/// lines, and no block crosses them (docs/method.md §22.12). Throws Error if the size or count is not positive,
/// if more quads would be built than fit into memory, and as Quantise and BuildQuads do.
QuadResult MakeSurfaceQuads(
  const LayoutSet& layouts, const SurfaceQuadOptions& options, const Progress& progress = {});
}
