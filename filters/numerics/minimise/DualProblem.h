#pragma once

#include "BlockMatrix.h"
#include "ReducedProblem.h"

#include <vector>

namespace crossfield
{
/// Reduced problem in an orthonormal basis of the values x on every hole, in which most basis
/// vectors ("members") are coupled to their own hole only (docs/method.md §3.4).
struct DualProblem
{
  BlockMatrix matrix;                        ///< S in these bases, with one block per hole.
  ComplexVector load;                        ///< b in these bases, hole by hole.
  std::vector<Eigen::MatrixXcd> constraints; ///< A_i of every hole in its basis.
  std::vector<Eigen::MatrixXd>
    /// Basis of every hole: the members are columns, their rows are in the order of `unknowns`.
    bases;
  std::vector<std::vector<int>> unknowns; ///< Unknowns of the reduced problem on every hole.
  Eigen::VectorXd targets;
  Eigen::VectorXd sizes; ///< Number of edges of every hole.
  /// Bound on the norm of the couplings between holes that were left out.
  double leftOut = 0.0;

  /// Diagonal of a matrix M such that the couplings left out are between −M and M: one value for
  /// uncoupled members, one for all others.
  struct Margin
  {
    double uncoupled;
    double coupled;
  };
  Margin MarginOfLeftOut() const;

  /// Problem with all couplings, with which x(λ) is refined; without it x(λ) belongs to the matrix
  /// above.
  const ReducedProblem* refinedWith = nullptr;

  /// Returns S x, with all couplings if `refinedWith` is set.
  ComplexVector Elastic(const ComplexVector& x) const;

  /// Transform from the unknowns of the reduced problem to the bases, and back.
  ComplexVector InBases(const ComplexVector& x) const;
  ComplexVector InValues(const ComplexVector& x) const;
};
}
