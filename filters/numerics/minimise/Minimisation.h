#pragma once

#include "CrouzeixRaviart.h"

namespace crossfield
{
/// Termination criteria of the minimisers of this module.
struct MinimiserOptions
{
  int maximumIterations = 100;
  /// Converged when the residual of the optimality conditions, relative to the size of their terms,
  /// is below this. Rounding limits it to about 1e-14; 1e-10 leaves a margin for large meshes.
  double tolerance = 1e-10;
};

/// Result of all minimisers.
struct MinimiserResult
{
  ComplexVector x;
  Eigen::VectorXd multipliers; ///< One per constraint; empty or zero where they are not computed.
  int iterations = 0;
  double residual = 0.0;
  bool converged = false;
  // Set by ConstrainedMinimiser.h only:
  std::vector<double> values; ///< Values of the functional, at the start and after every iteration.
  int convexifiedSteps = 0;   ///< Iterations whose second derivatives were not positive definite.
  int saddlesLeft = 0;        ///< Iterations that left a saddle along negative curvature.
};
}
