#include "ReducedProblem.h"

namespace crossfield
{
ComplexVector ReducedSolution::Forces(const ReducedProblem& problem) const
{
  ComplexVector forces = ComplexVector::Zero(this->x.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    forces -=
      this->multipliers[static_cast<Eigen::Index>(i)] * problem.constraints[i].Gradient(this->x);
  }
  return forces;
}
}
