#include "CurveSymmetry.h"

#include "HolePattern.h"
#include "SegmentSearch.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crossfield
{
namespace
{
/// Relative to the diagonal. Less than is seen: a ninth of the side of 1,500 quads in a square.
constexpr double CurveReach = 2e-3;

/// The circles and the other loops of a domain, and its isometries about one centre.
class CurveSet
{
public:
  CurveSet(const PlanarDomain& domain, const Point& centre)
    : Centre(centre)
    , Reach(CurveReach * domain.Diagonal())
  {
    std::vector<SegmentSearch::Segment> sides;
    for (const Loop& loop : domain.loops)
    {
      if (const std::optional<Circle> circle = CircleOf(loop))
      {
        this->Circles.push_back(*circle);
        continue;
      }
      this->Vertices.insert(this->Vertices.end(), loop.begin(), loop.end());
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        sides.push_back({ loop[i], loop[(i + 1) % loop.size()] });
        // A narrow notch up to the centre has images of its vertices without being there.
        this->Middles.push_back(0.5 * (sides.back()[0] + sides.back()[1]));
      }
    }
    if (!sides.empty())
    {
      this->Sides.emplace(std::move(sides));
    }
  }

  bool IsSymmetry(const Isometry& map) const
  {
    const auto hasImage = [&](const Circle& circle)
    {
      const Point image = map(circle.centre);
      return std::any_of(this->Circles.begin(), this->Circles.end(),
        [&](const Circle& other)
        {
          return (other.centre - image).norm() <= this->Reach &&
            std::abs(other.radius - circle.radius) <= this->Reach;
        });
    };
    const Isometry inverse = map.Inverse();
    const auto isNear = [&](const Point& point)
    { return this->Sides->Find(point).squaredDistance <= this->Reach * this->Reach; };
    const auto haveImages = [&](const std::vector<Point>& points)
    {
      return std::all_of(points.begin(), points.end(),
        [&](const Point& point) { return isNear(map(point)) && isNear(inverse(point)); });
    };
    return std::all_of(this->Circles.begin(), this->Circles.end(), hasImage) &&
      haveImages(this->Vertices) && haveImages(this->Middles);
  }

  /// Returns whether all rotations of a cyclic group are symmetries: a small one moves little, several of it more.
  bool HasRotations(int order) const
  {
    for (int turns = 1; 2 * turns <= order; ++turns) // the others are their inverses
    {
      if (!this->IsSymmetry({ this->Centre, 2.0 * Pi * turns / order, false }))
      {
        return false;
      }
    }
    return true;
  }

  /// Returns the angles from the centre at which an image of one feature may be: those of the
  /// circles that are not concentric, or else those of the vertices of other loops.
  std::vector<double> Directions() const
  {
    std::vector<double> directions;
    const auto add = [&](const Point& place)
    {
      const Point offset = place - this->Centre;
      if (offset.norm() > this->Reach)
      {
        directions.push_back(std::atan2(offset.y(), offset.x()));
      }
    };
    for (const Circle& circle : this->Circles)
    {
      add(circle.centre);
    }
    if (directions.empty())
    {
      std::for_each(this->Vertices.begin(), this->Vertices.end(), add);
    }
    return directions;
  }

private:
  std::vector<Circle> Circles;
  std::vector<Point> Vertices; ///< Of the other loops.
  std::vector<Point> Middles;  ///< Of their sides.
  std::optional<SegmentSearch> Sides;
  Point Centre;
  double Reach;
};
}

SymmetryGroup FindCurveSymmetries(const PlanarDomain& domain)
{
  SymmetryGroup group = FindSymmetries(domain);
  const CurveSet curves(domain, group.centre);
  const std::vector<double> directions = curves.Directions();
  constexpr int MostRotations = 24;
  if (directions.empty() || group.order > MostRotations)
  {
    return group;
  }
  for (int order = MostRotations; order > group.order; --order)
  {
    if (order % group.order == 0 && curves.HasRotations(order))
    {
      group.order = order;
      break;
    }
  }
  const double period = Pi / group.order;
  for (std::size_t i = 0; i < directions.size() && !group.reflects; ++i)
  {
    const double twice = directions.front() + directions[i];
    if (curves.IsSymmetry({ group.centre, twice, true }))
    {
      group.reflects = true;
      group.axis = 0.5 * twice;
    }
  }
  group.axis = std::fmod(group.axis, period);
  group.axis += group.axis < 0.0 ? period : 0.0;
  return group;
}
}
