#pragma once

#include "ConfigurationProposal.h"
#include "SingularityOptimizer.h"

namespace crossfield
{
struct AutomaticOptions
{
  ProposalOptions proposal; ///< What is given and what is asked of the corners.
  /// Its corners are those of the proposal. Even sizes and pairs are for the quads to come: what singularities are needed
  /// is decided before.
  OptimizerOptions optimizer;
  /// Of the quads to come, if there are any: the length of their sides, or else their number, from which it follows.
  /// Where the optimiser's clearance is not given it is 0.7 of that length (docs/method.md §5.6).
  double quadSize = 0.0;
  int quadCount = 0;
};

/// The clearance that is good for quads of a size: 0.7 of it (docs/method.md §5.6).
double ClearanceForQuads(double quadSize);

/// Sharp corners of quarter index 2 get 1 (PoincareHopf.h). Where there are any, every singularity stays what it
/// is: one that goes into such a corner would undo it.
void CapCorners(const PlanarDomain& domain, AutomaticOptions& options);

/// Singularities that were chosen for a domain, and how.
struct AutomaticConfiguration
{
  Configuration singularities; ///< Those given first; without radii where none were given.
  std::vector<CornerChoice>
    corners;               ///< Quarter indices that the field has to take at the boundary.
  OptimizerResult optimum; ///< The run that led here.
  /// One sentence for each thing that was decided or happened.
  std::vector<std::string> events;
};

/// Chooses the singularities of a domain of which nothing else is known: proposes
/// (ConfigurationProposal.h) and moves what is inside to where the renormalised energy is least
/// (SingularityOptimizer.h). From the best proposal on, until one comes to rest without a holonomy
/// defect; if none does, that with the least defect is taken, which is no error: optimum.converged
/// says so, and the last event why. Then on to the clearance for quads, if quads are to come, and to even sizes, if they are asked
/// for or sizes are far from even.
///
/// Throws Error as the two do.
AutomaticConfiguration ChooseConfiguration(
  const PlanarDomain& domain, const AutomaticOptions& options = {}, const Progress& progress = {});
}
