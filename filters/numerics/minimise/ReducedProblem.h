#pragma once

#include "DegreeConstraint.h"

#include <Eigen/Core>

namespace crossfield
{
/// The constrained problem after everything but the hole edges is eliminated (docs/method.md §3):
///   minimise ½ xᴴ S x − Re(bᴴ x)   subject to   ½ xᴴ A_i x = t_i.
struct ReducedProblem
{
  Eigen::MatrixXd matrix; ///< S, symmetric positive definite.
  ComplexVector load;     ///< b; S⁻¹ b are the values of the field without constraints.
  std::vector<DegreeConstraint> constraints; ///< Every unknown belongs to exactly one.
};

struct ReducedOptions
{
  int maximumIterations = 100;
  /// Converged when the residual of the optimality conditions, relative to the size of their
  /// terms, is below this. Rounding allows about 1e-14; 1e-10 leaves room for large meshes.
  double tolerance = 1e-10;
};

struct ReducedSolution
{
  ComplexVector x;
  Eigen::VectorXd multipliers;
  int iterations = 0;
  double residual = 0.0;
  bool converged = false;

  /// −Σ λ_i A_i x: the forces on the hole edges that hold the constraints, S x − b when solved.
  ComplexVector Forces(const ReducedProblem& problem) const;
};
}
