#pragma once

#include "SizeField.h"

#include <vector>

namespace crossfield
{
/// Equilateral triangles over a box: the point of a column and a row is at
/// origin + spacing (column + ½ [row is odd], ½ √3 row).
struct TriangularLattice
{
  Point origin = Point::Zero();
  double spacing = 0.0;
  int columns = 0;
  int rows = 0;

  double RowHeight() const;
  Point At(int column, int row) const;
  Point At(std::size_t number) const;
  /// Column of the point above and below the middle between a point and the next one of its row.
  static int ColumnBetween(int column, int row) { return column + row % 2; }
  std::size_t Count() const;
  /// Row by row.
  std::size_t NumberOf(int column, int row) const;
};

/// A graded triangular lattice over the box of a size field: points about h(x) apart, in
/// equilateral triangles where h is constant (docs/method.md §10.1: the bulk of a mesh).
///
/// The lattice of spacing s/2 contains the one of spacing s, so lattices of spacing 2⁻ˡ times the
/// largest size fit together: a point that belongs to spacing 2⁻ˡ but to no larger one is taken
/// where h asks for that spacing. Between two spacings the triangles are halves of equilateral
/// ones.
struct GradedLattice
{
  TriangularLattice coarsest; ///< All of its points; the last of a row may be outside of the box.
  std::vector<Point> finer;   ///< Leaf by leaf, neighbours near to each other.
};

GradedLattice MakeGradedLattice(const SizeField& size);
}
