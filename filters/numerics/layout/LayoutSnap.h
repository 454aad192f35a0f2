#pragma once

#include "FactoredDomain.h"
#include "Progress.h"

#include "SeamlessMapSolve.h"

namespace crossfield
{
/// Singularities that were moved to where lines that nearly met do meet.
struct LayoutSnap
{
  Configuration singularities; ///< In the order given.
  int joined = 0;              ///< Pairs of lines that meet now and did not before.
  int leftOut =
    0; ///< Near misses that are left: joining them would move a singularity too far, or part others.
  double largestMove = 0.0; ///< A length, at most the tolerance.
};

/// Moves the singularities inside the least way, in the sum of squares, to where every line that passes a singularity or corner at
/// no more than `tolerance` meets it, and is one with the line that leaves it there (docs/method.md §15.3). Lines that meet
/// already stay so, and inner loops get no holonomy defect that they did not have.
///
/// `tolerance`: a length; the map has the area of the domain. No singularity moves farther. Throws Error as
/// SolveSeamlessMap and TraceLines do for the configuration given.
LayoutSnap SnapLayout(const FactoredDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double tolerance, const Progress& progress = {});
}
