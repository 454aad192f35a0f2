#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

#include <Eigen/Core>

#include <functional>

namespace crossfield::test
{
/// First and second derivatives of a function by central differences.
struct Derivatives
{
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};
Derivatives Differentiate(const std::function<double(const Eigen::VectorXd&)>& function,
  const Eigen::VectorXd& at, double step);

/// Newton's method with differences, damped until every step goes down. It ends where the gradient
/// vanishes but for rounding, and the second derivatives have no direction down.
Eigen::VectorXd Minimise(
  const std::function<double(const Eigen::VectorXd&)>& function, Eigen::VectorXd start);

/// What values of W and of the defects alone, on a mesh of this size, say of a configuration among those with
/// the same holonomy defects.
struct MinimumCheck
{
  /// Of the second derivatives of W in all directions that keep the defects; below 0 at a saddle.
  double lowestEigenvalue = 0.0;
  /// How much lower W is where its second-order expansion has its minimum.
  double gain = 0.0;
};
MinimumCheck CheckMinimum(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize);
}
