#include "SegmentSearch.h"

#include "DomainQueries.h"
#include "Segment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
std::vector<SegmentSearch::Segment> SidesOf(const PlanarDomain& domain)
{
  std::vector<SegmentSearch::Segment> sides;
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      sides.push_back({ loop[i], loop[(i + 1) % loop.size()] });
    }
  }
  return sides;
}
}

SegmentSearch::SegmentSearch(std::vector<Segment> segments)
  : Segments(std::move(segments))
{
  constexpr std::size_t GroupSize = 16;
  for (std::size_t begin = 0; begin < this->Segments.size(); begin += GroupSize)
  {
    Group group{ begin, std::min(begin + GroupSize, this->Segments.size()),
      this->Segments[begin][0], this->Segments[begin][0] };
    for (std::size_t i = begin; i < group.end; ++i)
    {
      for (const Point& point : this->Segments[i])
      {
        group.lower = group.lower.cwiseMin(point);
        group.upper = group.upper.cwiseMax(point);
      }
    }
    this->Groups.push_back(group);
  }
}

SegmentSearch::SegmentSearch(const PlanarDomain& domain)
  : SegmentSearch(SidesOf(domain))
{
}

SegmentSearch::Nearest SegmentSearch::Find(const Point& point) const
{
  const auto toBox = [&point](const Group& group) { return SquaredDistance(point, group); };
  Nearest nearest{ this->Segments.size(), std::numeric_limits<double>::infinity() };
  const auto search = [&](const Group& group)
  {
    for (std::size_t i = group.begin; i < group.end; ++i)
    {
      const double distance =
        OffsetFromSegment(point, this->Segments[i][0], this->Segments[i][1]).squaredNorm();
      if (distance < nearest.squaredDistance ||
        (distance == nearest.squaredDistance && i < nearest.segment))
      {
        nearest = { i, distance };
      }
    }
  };
  const auto first = std::min_element(this->Groups.begin(), this->Groups.end(),
    [&](const Group& a, const Group& b) { return toBox(a) < toBox(b); });
  search(*first);
  // Rounding must not exclude a segment on the side of its box.
  constexpr double Margin = 1.0 - 1e-9;
  for (auto group = this->Groups.begin(); group != this->Groups.end(); ++group)
  {
    if (group != first && Margin * toBox(*group) <= nearest.squaredDistance)
    {
      search(*group);
    }
  }
  return nearest;
}

double SegmentSearch::SignedDistance(const Point& point) const
{
  int winding = 0;
  for (const Group& group : this->Groups)
  {
    if (group.lower.y() <= point.y() && point.y() <= group.upper.y() &&
      group.upper.x() >= point.x())
    {
      for (std::size_t i = group.begin; i < group.end; ++i)
      {
        winding += RayCrossing(point, this->Segments[i][0], this->Segments[i][1]);
      }
    }
  }
  const double distance = std::sqrt(this->Find(point).squaredDistance);
  return winding > 0 ? distance : -distance;
}
}
