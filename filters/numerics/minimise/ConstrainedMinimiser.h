#pragma once

#include "Minimisation.h"
#include "Progress.h"
#include "QuadraticConstraint.h"

namespace crossfield
{
/// Function of complex unknowns x to be minimised, with or without quadratic constraints, and the
/// linear solver for its Newton steps. Real vectors store the real and imaginary parts of x_i in
/// entries 2i and 2i + 1.
class ConstrainedFunctional
{
public:
  virtual ~ConstrainedFunctional() = default;
  virtual double Value(const ComplexVector& x) const = 0;
  virtual Eigen::VectorXd Gradient(const ComplexVector& x) const = 0;
  /// Returns the sum of the norms of the terms that cancel in the gradient, the scale for
  /// residuals.
  virtual double GradientScale(const ComplexVector& x) const = 0;
  /// Returns, for a functional that is not convex, the diagonal matrix relative to which negative
  /// curvature is measured: saddles are left in the direction of minimum curvature, and each step
  /// starts with the shift of the previous one. If empty, only the constraints can cause a saddle.
  /// A saddle then indicates a bad start, and the iteration ends there.
  virtual Eigen::VectorXd Metric() const { return {}; }
  /// Returns the best point along a motion from x that preserves the value of every constraint, if
  /// such a motion is known; otherwise x.
  virtual ComplexVector Relax(const ComplexVector& x) const { return x; }
  /// Returns the mean diagonal entry of the quadratic part, the scale of second derivatives.
  virtual double Stiffness() const = 0;

  /// Terms added to the second derivatives at x: Σ λ_i A_i, weight × N Nᵀ, and shift × M, where M
  /// is a positive definite matrix that makes the sum positive definite for some shift.
  struct Additions
  {
    /// Entries of Σ λ_i A_i; repeated ones are summed.
    std::vector<QuadraticConstraint::Entry> constraints;
    Eigen::VectorXd multipliers;         ///< λ_i.
    Eigen::SparseMatrix<double> normals; ///< Column i is A_i x.
    double weight = 0.0;
    double shift = 0.0;
    bool certain =
      /// Whether the sum must be proved positive definite; otherwise the factor only serves for a
      /// step.
      false;
  };
  /// Factors that sum; returns false when it is not positive definite.
  virtual bool Factor(const ComplexVector& x, const Additions& additions) = 0;
  virtual Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const = 0;
  /// Returns Nᵀ H⁻¹ N, where H is the matrix factored last.
  virtual Eigen::MatrixXd Forms(const Eigen::SparseMatrix<double>& normals) const
  {
    return normals.transpose() * this->Solve(normals);
  }
};

/// Finds a local minimiser near a start.
///
/// Uses sequential quadratic programming with a line search on the merit f(x) + ν Σ |c_i(x)|, where
/// c_i are the violations. Without constraints this is Newton's method with a line search on f,
/// which never increases by more than rounding. Where the Lagrangian's Hessian is not positive
/// definite on the tangent space of the constraints, it is convexified by the smallest sufficient
/// multiple of M from a sequence in which each multiple is four times the previous one. The
/// solution counts as converged only if no convexification is needed there, that is, if the
/// optimality system has as many negative eigenvalues as constraints; otherwise it is a saddle. If
/// the functional has a Metric, the minimiser leaves saddles, both when it has reached one and
/// where convexified steps decrease the merit by less than 1e-4 of itself.
///
/// Throws Error when no multiple of M suffices, as on a mesh in several parts.
MinimiserResult MinimiseConstrained(ConstrainedFunctional& functional,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});
}
