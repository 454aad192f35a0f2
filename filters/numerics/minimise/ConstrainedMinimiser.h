#pragma once

#include "Minimisation.h"
#include "Progress.h"
#include "QuadraticConstraint.h"

namespace crossfield
{
/// A function of complex unknowns x to be minimised under quadratic constraints or none, and the linear
/// solver for its Newton steps. Real vectors have the parts of x_i in entries 2i and 2i + 1.
class ConstrainedFunctional
{
public:
  virtual ~ConstrainedFunctional() = default;
  virtual double Value(const ComplexVector& x) const = 0;
  virtual Eigen::VectorXd Gradient(const ComplexVector& x) const = 0;
  /// Sum of the norms of the terms that cancel in the gradient, to measure residuals by.
  virtual double GradientScale(const ComplexVector& x) const = 0;
  /// For a functional that is not convex by itself, the diagonal matrix that its negative curvature is
  /// measured by: saddles are left in the direction in which it is least, and each step begins with the
  /// shift that the last one needed. Empty: only the constraints can make a saddle, and it says that
  /// the start was a bad one, so the iteration ends there.
  virtual Eigen::VectorXd Metric() const { return {}; }
  /// Where a motion is known that keeps the value of every constraint, the best place along it from x.
  virtual ComplexVector Relax(const ComplexVector& x) const { return x; }
  /// Mean of the diagonal of the quadratic part, the size of a second derivative.
  virtual double Stiffness() const = 0;

  /// What is added to the second derivatives at x: Σ λ_i A_i, weight × N Nᵀ, and shift × M with a
  /// positive definite M that makes them positive definite for some shift.
  struct Additions
  {
    std::vector<QuadraticConstraint::Entry> constraints; ///< Of Σ λ_i A_i, repeated ones add up.
    Eigen::VectorXd multipliers;                         ///< λ_i.
    Eigen::SparseMatrix<double> normals;                 ///< Column i is A_i x.
    double weight = 0.0;
    double shift = 0.0;
    bool certain =
      false; ///< Whether it has to be certain that the sum is positive definite; else a step is made with it.
  };
  /// Factors that sum; false when it is not positive definite.
  virtual bool Factor(const ComplexVector& x, const Additions& additions) = 0;
  virtual Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const = 0;
  /// Nᵀ H⁻¹ N with the H that was factored last.
  virtual Eigen::MatrixXd Forms(const Eigen::SparseMatrix<double>& normals) const
  {
    return normals.transpose() * this->Solve(normals);
  }
};

/// A local minimiser near a start.
///
/// Sequential quadratic programming with a line search on the merit f(x) + ν Σ |c_i(x)|, c_i the
/// violations; without constraints, Newton's method with a line search on f, which never rises by more
/// than rounding. Where the Lagrangian's Hessian is not positive definite on the constraints' tangent
/// space it is convexified by the smallest of a sequence of multiples of M, each four times the one before, that
/// makes it so. The solution is converged only if no such help is needed there, that is, if the optimality
/// system has as many negative eigenvalues as constraints; otherwise it is a saddle. Where one can be
/// left (Metric), that is done there, and where convexified steps lower the merit by less than 1e-4 of
/// itself.
///
/// Throws Error when no multiple of M helps, as on a mesh in several parts.
MinimiserResult MinimiseConstrained(ConstrainedFunctional& functional,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});
}
