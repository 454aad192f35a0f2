#include "PairedArcs.h"

#include "SideArcs.h"
#include "TMeshSplit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crossfield
{
namespace
{
/// The places where the parts of two paired sides begin and end.
class PartEnds
{
public:
  PartEnds(const MeshBoundary& curves, const BoundarySides& sides, const PairedSides& pair)
    : Curves(curves)
    , Pair(pair)
    , First(FindSpan(sides, curves.GetArcs(), pair.first))
    , Second(FindSpan(sides, curves.GetArcs(), pair.second))
  {
    this->OnFirst = { 0.0, this->First.length };
    this->OnSecond = { 0.0, this->Second.length };
    const RigidMotion back = pair.motion.Inverse();
    for (const CurvePlace& corner : curves.Corners())
    {
      const Point place = curves.At(corner);
      if (this->IsInside(this->First, corner))
      {
        this->Add(place, pair.motion(place));
      }
      if (this->IsInside(this->Second, corner))
      {
        this->Add(back(place), place);
      }
    }
    std::sort(this->OnFirst.begin(), this->OnFirst.end());
    std::sort(this->OnSecond.begin(), this->OnSecond.end());
  }

  /// Returns the entries of mesh.boundary that start at the ends of parts.
  std::vector<int> Positions() const
  {
    std::vector<int> positions;
    for (const bool isFirst : { true, false })
    {
      const SideSpan& span = isFirst ? this->First : this->Second;
      const LoopArc& arc = this->Curves.GetArcs()[span.loop];
      for (const double offset : isFirst ? this->OnFirst : this->OnSecond)
      {
        const std::size_t vertex = arc.NearestVertex(span.start + offset);
        positions.push_back(this->Curves.PositionAt({ span.loop, arc.Start(vertex) }));
      }
    }
    return positions;
  }

  std::size_t Count() const { return this->OnFirst.size() - 1; }
  /// Returns the part of the first side that a place is on.
  std::size_t PartOnFirst(const CurvePlace& place) const
  {
    return PartAt(this->OnFirst, this->OffsetOf(this->First, place));
  }
  /// Returns the part of the first side whose image a place is on.
  std::size_t PartOnSecond(const CurvePlace& place) const
  {
    return this->Count() - 1 - PartAt(this->OnSecond, this->OffsetOf(this->Second, place));
  }

private:
  double OffsetOf(const SideSpan& span, const CurvePlace& place) const
  {
    const double loop = this->Curves.Length(span.loop);
    const double offset = place.at - span.start;
    return offset - loop * std::floor(offset / loop);
  }

  bool IsInside(const SideSpan& span, const CurvePlace& place) const
  {
    const double offset = this->OffsetOf(span, place);
    const double rounding = PairReach * this->Curves.Length(span.loop);
    return place.loop == span.loop && offset > rounding && offset < span.length - rounding;
  }

  /// Adds a corner and its image, unless they are there.
  void Add(const Point& place, const Point& image)
  {
    const double onFirst =
      this->OffsetOf(this->First, this->Curves.NearestOn(this->Pair, 0, this->First.loop, place));
    const double rounding = 10.0 * PairReach * this->Curves.Length(this->First.loop);
    if (std::none_of(this->OnFirst.begin(), this->OnFirst.end(),
          [&](double other) { return std::abs(other - onFirst) <= rounding; }))
    {
      this->OnFirst.push_back(onFirst);
      this->OnSecond.push_back(this->OffsetOf(
        this->Second, this->Curves.NearestOn(this->Pair, 1, this->Second.loop, image)));
    }
  }

  static std::size_t PartAt(const std::vector<double>& ends, double offset)
  {
    const auto after = std::upper_bound(ends.begin() + 1, ends.end() - 1, offset);
    return static_cast<std::size_t>(after - ends.begin()) - 1;
  }

  const MeshBoundary& Curves;
  const PairedSides& Pair;
  const SideSpan First;
  const SideSpan Second;
  std::vector<double> OnFirst; ///< Arc lengths from the start of the side.
  std::vector<double> OnSecond;
};
}

void SplitAtPairs(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
  const std::vector<PairedSides>& pairs, TMesh& mesh)
{
  for (const PairedSides& pair : pairs)
  {
    if (!pair.isClosed)
    {
      SplitBoundaryArcs(map, PartEnds(curves, sides, pair).Positions(), mesh);
    }
  }
}

std::vector<CountSum> PairSums(const SeamlessMap& map, const MeshBoundary& curves,
  const BoundarySides& sides, const std::vector<PairedSides>& pairs, const TMesh& mesh)
{
  std::vector<CountSum> sums;
  if (pairs.empty())
  {
    return sums;
  }
  const SideArcs arcs(map, curves, sides, mesh);
  for (const PairedSides& pair : pairs)
  {
    std::optional<PartEnds> ends; // none: one part
    if (!pair.isClosed)
    {
      ends.emplace(curves, sides, pair);
    }
    std::vector<CountSum> ofPair(ends ? ends->Count() : 1);
    for (const int arc : arcs.Of(pair.first))
    {
      ofPair[ends ? ends->PartOnFirst(arcs.MiddleOf(arc)) : 0].terms.emplace_back(arc, 1);
    }
    for (const int arc : arcs.Of(pair.second))
    {
      ofPair[ends ? ends->PartOnSecond(arcs.MiddleOf(arc)) : 0].terms.emplace_back(arc, -1);
    }
    for (CountSum& sum : ofPair)
    {
      sum.name = pair.name;
      sums.push_back(std::move(sum));
    }
  }
  return sums;
}
}
