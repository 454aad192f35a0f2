#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

#include <Eigen/Core>

#include <functional>

namespace crossfield::test
{
/// First and second derivatives of a function, by central differences.
struct Derivatives
{
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};
Derivatives Differentiate(const std::function<double(const Eigen::VectorXd&)>& function,
  const Eigen::VectorXd& at, double step);

/// Minimises a function by Newton's method with finite differences, damped until each step
/// decreases the function. Stops where the gradient vanishes up to rounding and the second
/// derivatives have no descent direction.
Eigen::VectorXd Minimise(
  const std::function<double(const Eigen::VectorXd&)>& function, Eigen::VectorXd start);

/// Properties of a configuration among those with the same holonomy defects, from values of W and
/// of the defects on a mesh of a given size.
struct MinimumCheck
{
  /// Lowest eigenvalue of the second derivatives of W in the directions that preserve the defects;
  /// negative at a saddle.
  double lowestEigenvalue = 0.0;
  /// Decrease of W from the configuration to the minimum of its second-order expansion.
  double gain = 0.0;
};
MinimumCheck CheckMinimum(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize);
}
