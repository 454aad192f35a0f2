#include "LineWalk.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
double LineWalk::Across(const LineSegment& segment, int corner) const
{
  return this->Map.At(segment.triangle, corner)[segment.AlongU() ? 1 : 0];
}

double LineWalk::Along(const LineSegment& segment, int corner) const
{
  return this->Map.At(segment.triangle, corner)[segment.AlongU() ? 0 : 1];
}

bool LineWalk::IsLeft(const LineSegment& segment, int corner) const
{
  const double across = this->Across(segment, corner);
  // Left of +u is +v, left of +v is −u.
  const bool leftIsGreater = segment.direction == 0 || segment.direction == 3;
  return leftIsGreater ? across >= segment.level : across <= segment.level;
}

void LineWalk::Leave(LineSegment& segment, int side) const
{
  const int next = (side + 1) % 3;
  const double from = this->Across(segment, side);
  const double to = this->Across(segment, next);
  const double across =
    from == to ? 0.5 : std::clamp((segment.level - from) / (to - from), 0.0, 1.0);
  // Rounded so that the fraction from the other end of the side is exact, as lines that leave at
  // the same point of a side must have the same order in both of its triangles.
  const double fraction = 1.0 - (1.0 - across);
  segment.exit = { side, fraction };
  const double start = this->Along(segment, side);
  const double along = start + fraction * (this->Along(segment, next) - start);
  segment.exitLength = std::max(segment.entryLength, segment.LengthAt(along));
}

LineSegment LineWalk::Start(const Departure& departure) const
{
  LineSegment segment;
  segment.triangle = departure.triangle;
  segment.direction = departure.direction;
  segment.level = this->Across(segment, departure.corner);
  segment.offset = -segment.Sign() * this->Along(segment, departure.corner);
  segment.entry = { departure.corner, 0.0 };
  this->Leave(segment, (departure.corner + 1) % 3);
  return segment;
}

LineSegment LineWalk::StartFromSide(int boundaryPosition) const
{
  const auto [triangle, side] = this->Map.topology->SideOfBoundary(boundaryPosition);
  LineSegment segment;
  segment.triangle = triangle;
  segment.direction = (this->Map.directions[boundaryPosition] + 1) % 4;
  const Point middle =
    0.5 * (this->Map.At(segment.triangle, side) + this->Map.At(segment.triangle, (side + 1) % 3));
  segment.level = middle[segment.AlongU() ? 1 : 0];
  segment.offset = -segment.Sign() * middle[segment.AlongU() ? 0 : 1];
  segment.entry = { side, 0.5 };
  this->Leave(segment, this->IsLeft(segment, (side + 2) % 3) ? (side + 1) % 3 : (side + 2) % 3);
  return segment;
}

LineSegment LineWalk::StartInside(int triangle, const Point& w, int direction) const
{
  LineSegment segment;
  segment.triangle = triangle;
  segment.direction = direction;
  segment.level = w[segment.AlongU() ? 1 : 0];
  segment.offset = -segment.Sign() * w[segment.AlongU() ? 0 : 1];
  segment.startsInside = true;
  // The exit side has a corner on the right, then one on the left.
  for (int side = 0; side < 3; ++side)
  {
    if (!this->IsLeft(segment, side) && this->IsLeft(segment, (side + 1) % 3))
    {
      this->Leave(segment, side);
      return segment;
    }
  }
  // The point is a corner, and the triangle is beside the line: leave at the farthest corner.
  int furthest = 0;
  for (int corner = 1; corner < 3; ++corner)
  {
    furthest = segment.Sign() * this->Along(segment, corner) >
        segment.Sign() * this->Along(segment, furthest)
      ? corner
      : furthest;
  }
  this->Leave(segment, furthest);
  return segment;
}

int LineWalk::Beyond(const LineSegment& segment) const
{
  return this->Map.topology->Neighbour(segment.triangle, segment.exit.side);
}

void LineWalk::Pass(const LineSegment& segment, int side, LineSegment& next) const
{
  next.triangle = this->Map.topology->Neighbour(segment.triangle, side);
  next.direction = segment.direction;
  next.level = segment.level;
  next.offset = segment.offset;
  if (this->Map.seams[segment.triangle][side] != 0)
  {
    const SeamTransition across = this->Map.Across(segment.triangle, side);
    next.direction = (segment.direction + across.rotation) % 4;
    const Point w =
      across(segment.AlongU() ? Point(0.0, segment.level) : Point(segment.level, 0.0));
    next.level = w[next.AlongU() ? 1 : 0];
    next.offset = segment.offset - next.Sign() * w[next.AlongU() ? 0 : 1];
  }
}

LineSegment LineWalk::Continue(const LineSegment& segment) const
{
  const MeshTopology& topology = *this->Map.topology;
  LineSegment next;
  this->Pass(segment, segment.exit.side, next);
  const int side =
    topology.SideOf(next.triangle, topology.EdgeOf(segment.triangle, segment.exit.side));
  next.entryLength = segment.exitLength;
  next.entry = { side, 1.0 - segment.exit.fraction };
  // A line enters with the start of the side on its left, and leaves between a right and a left
  // corner.
  this->Leave(next, this->IsLeft(next, (side + 2) % 3) ? (side + 1) % 3 : (side + 2) % 3);
  return next;
}

std::optional<LineSegment> LineWalk::Beside(const LineSegment& segment, double tolerance) const
{
  const auto isOn = [&](int corner)
  { return std::abs(this->Across(segment, corner) - segment.level) <= tolerance; };
  for (int side = 0; side < 3; ++side)
  {
    if (isOn(side) && isOn((side + 1) % 3) &&
      this->Map.topology->Neighbour(segment.triangle, side) >= 0)
    {
      LineSegment beside;
      this->Pass(segment, side, beside);
      return beside;
    }
  }
  return std::nullopt;
}

SpacePoint LineWalk::PlaceAt(int triangle, const OutlinePoint& point) const
{
  const auto& v = this->Map.topology->mesh.triangles[triangle];
  const SpacePoint from = this->Map.topology->PositionOf(v[point.side]);
  const SpacePoint to = this->Map.topology->PositionOf(v[(point.side + 1) % 3]);
  return from + point.fraction * (to - from);
}

SpacePoint LineWalk::PlaceAt(const LineSegment& segment, double length) const
{
  return this->Map.PlaceOf(segment.triangle, segment.At(length));
}
}
