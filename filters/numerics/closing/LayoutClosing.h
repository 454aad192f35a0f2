#pragma once

#include "Layout.h"
#include "PlanarDomain.h"
#include "TargetSize.h"

#include <functional>
#include <limits>

namespace crossfield
{
struct ClosingOptions
{
  SeamlessMapOptions map;
  /// Meshes the domain with vertices at singularities.
  std::function<TriangleMesh(const Configuration&, const Progress&)> mesh;
  TargetSizes sizes; ///< Variation of the size of quads over the domain.
  double size = 0.0; ///< Edge length of quads in the map.
  /// Arcs should vanish that have no edges with quads this much larger.
  double coarseness = 3.0;
  int maximumMaps = 8; ///< Maximum number of maps.
  /// Continues until the arcs have vanished to rounding. Separatrices that meet at the start are kept
  /// together, and holonomy defects at the values of the start instead of 0.
  bool exact = false;
  double maximumMove = std::numeric_limits<double>::infinity(); ///< Of a singularity, a length.
};

/// Result of CloseLayout.
struct ClosingResult
{
  Layout layout;
  int maps = 0;           ///< Number of maps that were solved.
  bool converged = false; ///< The arcs have vanished within tolerance, and the defects as well.
  double longest = 0.0;   ///< Maximum length of the arcs that should vanish, in quads.
};

/// Returns the arcs that have no edges with the larger quads of the options.
std::vector<int> FindArcsToClose(const TMesh& tMesh, const ClosingOptions& options);

/// Moves the interior singularities until separatrices that nearly meet do meet (docs/method.md
/// §14.10): the arcs that have no edges with larger quads get length 0. Each step solves these
/// conditions, linearised, with the holonomy defects kept at 0; then the map, the T-mesh and the
/// edge counts are computed again. A step moves no singularity by more than 0.4 of its clearance,
/// the distance to the boundary or half the distance to the next singularity.
///
/// Returns the last layout that could be computed and fulfils the limit of moves, which is `start` if
/// there was nothing to do.
ClosingResult CloseLayout(const PlanarDomain& domain, Layout start, const ClosingOptions& options,
  const Progress& progress = {});
}
