#pragma once

#include "ConstrainedMinimiser.h"
#include "HoleBases.h"

namespace crossfield
{
/// Problem: minimise ½ xᴴ S x − Re(bᴴ x) under any quadratic constraints; ReducedProblem with a
/// Hermitian S.
struct QuadraticProblem
{
  Eigen::MatrixXcd matrix;
  ComplexVector load;
  std::vector<QuadraticConstraint> constraints;
};

/// Finds a local minimiser near a given point by ConstrainedMinimiser.h, with M = S.
MinimiserResult SolveQuadratic(const QuadraticProblem& problem, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});

/// Finds a local minimiser of the reduced problem near a given point, for example near the values
/// of the unit-norm field. Its degrees can be correct where those of the global minimiser are not.
MinimiserResult SolveReducedFrom(const HoleBases& bases, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});
}
