#pragma once

#include "DegreeConstraint.h"

namespace crossfield
{
/// A constraint ½ xᴴ A x = target with a sparse Hermitian matrix A: the degree of one hole or of
/// several together, or the norm of one unknown (docs/method.md §3.7, variants 1 to 3).
struct QuadraticConstraint
{
  struct Entry
  {
    int row;
    int column;
    Complex value;
  };
  std::vector<Entry> entries; ///< Of A, both halves.
  double target = 0.0;
  double size = 1.0; ///< Number of terms of size one in it; what a violation is measured by.

  /// ½ xᴴ A x.
  double Value(const ComplexVector& x) const;
  /// A x as a real vector: entries 2i and 2i + 1 are the parts of entry i.
  Eigen::VectorXd Gradient(const ComplexVector& x) const;
  /// The same as entries of this column of a sparse matrix, repeated ones add up.
  void AddGradient(
    const ComplexVector& x, int column, std::vector<Eigen::Triplet<double>>& entriesOfMatrix) const;
};

/// The sum of some degree constraints: one of them, or the global constraint on them all.
QuadraticConstraint SumOfDegrees(const std::vector<DegreeConstraint>& constraints);

/// |x_i| = 1.
QuadraticConstraint UnitNorm(int unknown);
}
