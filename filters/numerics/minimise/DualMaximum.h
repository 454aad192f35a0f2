#pragma once

#include "BlockCholesky.h"
#include "DualProblem.h"
#include "Minimisation.h"
#include "Progress.h"

#include <limits>

namespace crossfield
{
/// The dual function at one λ. While H(λ) = S + Σ λ_i A_i is positive definite, x(λ) = H(λ)⁻¹ b
/// minimises the Lagrangian, and
///   q(λ) = −½ bᴴ x(λ) − Σ λ_i t_i
/// is concave with ∂q/∂λ_i = C_i(x(λ)) − t_i and ∂²q/∂λ_i∂λ_j = −Re((A_i x)ᴴ H⁻¹ A_j x).
struct DualPoint
{
  Eigen::VectorXd multipliers;
  bool positiveDefinite = false; ///< Without this only the multipliers are set.
  ComplexVector x;               ///< In the bases of the problem.
  ComplexVector normals;         ///< Part i is A_i x.
  double value = 0.0;
  double logDeterminant = 0.0;                               ///< Of H.
  Eigen::VectorXd gradient;                                  ///< C_i(x) − t_i.
  double residual = std::numeric_limits<double>::infinity(); ///< Of all optimality conditions.
  BlockCholesky<Complex> factor;                             ///< Of H.
  bool onBorder = false; ///< MaximiseFromZero has found that q has its maximum on the border.
};

DualPoint EvaluateDual(const DualProblem& problem, Eigen::VectorXd multipliers);

/// Whether H(λ) is positive definite with all couplings: its smallest eigenvalue without some of them is above
/// their norm.
bool IsCertain(const DualProblem& problem, const DualPoint& point);

/// Whole Newton steps on q from a point so close to the maximum that they converge quadratically.
/// Ends at the first step that leads out of the region where H is positive definite, or that does not
/// help. Adds its steps to `iterations`.
DualPoint MaximiseNearby(const DualProblem& problem, DualPoint point,
  const MinimiserOptions& options, const Progress& progress, int& iterations);

/// The maxima of q + μ log det H with falling μ, from λ = 0: along the tangent of their path, and by Newton's method back to
/// it; then MaximiseNearby.
///
/// Newton's model of q alone does not see the border of the region, on which q is finite wherever b is
/// orthogonal to the kernel of H: a line search would end there. The barrier keeps the path in the
/// middle. Its maximum is within the gap μ dim H of that of q; where Newton's model of q promises far more
/// than that, q has its maximum on the border, and the path ends with the residual that is left there.
DualPoint MaximiseFromZero(const DualProblem& problem, const MinimiserOptions& options,
  const Progress& progress, int& iterations);
}
