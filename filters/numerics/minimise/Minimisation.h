#pragma once

#include "CrouzeixRaviart.h"

namespace crossfield
{
/// How long the minimisers of this folder iterate.
struct MinimiserOptions
{
  int maximumIterations = 100;
  /// Converged when the residual of the optimality conditions, relative to the size of their
  /// terms, is below this. Rounding allows about 1e-14; 1e-10 leaves room for large meshes.
  double tolerance = 1e-10;
};

/// What all of them return.
struct MinimiserResult
{
  ComplexVector x;
  Eigen::VectorXd multipliers; ///< One per constraint; empty or zero where they are not computed.
  int iterations = 0;
  double residual = 0.0;
  bool converged = false;
  // Of ConstrainedMinimiser.h alone:
  std::vector<double> values; ///< Of the functional, at the start and after every iteration.
  int convexifiedSteps = 0;   ///< Iterations whose second derivatives were not positive definite.
  int saddlesLeft = 0;        ///< Iterations that left a saddle by its negative curvature.
};
}
