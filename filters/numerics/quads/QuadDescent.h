#pragma once

#include "Progress.h"
#include "QuadEnergy.h"

namespace crossfield
{
/// When a descent ends.
struct DescentLimits
{
  int steps = 0;
  /// The decrease that a step promises, over the energy above IdealValue or over the energy.
  double partOfExcess = 0.0;
  double partOfValue = 0.0;
};

/// L-BFGS with Armijo's rule, from `unknowns`, which become the result. Returns the number of steps.
int Descend(QuadEnergy& energy, double epsilon, const DescentLimits& limits,
  Eigen::VectorXd& unknowns, const Progress& progress = {});
}
