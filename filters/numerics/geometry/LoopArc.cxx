#include "LoopArc.h"

#include "BoundaryCorners.h"
#include "LoopTurning.h"
#include "Segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
//------------------------------------------------------------------------------
double LoopArc::Nearest(const Point& place) const
{
  // rounding error of a distance between points of the domain
  const double rounding = 1e-13 * this->Length();
  const std::size_t count = this->Polyline.size();
  double nearest = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t side = 0; side < count; ++side)
  {
    const Point& from = this->Polyline[side];
    const Point& to = this->End(side);
    const double distance = OffsetFromSegment(place, from, to).norm();
    const bool isNext = side == best + 1 || (best == 0 && side + 1 == count);
    if (std::abs(distance - smallest) <= rounding && isNext)
    {
      nearest = side == best + 1 ? this->Starts[side] : 0.0;
    }
    else if (distance < smallest)
    {
      smallest = distance;
      best = side;
      nearest = this->Starts[side] +
        NearestFraction(place, from, to) * (this->Starts[side + 1] - this->Starts[side]);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
double LoopArc::NearestOnPart(const Point& place, double start, double length) const
{
  double nearest = start;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t side = 0; side < this->Polyline.size(); ++side)
  {
    const double from = this->Starts[side];
    const double to = this->Starts[side + 1];
    const double distance = OffsetFromSegment(place, this->Polyline[side], this->End(side)).norm();
    if (distance < smallest && this->Wrap(0.5 * (from + to) - start) < length)
    {
      smallest = distance;
      nearest = from + NearestFraction(place, this->Polyline[side], this->End(side)) * (to - from);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
double LoopArc::Find(const Point& place, double reach) const
{
  const double nearest = this->Nearest(place);
  return (this->At(nearest) - place).norm() <= reach ? nearest : -1.0;
}

//------------------------------------------------------------------------------
std::vector<double> LoopArc::FindAll(const std::vector<Point>& places, double reach) const
{
  std::vector<double> found;
  for (const Point& place : places)
  {
    const double at = this->Find(place, reach);
    if (at >= 0.0)
    {
      found.push_back(at);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
std::vector<double> LoopArc::Turns() const
{
  const std::size_t count = this->Polyline.size();
  std::vector<double> turns(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    turns[i] = TurningAt(this->Polyline, i);
  }
  return turns;
}

//------------------------------------------------------------------------------
std::vector<double> LoopArc::Corners(double cornerAngle) const
{
  const std::vector<double> turns = this->Turns();
  std::vector<double> corners;
  for (std::size_t i = 0; i < turns.size(); ++i)
  {
    if (IsCorner(turns[i], cornerAngle))
    {
      corners.push_back(this->Starts[i]);
    }
  }
  return corners;
}

//------------------------------------------------------------------------------
double LargestDistance(const LoopArc& arc, const std::vector<ArcVertex>& vertices)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < arc.Vertices().size(); ++i)
  {
    const auto after = std::upper_bound(vertices.begin(), vertices.end(), arc.Start(i),
      [](double at, const ArcVertex& vertex) { return at < vertex.at; });
    const ArcVertex& end = after == vertices.end() ? vertices.front() : *after;
    const ArcVertex& begin = after == vertices.begin() ? vertices.back() : *(after - 1);
    largest =
      std::max(largest, OffsetFromSegment(arc.Vertices()[i], begin.place, end.place).norm());
  }
  return largest;
}

//------------------------------------------------------------------------------
Loop PositionsOf(const std::vector<ArcVertex>& vertices)
{
  Loop loop;
  for (const ArcVertex& vertex : vertices)
  {
    loop.push_back(vertex.place);
  }
  return loop;
}
}
