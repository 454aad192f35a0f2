#pragma once

#include "FactoredDomain.h"
#include "Progress.h"

#include "SeamlessMapSolve.h"

#include <string>

namespace crossfield
{
/// Singularities that were moved to positions at which separatrices that nearly met do meet.
struct LayoutSnap
{
  Configuration singularities; ///< In the order given.
  double largestMove = 0.0;    ///< Maximum displacement of a singularity, a length.
  std::string event;           ///< What was done and what remains, in sentences.
};

/// Moves the interior singularities until separatrices meet that pass each other, or a singularity or
/// corner, at a distance of at most about `tolerance` (docs/method.md §15.3). They then coincide to
/// rounding. Separatrices that already meet continue to do so, and the holonomy defects of inner
/// loops do not change. Where this would move a singularity by more than `tolerance`, the separatrices
/// farthest apart are left as they are.
///
/// `tolerance`: a length; the map has the area of the domain. Throws Error as SolveSeamlessMap and
/// TraceSeparatrices do for the given configuration.
LayoutSnap SnapLayout(const FactoredDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double tolerance, const Progress& progress = {});
}
