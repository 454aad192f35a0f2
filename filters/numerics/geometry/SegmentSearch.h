#pragma once

#include "PlanarDomain.h"

#include <array>
#include <cstddef>
#include <vector>

namespace crossfield
{
/// Finds the nearest of many segments. Boxes around groups of successive segments are compared
/// first, so that most segments of a boundary need not be.
class SegmentSearch
{
public:
  using Segment = std::array<Point, 2>;

  explicit SegmentSearch(std::vector<Segment> segments);
  /// Constructs the search among the sides of a domain.
  explicit SegmentSearch(const PlanarDomain& domain);

  const Segment& At(std::size_t segment) const { return this->Segments[segment]; }

  struct Nearest
  {
    std::size_t segment = 0; ///< The first one if several are equally near.
    double squaredDistance = 0.0;
  };
  /// Returns the nearest segment. There must be one.
  Nearest Find(const Point& point) const;

  /// Returns the distance of a point to the segments, negative where they do not wind around it:
  /// SignedDistance of a domain whose sides they are.
  double SignedDistance(const Point& point) const;

private:
  struct Group
  {
    std::size_t begin;
    std::size_t end;
    Point lower;
    Point upper;
  };

  std::vector<Segment> Segments;
  std::vector<Group> Groups;
};
}
