#pragma once

#include "Plane.h"

#include <utility>

namespace crossfield
{
/// A closed polyline by the length along it from its first vertex.
class LoopArc
{
public:
  explicit LoopArc(const Loop& loop);

  /// One loop round.
  double Length() const { return this->Starts.back(); }
  /// Where a vertex is; that of the number of vertices is the length of the whole loop.
  double Start(std::size_t vertex) const { return this->Starts[vertex]; }
  const Loop& Vertices() const { return this->Polyline; }

  // Lengths may be of more than one round, or negative.

  /// The side at a length, that after a vertex at it, and which part of it is before: in [0, 1].
  std::pair<std::size_t, double> SideAt(double length) const;

  /// The place at a length.
  Point At(double length) const;

  /// Unit vector along the side at a length.
  Point Tangent(double length) const;

  /// The vertex nearest to a length along the loop.
  std::size_t NearestVertex(double length) const;

  /// Where the point of the loop is that is nearest to a place; the vertex between two sides that are equally
  /// near. Linear in the vertices.
  double Nearest(const Point& place) const;

  /// The same, if it is not farther than a reach; else negative.
  double Find(const Point& place, double reach) const;
  /// Where those of some places are that are not farther than a reach.
  std::vector<double> FindAll(const std::vector<Point>& places, double reach) const;

  /// Angles from side to side at the vertices, positive to the left.
  std::vector<double> Turns() const;

  /// Where the vertices are that turn by more than an angle (IsCorner), in order.
  std::vector<double> Corners(double cornerAngle) const;

private:
  double Folded(double length) const;
  const Point& End(std::size_t side) const
  {
    return this->Polyline[(side + 1) % this->Polyline.size()];
  }

  Loop Polyline;
  std::vector<double> Starts; ///< One more than there are vertices.
};

/// A vertex of a new loop, and which place of the old one it stands for.
struct ArcVertex
{
  double at = 0.0; ///< Length along the old loop, in [0, Length()).
  Point place = Point::Zero();
};

/// The largest distance of the vertices of a loop to the sides of a new one that stand for them: those from
/// one of its vertices, whose `at` increase, to the next, round the loop.
double LargestDistance(const LoopArc& arc, const std::vector<ArcVertex>& vertices);

/// The places of vertices.
Loop PlacesOf(const std::vector<ArcVertex>& vertices);
}
