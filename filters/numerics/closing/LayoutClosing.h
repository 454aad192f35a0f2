#pragma once

#include "PlanarDomain.h"
#include "PotentialSolver.h"
#include "Progress.h"
#include "SeamlessMapSolve.h"
#include "TMesh.h"
#include "TargetSize.h"

#include <memory>

namespace crossfield
{
/// Singularities with their map and T-mesh.
struct ClosingLayout
{
  Configuration singularities;
  SeamlessMap map;
  TMesh tMesh;
  /// The factor that the map was solved with, which derivatives use again; may be null.
  std::shared_ptr<const PotentialSolver> potential = nullptr;
};

struct ClosingOptions
{
  SeamlessMapOptions map;
  double meshSize = 0.0; ///< As in DrillOptions.
  TargetSizes sizes;     ///< Variation of the size of quads over the domain.
  double size = 0.0;     ///< Edge length of quads in the map.
  /// Arcs should vanish that have no edges with quads this much larger.
  double coarseness = 3.0;
  int maximumMaps = 8; ///< Maximum number of maps.
};

/// Result of CloseLayout.
struct ClosingResult
{
  ClosingLayout layout;
  int maps = 0;           ///< Number of maps that were solved.
  bool converged = false; ///< The arcs have vanished within tolerance, and the defects as well.
  double longest = 0.0;   ///< Maximum length of the arcs that should vanish, in quads.
};

/// Meshes a domain with vertices at the singularities, solves for the map and builds the T-mesh.
/// Throws Error as these steps do.
ClosingLayout LayOut(const PlanarDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double meshSize, const Progress& progress = {});

/// Returns the arcs that have no edges with the larger quads of the options.
std::vector<int> FindArcsToClose(const TMesh& tMesh, const ClosingOptions& options);

/// Moves the interior singularities until separatrices that nearly meet do meet (docs/method.md
/// §14.10): the arcs that have no edges with larger quads get length 0. Each step solves these
/// conditions, linearised, with the holonomy defects kept at 0; then the map, the T-mesh and the
/// edge counts are computed again. A step moves no singularity by more than 0.4 of its clearance,
/// the distance to the boundary or half the distance to the next singularity.
///
/// Returns the last layout that could be computed, which is `start` if there was nothing to do.
ClosingResult CloseLayout(const PlanarDomain& domain, ClosingLayout start,
  const ClosingOptions& options, const Progress& progress = {});
}
