#pragma once

#include "ArcCounts.h"
#include "QuadBlocks.h"
#include "QuadQuality.h"
#include "QuadSizes.h"
#include "QuadSmoothing.h"

#include "SeamlessMap.h"

namespace crossfield
{
struct QuadOptions
{
  /// Target side length of quads in the map, whose area is the domain's; 0: by quadCount.
  double quadSize = 0.0;
  int quadCount = 1000; ///< Target number of quads where quadSize is 0.
  TargetSizes sizes;    ///< Variation of the size over the domain.
  bool smooth = true;   ///< Otherwise points are left where the map has them, which is for drafts.
  bool coarse = false; ///< The fewest blocks that are sound, instead of those nearest to the sizes.
};

/// An all-quad mesh with exactly the cones of a map as irregular points, and how it came about.
struct QuadResult
{
  QuadMesh mesh;
  TMesh lines;
  double size = 0.0;
  ArcCounts counts;
  SmoothingReport smoothing;
  QuadQuality quality;
  QuadBlocks blocks;
  double layoutSeconds = 0.0;
  double smoothSeconds = 0.0;
};

/// Builds a quad mesh of the T-mesh of a map: edge counts, quads, smoothing (docs/method.md §14). The T-mesh is that of
/// MakeTMesh for the same map. Throws Error as CountArcs and LayQuads do, and before more quads are built than fit into
/// memory.
QuadResult MakeQuads(
  const SeamlessMap& map, TMesh lines, const QuadOptions& options, const Progress& progress = {});
}
