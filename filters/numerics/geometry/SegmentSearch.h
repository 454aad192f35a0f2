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

  /// Calls function(segment) for all segments that are no farther from a point than a distance, in
  /// their order, and for some that are.
  template <typename Function>
  void ForNear(const Point& point, double distance, const Function& function) const
  {
    // Rounding must not exclude a segment.
    constexpr double Margin = 1.0 - 1e-9;
    for (const Group& group : this->Groups)
    {
      if (Margin * SquaredDistance(point, group) <= distance * distance)
      {
        for (std::size_t i = group.begin; i < group.end; ++i)
        {
          function(i);
        }
      }
    }
  }

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

  /// Returns the squared distance of a point to the box around a group.
  static double SquaredDistance(const Point& point, const Group& group)
  {
    return (point - group.upper).cwiseMax(group.lower - point).cwiseMax(0.0).squaredNorm();
  }

  std::vector<Segment> Segments;
  std::vector<Group> Groups;
};
}
