#pragma once

#include "PointLattice.h"

#include <array>
#include <functional>
#include <vector>

namespace crossfield
{
/// Triangles of a lattice that are far from all other points of a domain (docs/method.md §10.1).
/// Their circumcircles are empty, so they belong to the Delaunay triangulation of the lattice
/// points and any other points.
///
/// A lattice point is in the core if it is inside the domain and no other point is within `margin`
/// spacings. A triangle is in the core if its three points are.
class LatticeCore
{
public:
  /// Triangle, given by indices of lattice points.
  using Triangle = std::array<std::size_t, 3>;

  /// Constructs a core without triangles.
  LatticeCore() = default;

  /// Constructs the core. `others` are the other points of the triangulation; on boundaries they
  /// are no farther apart than the spacing. `isInside` is evaluated at one point of each run of
  /// points in a row that no boundary separates.
  LatticeCore(const TriangularLattice& lattice, const std::vector<Point>& others, int margin,
    const std::function<bool(const Point&)>& isInside);

  const TriangularLattice& GetLattice() const { return this->Lattice; }
  /// Returns the triangles, counter-clockwise, row by row.
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// Returns the edges that belong to only one triangle, which is on their left.
  const std::vector<std::array<std::size_t, 2>>& GetBorder() const { return this->Border; }
  /// Returns the indices of the first triangles of runs of adjacent triangles in a row. Each
  /// connected part of the core contains at least one of them.
  const std::vector<std::size_t>& GetFirsts() const { return this->Firsts; }
  /// Returns whether all triangles at a point are in the core.
  bool IsInterior(int column, int row) const;

private:
  bool IsCore(int column, int row) const;
  void CollectTriangles();

  TriangularLattice Lattice;
  std::vector<bool> Core; ///< Membership of each lattice point.
  std::vector<Triangle> Triangles;
  std::vector<std::array<std::size_t, 2>> Border;
  std::vector<std::size_t> Firsts;
};
}
