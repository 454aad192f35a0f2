#pragma once

#include "DegreeConstraint.h"
#include "GramMatrix.h"

namespace crossfield
{
/// Constrained problem after elimination of all unknowns except those on hole edges (docs/method.md
/// §3.2):
///   minimise ½ xᴴ S x − Re(bᴴ x)  subject to  ½ xᴴ A_i x = t_i.
struct ReducedProblem
{
  GramMatrix matrix;  ///< S, symmetric positive definite, with one block per constraint.
  ComplexVector load; ///< b; S⁻¹ b are the values of the field without constraints.
  std::vector<DegreeConstraint> constraints; ///< The unknowns of each are those of its block, in
                                             ///< their order.
};
}
