#pragma once

#include "FactoredDomain.h"
#include "Progress.h"

#include "SeamlessMapSolve.h"

namespace crossfield
{
/// Singularities that were moved to positions at which separatrices that nearly met do meet.
struct LayoutSnap
{
  Configuration singularities; ///< In the order given.
  int joined = 0;              ///< Number of pairs of separatrices that the move has joined.
  /// Number of near misses that remain: joining them would move a singularity too far, or separate
  /// others.
  int leftOut = 0;
  /// Maximum displacement of a singularity, a length, at most the tolerance.
  double largestMove = 0.0;
};

/// Moves the interior singularities as little as possible, in the sum of squares, so that every
/// separatrix that passes a singularity or corner at a distance of at most `tolerance` meets it and
/// coincides with the separatrix that starts there (docs/method.md §15.3). Separatrices that
/// already meet continue to do so, and the holonomy defects of inner loops do not change.
///
/// `tolerance`: a length; the map has the area of the domain. No singularity moves farther. Throws
/// Error as SolveSeamlessMap and TraceSeparatrices do for the given configuration.
LayoutSnap SnapLayout(const FactoredDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double tolerance, const Progress& progress = {});
}
