#include "LoopArc.h"

#include "Segment.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
//------------------------------------------------------------------------------
LoopArc::LoopArc(const Loop& loop)
  : Polyline(loop)
  , Starts{ 0.0 }
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    this->Starts.push_back(this->Starts.back() + (loop[(i + 1) % loop.size()] - loop[i]).norm());
  }
}

//------------------------------------------------------------------------------
double LoopArc::Folded(double length) const
{
  return length - std::floor(length / this->Length()) * this->Length();
}

//------------------------------------------------------------------------------
std::size_t LoopArc::SideAt(double folded) const
{
  const auto after = std::upper_bound(this->Starts.begin(), this->Starts.end(), folded);
  return std::min(this->Polyline.size() - 1,
    static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - this->Starts.begin())) - 1);
}

//------------------------------------------------------------------------------
Point LoopArc::At(double length) const
{
  length = this->Folded(length);
  const std::size_t side = this->SideAt(length);
  const double extent = this->Starts[side + 1] - this->Starts[side];
  const double part = extent > 0.0 ? (length - this->Starts[side]) / extent : 0.0;
  const Point& from = this->Polyline[side];
  return from + part * (this->Polyline[(side + 1) % this->Polyline.size()] - from);
}

//------------------------------------------------------------------------------
std::size_t LoopArc::NearestVertex(double length) const
{
  length = this->Folded(length);
  const std::size_t side = this->SideAt(length);
  const bool isLast = length - this->Starts[side] > this->Starts[side + 1] - length;
  return isLast ? (side + 1) % this->Polyline.size() : side;
}

//------------------------------------------------------------------------------
double LoopArc::Find(const Point& place, double reach) const
{
  double found = -1.0;
  for (std::size_t i = 0; i < this->Polyline.size(); ++i)
  {
    const Point& from = this->Polyline[i];
    const Point& to = this->Polyline[(i + 1) % this->Polyline.size()];
    const double part = NearestFraction(place, from, to);
    const double distance = (from + part * (to - from) - place).norm();
    if (distance <= reach)
    {
      reach = distance;
      found =
        std::fmod(this->Starts[i] + part * (this->Starts[i + 1] - this->Starts[i]), this->Length());
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
    const Point& here = this->Polyline[i];
    turns[i] = AngleBetween(
      here - this->Polyline[(i + count - 1) % count], this->Polyline[(i + 1) % count] - here);
  }
  return turns;
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
    largest = std::max(largest, WayFromSegment(arc.Vertices()[i], begin.place, end.place).norm());
  }
  return largest;
}

//------------------------------------------------------------------------------
Loop PlacesOf(const std::vector<ArcVertex>& vertices)
{
  Loop loop;
  for (const ArcVertex& vertex : vertices)
  {
    loop.push_back(vertex.place);
  }
  return loop;
}
}
