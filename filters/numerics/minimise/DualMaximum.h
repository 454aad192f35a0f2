#pragma once

#include "BlockCholesky.h"
#include "DualProblem.h"
#include "Minimisation.h"
#include "Progress.h"

#include <limits>

namespace crossfield
{
/// Dual function at one λ. While H(λ) = S + Σ λ_i A_i is positive definite, x(λ) = H(λ)⁻¹ b
/// minimises the Lagrangian, and
///   q(λ) = −½ bᴴ x(λ) − Σ λ_i t_i
/// is concave with ∂q/∂λ_i = C_i(x(λ)) − t_i and ∂²q/∂λ_i∂λ_j = −Re((A_i x)ᴴ H⁻¹ A_j x).
struct DualPoint
{
  Eigen::VectorXd multipliers;
  bool positiveDefinite = false; ///< Whether H(λ) is; if not, only the multipliers are set.
  ComplexVector x;               ///< In the bases of the problem.
  ComplexVector normals;         ///< Part i is A_i x.
  double value = 0.0;
  double logDeterminant = 0.0; ///< log det H.
  Eigen::VectorXd gradient;    ///< C_i(x) − t_i.
  /// Relative residual of all optimality conditions.
  double residual = std::numeric_limits<double>::infinity();
  BlockCholesky<Complex> factor; ///< Factor of H.
  bool onBorder = false; ///< Whether MaximiseFromZero has found the maximum of q on the border.
};

DualPoint EvaluateDual(const DualProblem& problem, Eigen::VectorXd multipliers);

/// Returns whether H(λ) is positive definite with all couplings: its smallest eigenvalue without
/// the couplings left out exceeds their norm.
bool IsCertain(const DualProblem& problem, const DualPoint& point);

/// Takes full Newton steps on q from a point so close to the maximum that they converge
/// quadratically. Ends at the first step that leaves the region where H is positive definite or
/// brings no improvement. Adds the number of steps to `iterations`.
DualPoint MaximiseNearby(const DualProblem& problem, DualPoint point,
  const MinimiserOptions& options, const Progress& progress, int& iterations);

/// Follows the maxima of q + μ log det H for decreasing μ from λ = 0: predicts along the tangent of
/// their path and corrects by Newton's method; ends with MaximiseNearby.
///
/// Newton's model of q alone does not see the border of the region, on which q is finite wherever b
/// is orthogonal to the kernel of H: a line search would end there. The barrier keeps the path in
/// the interior. Its maximum is within the gap μ dim H of the maximum of q. Where Newton's model of
/// q predicts an increase far above the gap, q has its maximum on the border, and the path ends
/// there with the remaining residual.
DualPoint MaximiseFromZero(const DualProblem& problem, const MinimiserOptions& options,
  const Progress& progress, int& iterations);
}
