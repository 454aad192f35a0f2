#include "CurveSampling.h"

#include "BoundaryCorners.h"
#include "CurvedLoops.h"
#include "Error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// A sixth of the corner angle, as boundaries are thinned to.
constexpr double LargestTurn = DefaultCornerAngle / 6.0;
/// Below the corner angle by enough for unequal parts.
constexpr double LargestTurnOfShort = DefaultCornerAngle / 2.0;
/// Vertices this close to their curve, relative to the diagonal, keep their coordinates.
constexpr double OnCurve = 1e-13;

/// Returns length and turning of a curve between two parameters, by chords of sixteen parts.
std::pair<double, double> MeasurePiece(const CurveEvaluator& curve, const SegmentParameters& ends)
{
  constexpr int Parts = 16;
  double length = 0.0;
  double turn = 0.0;
  CurveFrame last = curve.FrameAt(ends.from);
  for (int i = 1; i <= Parts; ++i)
  {
    const CurveFrame next = curve.FrameAt(ends.from + (ends.to - ends.from) * i / Parts);
    length += (next.place - last.place).norm();
    turn += std::abs(AngleBetween(last.first, next.first));
    last = next;
  }
  return { length, turn };
}

int CountParts(
  const CurveEvaluator& curve, const SegmentParameters& ends, const SamplingLimits& limits)
{
  const auto [length, turn] = MeasurePiece(curve, ends);
  // Equal lengths must not be divided differently because of rounding.
  const auto parts = [](double ratio) { return std::max(1.0, std::ceil(ratio - 1e-6)); };
  const double byTurn = std::min(parts(turn / LargestTurn), parts(length / limits.shortest));
  return static_cast<int>(
    std::max({ parts(length / limits.longest), byTurn, parts(turn / LargestTurnOfShort) }));
}

class Sampler
{
public:
  Sampler(const PlanarDomain& domain, const CurvesOfSegments& curves, const SamplingLimits& limits)
    : Domain(domain)
    , Curves(curves)
    , Limits(limits)
    , Extent(domain.Diagonal())
    , Arcs(domain.loops.begin(), domain.loops.end())
  {
    for (const PlaneCurve& curve : curves.curves)
    {
      this->Evaluators.emplace_back(curve);
    }
    for (std::size_t l = 0; l < domain.loops.size(); ++l)
    {
      this->Ends.emplace_back(domain.loops[l].size());
      this->Extra.emplace_back(domain.loops[l].size());
      for (std::size_t i = 0; i < domain.loops[l].size(); ++i)
      {
        if (this->CurveOf(l, i) >= 0)
        {
          this->Ends[l][i] =
            ParametersOf(this->EvaluatorOf(l, i), this->Vertex(l, i), this->Vertex(l, i + 1));
        }
      }
      this->RequireOrder(l);
    }
  }

  /// Returns the new position of a point on the boundary, and makes it a vertex.
  Point Keep(const Point& point)
  {
    const double reach = BoundaryReach * this->Extent;
    for (std::size_t l = 0; l < this->Arcs.size(); ++l)
    {
      const double at = this->Arcs[l].Find(point, reach);
      if (at < 0.0)
      {
        continue;
      }
      const auto [segment, fraction] = this->Arcs[l].SideAt(at);
      const std::size_t nearest = fraction > 0.5 ? segment + 1 : segment;
      if ((this->Vertex(l, nearest) - point).norm() <= reach)
      {
        return this->NewVertex(l, nearest % this->Domain.loops[l].size());
      }
      if (this->CurveOf(l, segment) < 0)
      {
        return point;
      }
      this->Extra[l][segment].push_back(fraction);
      const SegmentParameters& ends = this->Ends[l][segment];
      return this->EvaluatorOf(l, segment).At(ends.from + fraction * (ends.to - ends.from));
    }
    return point;
  }

  SampledDomain Sample(const BoundarySides& sides)
  {
    SampledDomain result;
    result.sides = sides;
    for (SideStart& start : result.sides.starts)
    {
      start.place = this->Keep(start.place);
    }
    CurvesOfSegments sampled{ this->Curves.curves, {} };
    for (std::size_t l = 0; l < this->Domain.loops.size(); ++l)
    {
      Loop loop;
      std::vector<int> of;
      for (std::size_t i = 0; i < this->Domain.loops[l].size(); ++i)
      {
        loop.push_back(this->NewVertex(l, i));
        of.push_back(this->CurveOf(l, i));
        for (const Point& point : this->Inside(l, i))
        {
          loop.push_back(point);
          of.push_back(this->CurveOf(l, i));
        }
      }
      result.domain.loops.push_back(std::move(loop));
      sampled.ofSegment.push_back(std::move(of));
    }
    result.boundary = PiecesOf(result.domain, sampled);
    return result;
  }

private:
  int CurveOf(std::size_t l, std::size_t segment) const
  {
    return this->Curves.ofSegment.empty() ? -1 : this->Curves.ofSegment[l][segment];
  }

  const CurveEvaluator& EvaluatorOf(std::size_t l, std::size_t segment) const
  {
    return this->Evaluators[this->CurveOf(l, segment)];
  }

  const Point& Vertex(std::size_t l, std::size_t i) const
  {
    return this->Domain.loops[l][i % this->Domain.loops[l].size()];
  }

  /// Throws Error if segments of a curve lead back along it.
  void RequireOrder(std::size_t l) const
  {
    const std::size_t count = this->Domain.loops[l].size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t before = (i + count - 1) % count;
      const int curve = this->CurveOf(l, i);
      if (curve < 0)
      {
        continue;
      }
      const double forwards = this->Ends[l][i].to - this->Ends[l][i].from;
      const double previous = this->Ends[l][before].to - this->Ends[l][before].from;
      if (forwards == 0.0 || (this->CurveOf(l, before) == curve && forwards * previous < 0.0))
      {
        throw Error("The points of the boundary near " + Describe(this->Vertex(l, i)) +
          " are not in order along their curve; give more points there, or leave out the curve.");
      }
    }
  }

  Point NewVertex(std::size_t l, std::size_t i) const
  {
    const Point& vertex = this->Vertex(l, i);
    const std::size_t count = this->Domain.loops[l].size();
    if (this->CurveOf(l, i) < 0 || this->CurveOf(l, (i + count - 1) % count) != this->CurveOf(l, i))
    {
      return vertex;
    }
    const Point place = this->EvaluatorOf(l, i).At(this->Ends[l][i].from);
    return (place - vertex).norm() > OnCurve * this->Extent ? place : vertex;
  }

  /// Returns the new vertices inside a segment.
  std::vector<Point> Inside(std::size_t l, std::size_t i) const
  {
    if (this->CurveOf(l, i) < 0)
    {
      return {};
    }
    const CurveEvaluator& curve = this->EvaluatorOf(l, i);
    const SegmentParameters& ends = this->Ends[l][i];
    std::vector<double> fractions = this->Extra[l][i];
    fractions.push_back(0.0);
    fractions.push_back(1.0);
    std::sort(fractions.begin(), fractions.end());
    std::vector<Point> inside;
    for (std::size_t k = 1; k < fractions.size(); ++k)
    {
      const auto at = [&](double fraction) { return ends.from + fraction * (ends.to - ends.from); };
      const SegmentParameters part = { at(fractions[k - 1]), at(fractions[k]) };
      const int parts = part.from == part.to ? 0 : CountParts(curve, part, this->Limits);
      for (int j = 1; j <= parts; ++j)
      {
        if (j < parts || k + 1 < fractions.size())
        {
          inside.push_back(curve.At(part.from + (part.to - part.from) * j / parts));
        }
      }
    }
    return inside;
  }

  const PlanarDomain& Domain;
  const CurvesOfSegments& Curves;
  const SamplingLimits& Limits;
  const double Extent; ///< Diagonal of the domain.
  const std::vector<LoopArc> Arcs;
  std::vector<CurveEvaluator> Evaluators;
  std::vector<std::vector<SegmentParameters>> Ends;    ///< Per loop and segment.
  std::vector<std::vector<std::vector<double>>> Extra; ///< Fractions of new vertices.
};
}

SampledDomain SampleCurves(const PlanarDomain& domain, const BoundarySides& sides,
  const CurvesOfSegments& curves, const SamplingLimits& limits, const std::vector<Point>& kept)
{
  Sampler sampler(domain, curves, limits);
  std::vector<Point> places;
  for (const Point& point : kept)
  {
    places.push_back(sampler.Keep(point));
  }
  SampledDomain result = sampler.Sample(sides);
  result.kept = std::move(places);
  return result;
}
}
