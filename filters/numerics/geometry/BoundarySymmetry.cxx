#include "BoundarySymmetry.h"

#include "Segment.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Removes the vertices at which the boundary is straight.
Loop RemoveStraightVertices(const Loop& loop, double reach)
{
  Loop corners;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point& before =
      corners.empty() ? loop[(i + loop.size() - 1) % loop.size()] : corners.back();
    const Point chord = loop[(i + 1) % loop.size()] - before;
    const Point offset = loop[i] - before;
    if (std::abs(Cross(chord, offset)) > reach * chord.norm() || chord.dot(offset) < 0.0)
    {
      corners.push_back(loop[i]);
    }
  }
  return corners;
}

/// Returns the centroid of the area enclosed by a loop.
Point Centroid(const Loop& loop)
{
  Point sum = Point::Zero();
  double area = 0.0;
  const Point& origin = loop.front(); // products of absolute coordinates would lose digits
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point from = loop[i] - origin;
    const Point to = loop[(i + 1) % loop.size()] - origin;
    area += Cross(from, to);
    sum += Cross(from, to) * (from + to);
  }
  return origin + sum / (3.0 * area);
}

/// Returns whether an isometry maps vertices 0, 1, … of `a` to the vertices of `b` that start at
/// `to`, in reverse order if it reflects.
bool MapsVertices(const Loop& a, const Loop& b, const Isometry& map, std::size_t to, double reach)
{
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const std::size_t image = (map.reflects ? to + b.size() - i : to + i) % b.size();
    if ((map(a[i]) - b[image]).norm() > reach)
    {
      return false;
    }
  }
  return true;
}

double DistanceTo(const Loop& loop, const Point& point)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    nearest =
      std::min(nearest, OffsetFromSegment(point, loop[i], loop[(i + 1) % loop.size()]).norm());
  }
  return nearest;
}

class SymmetrySearch
{
public:
  SymmetrySearch(const PlanarDomain& domain, double tolerance)
    : Reach(tolerance * domain.Diagonal())
  {
    for (const Loop& loop : domain.loops)
    {
      this->Loops.push_back(RemoveStraightVertices(loop, this->Reach));
    }
    this->Centre = Centroid(domain.loops[0]);
  }

  /// Returns the isometry that maps the first vertex of the outer loop to another one.
  Isometry MapFirstVertexTo(std::size_t vertex, bool reflects) const
  {
    Point from = this->Loops[0][0] - this->Centre;
    const Point to = this->Loops[0][vertex] - this->Centre;
    if (reflects)
    {
      from.y() = -from.y();
    }
    return { this->Centre, AngleBetween(from, to), reflects };
  }

  bool IsSymmetry(const Isometry& map, std::size_t vertex) const
  {
    const Loop& outer = this->Loops[0];
    if (!MapsVertices(outer, outer, map, vertex, this->Reach))
    {
      return false;
    }
    return std::all_of(this->Loops.begin() + 1, this->Loops.end(),
      [&](const Loop& loop) { return this->HasImage(loop, map); });
  }

  /// Returns whether all loops enclose something at the tolerance.
  bool HasArea() const
  {
    return std::all_of(
      this->Loops.begin(), this->Loops.end(), [](const Loop& loop) { return loop.size() > 2; });
  }

  std::size_t Count() const { return this->Loops[0].size(); }
  const Point& GetCentre() const { return this->Centre; }

private:
  bool HasImage(const Loop& loop, const Isometry& map) const
  {
    const Point first = map(loop[0]);
    return std::any_of(this->Loops.begin() + 1, this->Loops.end(),
      [&](const Loop& other)
      {
        if (other.size() != loop.size())
        {
          return false;
        }
        for (std::size_t i = 0; i < other.size(); ++i)
        {
          if ((first - other[i]).norm() <= this->Reach &&
            MapsVertices(loop, other, map, i, this->Reach))
          {
            return true;
          }
        }
        return false;
      });
  }

  std::vector<Loop> Loops;
  Point Centre;
  double Reach;
};
}

Point Isometry::operator()(const Point& point) const
{
  Point offset = point - this->centre;
  if (this->reflects)
  {
    offset.y() = -offset.y();
  }
  return this->centre + Eigen::Rotation2Dd(this->angle) * offset;
}

Isometry Isometry::Inverse() const
{
  return { this->centre, this->reflects ? this->angle : -this->angle, this->reflects };
}

std::vector<Isometry> SymmetryGroup::Elements() const
{
  std::vector<Isometry> elements;
  for (const bool reflecting : { false, true })
  {
    for (int i = 0; i < this->order && (this->reflects || !reflecting); ++i)
    {
      const double turn = 2.0 * Pi * i / this->order;
      elements.push_back({ this->centre, reflecting ? 2.0 * this->axis + turn : turn, reflecting });
    }
  }
  return elements;
}

std::size_t ImageOfInnerLoop(const PlanarDomain& domain, const Isometry& symmetry, std::size_t loop)
{
  const Point point = symmetry(domain.loops[loop][0]);
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t image = loop;
  for (std::size_t other = 1; other < domain.loops.size(); ++other)
  {
    const double distance = DistanceTo(domain.loops[other], point);
    if (distance < nearest)
    {
      nearest = distance;
      image = other;
    }
  }
  return image;
}

SymmetryGroup FindSymmetries(const PlanarDomain& domain, double tolerance)
{
  const SymmetrySearch symmetries(domain, tolerance);
  SymmetryGroup group;
  group.centre = symmetries.GetCentre();
  if (!symmetries.HasArea())
  {
    return group;
  }
  std::size_t step = symmetries.Count();
  for (std::size_t vertex = 1; vertex < symmetries.Count(); ++vertex)
  {
    // The step of the smallest rotation divides the number of vertices.
    if (symmetries.Count() % vertex == 0 &&
      symmetries.IsSymmetry(symmetries.MapFirstVertexTo(vertex, false), vertex))
    {
      step = vertex;
      group.order = static_cast<int>(symmetries.Count() / vertex);
      break;
    }
  }
  for (std::size_t vertex = 0; vertex < step; ++vertex)
  {
    const Isometry map = symmetries.MapFirstVertexTo(vertex, true);
    if (symmetries.IsSymmetry(map, vertex))
    {
      group.reflects = true;
      const double period = Pi / group.order;
      group.axis = std::fmod(0.5 * map.angle, period);
      group.axis += group.axis < 0.0 ? period : 0.0;
      break;
    }
  }
  return group;
}
}
