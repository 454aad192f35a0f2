#pragma once

#include "DegreeConstraint.h"

namespace crossfield
{
/// The constrained problem after everything but the hole edges is eliminated (docs/method.md §3.2):
///   minimise ½ xᴴ S x − Re(bᴴ x)   subject to   ½ xᴴ A_i x = t_i.
struct ReducedProblem
{
  Eigen::MatrixXd matrix; ///< S, symmetric positive definite.
  ComplexVector load;     ///< b; S⁻¹ b are the values of the field without constraints.
  std::vector<DegreeConstraint> constraints; ///< Every unknown belongs to exactly one.
};
}
