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

  /// With the strong couplings only, of no more than so many members of every hole or, with fewer than 300 holes, as many
  /// in all as of 300: for the dozens of factors of an iteration, in which what is left out may cost steps.
  DualProblem InFewBlocks(Eigen::Index members) const;

  /// How many members InBlocks keeps in all.
  Eigen::Index CoupledMembers(double tolerance) const;

  /// Couplings that are strong, as a part of the mean of the diagonal of S.
  static constexpr double Strong = 1e-4;

private:
  /// How many of the first members of a hole stay below a part of the mean of the diagonal of S and are not among the last
  /// `most`, and the norm of their couplings.
  struct LeftOut
  {
    Eigen::Index members = 0;
    double norm = 0.0;
  };
  LeftOut LeftOutOf(int hole, double tolerance, Eigen::Index most) const;

  const ReducedProblem& Problem;
  DualProblem Complete;      ///< Without `coupled`, `coupling` and `leftOut`.
  GramMatrix InBases;        ///< S in the bases.
  Eigen::VectorXd Couplings; ///< Of every member, the norm of what couples it to other holes.
  double MeanDiagonal = 0.0; ///< Of S.
};
}
