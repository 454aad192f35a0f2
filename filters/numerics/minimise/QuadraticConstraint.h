#pragma once

#include "DegreeConstraint.h"

namespace crossfield
{
/// Constraint ½ xᴴ A x = target with a sparse Hermitian matrix A: the degree of one hole or of
/// several together, or the norm of one unknown (docs/method.md §3.7, variants 1 to 3).
struct QuadraticConstraint
{
  struct Entry
  {
    int row;
    int column;
    Complex value;
  };
  std::vector<Entry> entries; ///< Entries of A, both triangles.
  double target = 0.0;
  double size = 1.0; ///< Number of terms of order one in the constraint; the scale for violations.

  /// Returns ½ xᴴ A x.
  double Value(const ComplexVector& x) const;
  /// Returns A x as a real vector; entries 2i and 2i + 1 are the real and imaginary parts of entry
  /// i.
  Eigen::VectorXd Gradient(const ComplexVector& x) const;
  /// Appends A x as entries of a column of a sparse matrix; repeated entries are summed.
  void AddGradient(
    const ComplexVector& x, int column, std::vector<Eigen::Triplet<double>>& entriesOfMatrix) const;
};

/// Returns the sum of several degree constraints: a single one, or the global constraint on all.
QuadraticConstraint SumOfDegrees(const std::vector<DegreeConstraint>& constraints);

/// Returns the constraint |x_i| = 1.
QuadraticConstraint UnitNorm(int unknown);
}
