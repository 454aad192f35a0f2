#pragma once

#include "BlockMatrix.h"
#include "ReducedProblem.h"

#include <vector>

namespace crossfield
{
/// The reduced problem in an orthonormal basis of the values x on every hole, in which most members are coupled to
/// their own hole only (docs/method.md §3.4).
struct DualProblem
{
  BlockMatrix matrix;                        ///< S in these bases, a block per hole.
  ComplexVector load;                        ///< b in these bases, hole by hole.
  std::vector<Eigen::MatrixXcd> constraints; ///< Of every hole, A_i in its basis.
  std::vector<Eigen::MatrixXd>
    bases; ///< Of every hole: the members are columns, values in the order of
  std::vector<std::vector<int>> unknowns; ///< these unknowns of the reduced problem.
  Eigen::VectorXd targets;
  Eigen::VectorXd sizes; ///< Number of edges of every hole.
  /// Bound on the norm of what was left out between holes.
  double leftOut = 0.0;

  /// What was left out lies between −M and M with a diagonal M, which has this on members that are not coupled, and on all others.
  struct Margin
  {
    double uncoupled;
    double coupled;
  };
  Margin MarginOfLeftOut() const;

  /// What x(λ) is refined with until nothing is left out of it; without it x(λ) is that of the matrix above.
  const ReducedProblem* refinedWith = nullptr;

  /// S x, with all couplings if there is refinedWith.
  ComplexVector Elastic(const ComplexVector& x) const;

  /// From the unknowns of the reduced problem, and to them.
  ComplexVector InBases(const ComplexVector& x) const;
  ComplexVector InValues(const ComplexVector& x) const;
};
}
