#pragma once

#include "DualProblem.h"

#include <limits>

namespace crossfield
{
/// Orthonormal bases of the values on every hole of a reduced problem, and S in these bases. The
/// members of a basis are ordered by the strength of their coupling to other holes, the strongest
/// last. Computed once for any number of tolerances (docs/method.md §3.4).
class HoleBases
{
public:
  /// Computes the bases. The problem must outlive this object.
  explicit HoleBases(const ReducedProblem& problem);

  const ReducedProblem& GetProblem() const { return this->Problem; }

  /// Returns the problem without weak couplings: leaves out as many couplings between a hole and
  /// the others as stay below `tolerance` times the mean diagonal of S, in the Frobenius norm of
  /// each hole. Keeps the strongest couplings, for at most `maximumMembers` members of every hole.
  DualProblem InBlocks(
    double tolerance, Eigen::Index maximumMembers = std::numeric_limits<Eigen::Index>::max()) const;

  /// Returns the problem with the strong couplings only, for at most `members` members of every
  /// hole or, with fewer than 300 holes, as many in total as for 300. Used for the dozens of
  /// factorisations of an iteration, where couplings left out only cost steps.
  DualProblem InFewBlocks(Eigen::Index members) const;

  /// Returns the total number of members that InBlocks keeps.
  Eigen::Index CoupledMembers(double tolerance) const;

  /// Tolerance for strong couplings, relative to the mean diagonal of S.
  static constexpr double Strong = 1e-4;

private:
  /// Number of leading members of a hole that stay below a tolerance times the mean diagonal of S
  /// and are not among the last `maximumMembers`, and the norm of their couplings.
  struct LeftOut
  {
    Eigen::Index members = 0;
    double norm = 0.0;
  };
  LeftOut CountLeftOut(int hole, double tolerance, Eigen::Index maximumMembers) const;

  const ReducedProblem& Problem;
  DualProblem Complete;      ///< Without `coupled`, `coupling` and `leftOut`.
  GramMatrix InBases;        ///< S in the bases.
  Eigen::VectorXd Couplings; ///< Norm of the couplings of every member to other holes.
  double MeanDiagonal = 0.0; ///< Mean diagonal of S.
};
}
