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

/// Returns whether a smoothed mesh may replace another one: it has fewer blocks, its minimum scaled
/// Jacobian is at most 0.02 lower, the mean at most 0.002, the variation of sizes at most 1.35 times
/// as large or 0.05 larger, and no quad is inverted.
bool IsCleaner(const QuadResult& candidate, const QuadResult& start);

/// Returns whether a mesh has fewer blocks than another one, or as many and a larger minimum scaled
/// Jacobian.
bool IsBetter(const QuadResult& a, const QuadResult& b);

/// Moves singularities so that separatrices that nearly meet do meet, for fewer blocks
/// (docs/method.md §14.10). Closes the layout for several ratios of coarse quads, and keeps the mesh
/// with the fewest blocks that may replace the start (IsCleaner); `start` is returned if there is
/// none.
CleanBlocksResult CleanBlocks(const PlanarDomain& domain, MeshedLayout start,
  const CleanOptions& options, const Progress& progress = {});
}
