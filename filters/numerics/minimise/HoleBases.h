#pragma once

#include "DualProblem.h"

#include <limits>

namespace crossfield
{
/// An orthonormal basis of the values on every hole of a reduced problem, in the order in which its members are coupled
/// to other holes, the strongest last, and S in these bases: made once for any number of tolerances
/// (docs/method.md §3.4).
class HoleBases
{
public:
  /// The problem has to outlive this.
  explicit HoleBases(const ReducedProblem& problem);

  const ReducedProblem& GetProblem() const { return this->Problem; }

  /// Leaves out as many couplings between a hole and the others as stay below a part of the mean of the diagonal of S,
  /// by the Frobenius norm of every hole; those that are largest are kept, at most so many members of every hole.
  DualProblem InBlocks(
    double tolerance, Eigen::Index most = std::numeric_limits<Eigen::Index>::max()) const;

  /// With the strong couplings only, for the dozens of factors of an iteration: what is left out then costs steps at its
  /// end. No more members in all than BLAS factors in a tenth of a second, or four of every hole: those that turn
  /// once and twice around it.
  DualProblem InFewBlocks() const;

  /// Couplings that are strong, as a part of the mean of the diagonal of S.
  static constexpr double Strong = 1e-4;

private:
  const ReducedProblem& Problem;
  DualProblem Complete;      ///< Without `coupled`, `coupling` and `leftOut`.
  GramMatrix InBases;        ///< S in the bases.
  Eigen::VectorXd Couplings; ///< Of every member, the norm of what couples it to other holes.
  double MeanDiagonal = 0.0; ///< Of S.
};
}
