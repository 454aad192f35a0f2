#include "SharpTips.h"

#include "BoundaryCorners.h"
#include "OptimizerReport.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// Corners below this angle, 15°, are cut off: the triangles in them are so thin that the map may fold over.
constexpr double SharpTip = Pi / 12.0;
/// Largest length that is cut off, relative to the diagonal: less than one of a thousand quads.
constexpr double LargestCut = 0.02;

/// Cuts corners of the loops of a domain.
class TipCutter
{
public:
  TipCutter(const PlanarDomain& domain, const QuadRequest& request, int vertices)
    : Result{ domain, request, {} }
    , Vertices(static_cast<std::size_t>(vertices))
    , Reach(BoundaryReach * domain.Diagonal())
    , Longest(LargestCut * domain.Diagonal())
  {
    if (this->Result.request.sides.names.empty())
    {
      this->Result.request.sides = NameSides(domain);
    }
  }

  std::optional<CutDomain> Run()
  {
    std::vector<Corner> corners = FindCorners(this->Result.domain.loops);
    std::reverse(corners.begin(), corners.end()); // numbers of the vertices before stay valid
    for (const Corner& corner : corners)
    {
      if (corner.angle < SharpTip && !this->IsPrescribed(corner.position))
      {
        this->Cut(static_cast<std::size_t>(corner.loop), static_cast<std::size_t>(corner.vertex));
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

  /// Replaces the vertices within `Vertices` of a corner by an edge.
  void Cut(std::size_t l, std::size_t tip)
  {
    const Loop& loop = this->Result.domain.loops[l];
    const std::size_t count = loop.size();
    if (count < 2 * this->Vertices + 4)
    {
      return;
    }
    const std::size_t before = (tip + count - this->Vertices) % count;
    const std::size_t after = (tip + this->Vertices) % count;
    const double length =
      std::max((loop[before] - loop[tip]).norm(), (loop[after] - loop[tip]).norm());
    if (length > this->Longest)
    {
      return;
    }
    this->Describe(loop[tip], length, (loop[before] - loop[after]).norm());
    std::set<std::size_t> removed;
    for (std::size_t i = (before + 1) % count; i != after; i = (i + 1) % count)
    {
      removed.insert(i);
    }
    for (SideStart& start : this->Result.request.sides.starts)
    {
      for (const std::size_t i : removed)
      {
        start.place = (start.place - loop[i]).norm() <= this->Reach ? loop[after] : start.place;
      }
    }
    SegmentCurves& curves = this->Result.request.givenCurves.ofSegment;
    Loop shorter;
    std::vector<int> curvesOfShorter;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (removed.count(i) == 0)
      {
        shorter.push_back(loop[i]);
        curvesOfShorter.push_back(i == before || curves.empty() ? -1 : curves[l][i]);
      }
    }
    if (!curves.empty())
    {
      curves[l] = std::move(curvesOfShorter);
    }
    this->Result.domain.loops[l] = std::move(shorter);
  }

  void Describe(const Point& tip, double length, double width)
  {
    std::ostringstream text;
    text << "The sharp corner at " << crossfield::Describe(tip) << " was cut off "
         << FormatShort(length) << " before its tip, where the domain is " << FormatShort(width)
         << " wide, because there were no valid quads in it.";
    this->Result.warning += (this->Result.warning.empty() ? "" : " ") + text.str();
  }

  CutDomain Result;
  const std::size_t Vertices;
  const double Reach;
  const double Longest;
};
}

std::optional<CutDomain> CutSharpTips(
  const PlanarDomain& domain, const QuadRequest& request, int vertices)
{
  return TipCutter(domain, request, vertices).Run();
}
}
