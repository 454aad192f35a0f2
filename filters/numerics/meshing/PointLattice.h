#pragma once

#include "SizeField.h"

#include <vector>

namespace crossfield
{
/// Lattice of equilateral triangles over a box. The point of a column and row is origin + spacing
/// (column + ½ [row is odd], ½ √3 row).
struct TriangularLattice
{
  Point origin = Point::Zero();
  double spacing = 0.0;
  int columns = 0;
  int rows = 0;

  double RowHeight() const;
  Point At(int column, int row) const;
  Point At(std::size_t number) const;
  /// Returns the column of the point above and below the midpoint between a point and the next one
  /// of its row.
  static int ColumnBetween(int column, int row) { return column + row % 2; }
  std::size_t Count() const;
  /// Returns the index of a point; points are numbered row by row.
  std::size_t NumberOf(int column, int row) const;
};

/// Graded triangular lattice over the box of a size field: points about h(x) apart, in equilateral
/// triangles where h is constant (docs/method.md §10.1: the bulk of a mesh).
///
/// The lattice of spacing s/2 contains the lattice of spacing s, so lattices of spacing 2⁻ˡ times
/// the largest size are nested. A point that belongs to spacing 2⁻ˡ but to no larger one is
/// included where h requires that spacing. Between two spacings the triangles are halves of
/// equilateral ones.
struct GradedLattice
{
  /// All points of the coarsest lattice; the last one of a row may be outside the box.
  TriangularLattice coarsest;
  /// Points of finer lattices, ordered by leaf, so that neighbours are close to each other.
  std::vector<Point> finer;
};

GradedLattice MakeGradedLattice(const SizeField& size);
}
