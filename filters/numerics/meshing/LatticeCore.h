#pragma once

#include "PointLattice.h"

#include <array>
#include <functional>
#include <vector>

namespace crossfield
{
/// The triangles of a lattice that are far from everything else in a domain (docs/method.md §10.1). Their circumcircles are
/// empty, so they are of the Delaunay triangulation of the lattice's points and all others, whatever these are.
///
/// A point of the lattice is in the core when it is inside the domain and nothing else is within `margin` spacings; a
/// triangle when its three points are.
class LatticeCore
{
public:
  /// Numbers of points as the lattice has them.
  using Triangle = std::array<std::size_t, 3>;

  /// Without triangles.
  LatticeCore() = default;

  /// `others` are the other points of the triangulation, on boundaries no further apart than the spacing. `isInside` is asked of
  /// one point of those in a row that nothing separates.
  LatticeCore(const TriangularLattice& lattice, const std::vector<Point>& others, int margin,
    const std::function<bool(const Point&)>& isInside);

  const TriangularLattice& GetLattice() const { return this->Lattice; }
  /// Counter-clockwise, row by row.
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// Edges of one triangle only, which is on their left.
  const std::vector<std::array<std::size_t, 2>>& GetBorder() const { return this->Border; }
  /// First triangles of rows of neighbours: their union meets every part of the core.
  const std::vector<std::size_t>& GetFirsts() const { return this->Firsts; }
  /// Whether all triangles at a point are in the core.
  bool IsInterior(int column, int row) const;

private:
  bool IsCore(int column, int row) const;
  void CollectTriangles();

  TriangularLattice Lattice;
  std::vector<bool> Core; ///< Of every point.
  std::vector<Triangle> Triangles;
  std::vector<std::array<std::size_t, 2>> Border;
  std::vector<std::size_t> Firsts;
};
}
