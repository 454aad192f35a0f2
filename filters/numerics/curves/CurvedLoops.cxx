#include "CurvedLoops.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
SegmentParameters ParametersOf(const CurveEvaluator& curve, const Point& from, const Point& to)
{
  const double middle = curve.Nearest(0.5 * (from + to));
  const auto find = [&](const Point& end)
  {
    // A curve may touch itself, so the same part of it comes first.
    const double here = curve.NearestFrom(end, middle);
    const double anywhere = curve.Unwrap(curve.Nearest(end), middle);
    const double farther = (curve.At(here) - end).norm() - (curve.At(anywhere) - end).norm();
    return farther <= CurveReach * (to - from).norm() ? curve.Unwrap(here, middle) : anywhere;
  };
  return { find(from), find(to) };
}

CurvedLoops::CurvedLoops(const CurvedBoundary& boundary, const std::vector<LoopArc>& loops)
{
  if (boundary.IsEmpty())
  {
    return;
  }
  for (const PlaneCurve& curve : boundary.curves)
  {
    this->Evaluators.emplace_back(curve);
  }
  const CurvesAlong along(boundary, loops);
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    const Loop& vertices = loops[l].Vertices();
    std::vector<Segment> segments(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      segments[i].curve = along.At(l, 0.5 * (loops[l].Start(i) + loops[l].Start(i + 1)));
      if (segments[i].curve >= 0)
      {
        segments[i].parameters = ParametersOf(
          this->Evaluators[segments[i].curve], vertices[i], vertices[(i + 1) % vertices.size()]);
      }
    }
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      segments[i].startsCurve =
        segments[i].curve != segments[(i + segments.size() - 1) % segments.size()].curve;
    }
    this->Segments.push_back(std::move(segments));
  }
}

int CurvedLoops::CurveAt(const LoopArc& arc, std::size_t loop, double at) const
{
  return this->IsEmpty() ? -1 : this->Segments[loop][arc.SideAt(at).first].curve;
}

Point CurvedLoops::At(const LoopArc& arc, std::size_t loop, double at) const
{
  if (this->IsEmpty())
  {
    return arc.At(at);
  }
  const auto [side, fraction] = arc.SideAt(at);
  const Segment& segment = this->Segments[loop][side];
  if (segment.curve < 0 || (fraction == 0.0 && segment.startsCurve))
  {
    return arc.At(at);
  }
  const SegmentParameters& ends = segment.parameters;
  return this->Evaluators[segment.curve].At(ends.from + fraction * (ends.to - ends.from));
}

Point CurvedLoops::Derivative(const LoopArc& arc, std::size_t loop, double at) const
{
  if (this->IsEmpty())
  {
    return arc.Tangent(at);
  }
  const auto [side, fraction] = arc.SideAt(at);
  const Segment& segment = this->Segments[loop][side];
  if (segment.curve < 0)
  {
    return arc.Tangent(at);
  }
  const SegmentParameters& ends = segment.parameters;
  const CurveFrame frame =
    this->Evaluators[segment.curve].FrameAt(ends.from + fraction * (ends.to - ends.from));
  return (ends.to - ends.from) / (arc.Start(side + 1) - arc.Start(side)) * frame.first;
}

double CurvedLoops::Nearest(const LoopArc& arc, std::size_t loop, const Point& place) const
{
  const double nearest = arc.Nearest(place);
  if (this->IsEmpty())
  {
    return nearest;
  }
  const std::vector<Segment>& segments = this->Segments[loop];
  auto [side, fraction] = arc.SideAt(nearest);
  double last = 0.0; // the direction in which the segment before was left
  for (;;)
  {
    const Segment& segment = segments[side];
    const double extent = segment.parameters.to - segment.parameters.from;
    if (segment.curve < 0 || extent == 0.0)
    {
      return arc.Start(side) + fraction * (arc.Start(side + 1) - arc.Start(side));
    }
    const double from = segment.parameters.from;
    const double parameter =
      this->Evaluators[segment.curve].NearestFrom(place, from + fraction * extent);
    const double found = (parameter - from) / extent;
    const std::size_t next =
      found < 0.0 ? (side + segments.size() - 1) % segments.size() : (side + 1) % segments.size();
    const bool continues = found < 0.0 ? !segment.startsCurve : !segments[next].startsCurve;
    const double direction = found < 0.0 ? -1.0 : 1.0;
    if ((found >= 0.0 && found <= 1.0) || !continues || direction == -last)
    {
      return arc.Start(side) +
        std::clamp(found, 0.0, 1.0) * (arc.Start(side + 1) - arc.Start(side));
    }
    fraction = found < 0.0 ? 1.0 : 0.0;
    side = next;
    last = direction;
  }
}
}
