#include "SharpTips.h"

#include "BoundaryCorners.h"
#include "CurvedLoops.h"
#include "OptimizerReport.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// Corners below this angle, 45°, are cut off. They are the very sharp ones: the quarter index with
/// the smallest rotation is 2, and a quad in them is far from a square.
constexpr double SharpTip = Pi / 4.0;

/// Cuts corners of the loops of a domain.
class TipCutter
{
public:
  TipCutter(const PlanarDomain& domain, const QuadRequest& request, double length)
    : Result{ domain, request, {} }
    , Length(length)
    , Reach(BoundaryReach * domain.Diagonal())
  {
    if (this->Result.request.sides.names.empty())
    {
      this->Result.request.sides = NameSides(domain);
    }
  }

  std::optional<CutDomain> Run()
  {
    const std::vector<Corner> corners = FindCorners(this->Result.domain.loops);
    for (const Corner& corner : corners)
    {
      if (corner.angle < SharpTip && !this->IsPrescribed(corner.position))
      {
        this->Cut(static_cast<std::size_t>(corner.loop), corner.position);
      }
    }
    return this->Result.warning.empty() ? std::nullopt
                                        : std::optional<CutDomain>(std::move(this->Result));
  }

private:
  bool IsPrescribed(const Point& place) const
  {
    const std::vector<CornerChoice>& choices = this->Result.request.corners;
    return std::any_of(choices.begin(), choices.end(),
      [&](const CornerChoice& choice) { return (choice.position - place).norm() <= this->Reach; });
  }

  int CurveOf(std::size_t loop, std::size_t segment) const
  {
    const SegmentCurves& curves = this->Result.request.givenCurves.ofSegment;
    return curves.empty() ? -1 : curves[loop][segment];
  }

  /// Returns the point at an arc length, on the curve of its segment if this has one.
  Point PlaceAt(std::size_t l, const LoopArc& arc, double at) const
  {
    const auto [segment, fraction] = arc.SideAt(at);
    const int curve = this->CurveOf(l, segment);
    if (curve < 0)
    {
      return arc.At(at);
    }
    const CurveEvaluator evaluator(this->Result.request.givenCurves.curves[curve]);
    const SegmentParameters ends =
      ParametersOf(evaluator, arc.At(arc.Start(segment)), arc.At(arc.Start(segment + 1)));
    return evaluator.At(ends.from + fraction * (ends.to - ends.from));
  }

  /// Replaces the boundary near a tip by an edge.
  void Cut(std::size_t l, const Point& tip)
  {
    const Loop loop = this->Result.domain.loops[l];
    const auto vertex = std::find(loop.begin(), loop.end(), tip);
    const LoopArc arc(loop);
    // At least half of the loop remains; another cut may have removed the tip.
    if (vertex == loop.end() || 4.0 * this->Length > arc.Length())
    {
      return;
    }
    const double at = arc.Start(static_cast<std::size_t>(vertex - loop.begin()));
    const std::size_t last = arc.SideAt(at - this->Length).first;
    const std::size_t first = arc.SideAt(at + this->Length).first;
    const Point before = this->PlaceAt(l, arc, at - this->Length);
    const Point after = this->PlaceAt(l, arc, at + this->Length);
    this->Describe(tip, (before - after).norm());
    Loop shorter;
    std::vector<int> curves;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const double along = std::abs(arc.Start(i) - at);
      if (std::min(along, arc.Length() - along) > this->Length + this->Reach)
      {
        shorter.push_back(loop[i]);
        curves.push_back(this->CurveOf(l, i));
      }
      else
      {
        this->MoveSides(loop[i], after);
      }
      if (i == last)
      {
        shorter.push_back(before);
        curves.push_back(-1);
        shorter.push_back(after);
        curves.push_back(this->CurveOf(l, first));
      }
    }
    if (!this->Result.request.givenCurves.ofSegment.empty())
    {
      this->Result.request.givenCurves.ofSegment[l] = std::move(curves);
    }
    this->Result.domain.loops[l] = std::move(shorter);
  }

  /// Moves the starts of sides at a place.
  void MoveSides(const Point& from, const Point& to)
  {
    for (SideStart& start : this->Result.request.sides.starts)
    {
      start.place = (start.place - from).norm() <= this->Reach ? to : start.place;
    }
  }

  void Describe(const Point& tip, double width)
  {
    std::ostringstream text;
    text << "The sharp corner at " << crossfield::Describe(tip) << " was cut off "
         << FormatShort(this->Length) << " before its tip, where the domain is "
         << FormatShort(width) << " wide, because there were no valid quads in it.";
    this->Result.warning += (this->Result.warning.empty() ? "" : " ") + text.str();
  }

  CutDomain Result;
  const double Length;
  const double Reach;
};
}

std::optional<CutDomain> CutSharpTips(
  const PlanarDomain& domain, const QuadRequest& request, double length)
{
  return TipCutter(domain, request, length).Run();
}
}
