#pragma once

#include "ConstrainedMinimiser.h"
#include "HoleBases.h"

namespace crossfield
{
/// minimise ½ xᴴ S x − Re(bᴴ x) under any quadratic constraints: ReducedProblem with a Hermitian S.
struct QuadraticProblem
{
  Eigen::MatrixXcd matrix;
  ComplexVector load;
  std::vector<QuadraticConstraint> constraints;
};

/// A local minimiser near a given point, by ConstrainedMinimiser.h; M = S.
MinimiserResult SolveQuadratic(const QuadraticProblem& problem, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});

/// A local minimiser of the reduced problem near a given point, for example near the values of the
/// unit-norm field; its degrees can be right where those of the global minimiser are not.
MinimiserResult SolveReducedFrom(const HoleBases& bases, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});
}
