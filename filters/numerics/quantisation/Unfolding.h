#pragma once

#include "TMesh.h"

#include <array>
#include <map>

namespace crossfield
{
/// A vector of the plane whose coordinates are sums of edge counts: for each arc its factors in x
/// and y.
class ArcVector
{
public:
  void Add(int arc, const std::array<int, 2>& factor);
  void Subtract(const ArcVector& other);

  /// Returns Σ factor · value over the arcs, for one axis (0: x, 1: y).
  template <class Values>
  double Along(std::size_t axis, const Values& values) const
  {
    double sum = 0.0;
    for (const auto& [arc, factor] : this->Factors)
    {
      sum += factor[axis] * static_cast<double>(values[arc]);
    }
    return sum;
  }
  const std::map<int, std::array<int, 2>>& GetFactors() const { return this->Factors; }

private:
  std::map<int, std::array<int, 2>> Factors;
};

/// A point on the outline of a patch: the start of a half-edge, or a point in its interior.
struct PatchPoint
{
  int half = -1;
  bool inside = false;
};

/// Unfolds patches of a T-mesh into one plane, one after the other along a path (docs/method.md
/// §14.3). The length of a side is the sum of the edge counts of its arcs, so positions are
/// ArcVectors; opposite sides are equal by the equations.
class Unfolding
{
public:
  explicit Unfolding(const TMesh& mesh);

  /// Starts with the patch of a point, which is the origin.
  void Begin(const PatchPoint& point);
  /// Moves to the patch of `to` by a turn around the point, which is the same as `from`. Returns
  /// false if that is not possible: they are different points, or the boundary is in between.
  bool Turn(const PatchPoint& from, const PatchPoint& to);
  /// Returns the start of a half-edge of the present patch.
  ArcVector StartOf(int half) const;
  /// Returns the axis that a half-edge of the present patch is parallel to.
  std::size_t AxisOf(int half) const { return static_cast<std::size_t>(this->TurnsOf(half) % 2); }

  /// Returns the next half-edge around the patch.
  int Next(int half) const { return this->Mesh.halfEdges[half].next; }

private:
  /// The position of a half-edge in its patch.
  struct Place
  {
    std::size_t side = 0;
    std::size_t index = 0;
    int previous = -1; ///< The half-edge before it around the patch.
  };

  int PatchOf(int half) const { return this->Mesh.halfEdges[half].patch; }
  const Place& PlaceOf(int half) const { return this->Places[half]; }
  int TurnsOf(int half) const
  {
    return (this->Turns + static_cast<int>(this->PlaceOf(half).side)) % 4;
  }
  /// Moves to the patch on the other side of a half-edge of the present one.
  void Cross(int half);

  const TMesh& Mesh;
  std::vector<Place> Places;
  int Turns = 0;    ///< Quarter turns from the patch to the plane.
  ArcVector Origin; ///< First corner of the present patch.
};
}
