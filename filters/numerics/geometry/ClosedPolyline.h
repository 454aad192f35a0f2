#pragma once

#include "Plane.h"

#include <utility>
#include <vector>

namespace crossfield
{
/// Arc-length parametrisation of a closed polyline in the plane (Point) or in space (SpacePoint), starting at its
/// first vertex. Arc lengths may be negative or exceed the length of the polyline.
template <typename Place>
class ClosedPolyline
{
public:
  explicit ClosedPolyline(std::vector<Place> vertices);

  /// Returns the length of the polyline.
  double Length() const { return this->Starts.back(); }
  /// Returns the arc length at a vertex; for the number of vertices, the length of the polyline.
  double Start(std::size_t vertex) const { return this->Starts[vertex]; }
  const std::vector<Place>& Vertices() const { return this->Polyline; }

  /// Returns the side at an arc length and the position on it as a fraction in [0, 1]. At a vertex
  /// it is the side after the vertex.
  std::pair<std::size_t, double> SideAt(double length) const;

  /// Returns the point at an arc length.
  Place At(double length) const;

  /// Returns the unit vector along the side at an arc length.
  Place Tangent(double length) const;

  /// Returns the vertex nearest to an arc length, measured along the polyline.
  std::size_t NearestVertex(double length) const;

protected:
  double Wrap(double length) const;
  const Place& End(std::size_t side) const
  {
    return this->Polyline[(side + 1) % this->Polyline.size()];
  }

  std::vector<Place> Polyline;
  std::vector<double>
    Starts; ///< Arc lengths of the vertices, followed by the length of the polyline.
};

extern template class ClosedPolyline<Point>;
extern template class ClosedPolyline<SpacePoint>;
}
