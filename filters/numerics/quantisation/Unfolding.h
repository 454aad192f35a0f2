#pragma once

#include "TMesh.h"

#include <array>
#include <map>

namespace crossfield
{
/// A vector of the plane whose coordinates are sums of the numbers of arcs: per arc its factors of x and y.
class ArcVector
{
public:
  void Add(int arc, const std::array<int, 2>& factor);
  void Subtract(const ArcVector& other);

  /// Σ factor of one axis (0 x, 1 y) times the value of each arc.
  template <class Values>
  double Along(std::size_t axis, const Values& values) const
  {
    double sum = 0.0;
    for (const auto& [arc, factor] : this->Factors)
    {
      sum += factor[axis] * static_cast<double>(values[static_cast<std::size_t>(arc)]);
    }
    return sum;
  }
  const std::map<int, std::array<int, 2>>& GetFactors() const { return this->Factors; }

private:
  std::map<int, std::array<int, 2>> Factors;
};

/// Where a way touches the outline of a face: at the start of a half-edge, or inside of it.
struct FaceSpot
{
  int half = -1;
  bool inside = false;
};

/// Lays faces of a T-mesh into one plane, one after the other along a way (docs/method.md §14.3). Sides are sums of the
/// numbers of their arcs, so that places are ArcVectors; opposite sides are equal by the equations.
class Unfolding
{
public:
  explicit Unfolding(const TMesh& mesh);

  /// Begins with the face of a spot.
  void Begin(const FaceSpot& spot);
  /// Goes on to the face of `to`, around the point that both spots are. False if that is not possible: they are not at
  /// one point, or the boundary is in between.
  bool Turn(const FaceSpot& from, const FaceSpot& to);
  /// Where the half-edge of a spot of the present face starts.
  ArcVector StartOf(int half) const;
  /// The axis that a half-edge of the present face runs along.
  std::size_t AxisOf(int half) const { return static_cast<std::size_t>(this->TurnsOf(half) % 2); }

  /// A half-edge that starts where another one of the same face ends.
  int Next(int half) const { return this->Mesh.halfEdges[static_cast<std::size_t>(half)].next; }

private:
  struct Place
  {
    std::size_t side = 0;
    std::size_t index = 0;
    int previous = -1; ///< Half-edge around the face.
  };

  int FaceOf(int half) const { return this->Mesh.halfEdges[static_cast<std::size_t>(half)].patch; }
  const Place& PlaceOf(int half) const { return this->Places[static_cast<std::size_t>(half)]; }
  int TurnsOf(int half) const
  {
    return (this->Turns + static_cast<int>(this->PlaceOf(half).side)) % 4;
  }
  /// To the other side of a half-edge of the present face.
  void Cross(int half);

  const TMesh& Mesh;
  std::vector<Place> Places;
  int Turns = 0;    ///< Of the present face.
  ArcVector Origin; ///< Its first corner.
};
}
