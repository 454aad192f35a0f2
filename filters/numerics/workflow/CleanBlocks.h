#pragma once

#include "LayoutClosing.h"
#include "QuadMesher.h"

namespace crossfield
{
struct CleanOptions
{
  SeamlessMapOptions map;
  double meshSize = 0.0; ///< As in DrillOptions.
  QuadOptions quads;
  int maximumMaps = 60; ///< Maximum number of maps (docs/method.md §14.10).
  /// Maximum number of maps times coordinates of singularities: each map has as many
  /// back-substitutions, and integer problems that grow with it.
  int maximumSolves = 3000;
};

/// Layouts and their quad mesh.
struct MeshedLayout
{
  LayoutSet layouts;
  QuadResult quads;
};

/// Result of CleanBlocks.
struct CleanBlocksResult
{
  MeshedLayout mesh;
  bool accepted = false;    ///< Whether a mesh other than the start was accepted.
  double coarseness = 0.0;  ///< ClosingOptions::coarseness of the accepted layout.
  double largestMove = 0.0; ///< Maximum displacement of a singularity, a length.
  int maps = 0;             ///< Number of maps that were solved.
};

/// Moves singularities so that separatrices that nearly meet do meet, for fewer blocks
/// (docs/method.md §14.10). Closes the layout for several ratios of coarse quads, and keeps the mesh
/// with the fewest blocks that is as good as the start (CleanTolerance); `start` is returned if there is
/// none.
CleanBlocksResult CleanBlocks(const PlanarDomain& domain, MeshedLayout start,
  const CleanOptions& options, const Progress& progress = {});
}
