#include "DomainParts.h"

#include "Error.h"
#include "MakePlanarDomain.h"
#include "PlanarMesher.h"
#include "SegmentSearch.h"

#include <algorithm>
#include <charconv>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the coordinates of the leftmost point, the lowest if there are several.
std::tuple<double, double> LeftmostOf(const Loop& loop)
{
  std::tuple<double, double> least(loop[0].x(), loop[0].y());
  for (const Point& point : loop)
  {
    least = std::min(least, std::make_tuple(point.x(), point.y()));
  }
  return least;
}

/// Sorts parts by area, the largest first, and those of the same area from left to right. Areas
/// that differ by less than simplifying a boundary changes them count as the same, so that a part
/// keeps its number.
void SortBySize(std::vector<PlanarDomain>& parts)
{
  constexpr double Difference = 1e-3;
  std::sort(parts.begin(), parts.end(),
    [](const PlanarDomain& a, const PlanarDomain& b) { return a.Area() > b.Area(); });
  const auto isLeft = [](const PlanarDomain& a, const PlanarDomain& b)
  { return LeftmostOf(a.loops[0]) < LeftmostOf(b.loops[0]); };
  for (auto begin = parts.begin(); begin != parts.end();)
  {
    const double least = (1.0 - Difference) * begin->Area();
    const auto end = std::find_if(
      begin, parts.end(), [&](const PlanarDomain& part) { return part.Area() < least; });
    std::sort(begin, end, isLeft);
    begin = end;
  }
}
}

std::vector<PlanarDomain> SplitParts(const std::vector<Loop>& loops)
{
  RequireLoops(loops);
  const std::vector<int> depths = NestingDepths(loops);
  std::vector<PlanarDomain> parts;
  for (std::size_t outer = 0; outer < loops.size(); ++outer)
  {
    if (depths[outer] % 2 != 0)
    {
      continue;
    }
    std::vector<Loop> ofPart = { loops[outer] };
    if (SignedArea(ofPart[0]) < 0.0)
    {
      std::reverse(ofPart[0].begin(), ofPart[0].end());
    }
    const SegmentSearch enclosed(PlanarDomain{ ofPart });
    for (std::size_t inner = 0; inner < loops.size(); ++inner)
    {
      if (depths[inner] == depths[outer] + 1 && enclosed.SignedDistance(loops[inner].front()) > 0.0)
      {
        ofPart.push_back(loops[inner]);
      }
    }
    parts.push_back(MakePlanarDomain(std::move(ofPart)));
  }
  SortBySize(parts);
  return parts;
}

int PartOf(const std::string& text, std::size_t parts)
{
  if (text == "largest")
  {
    return 0;
  }
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
  {
    return -1;
  }
  if (number < 1 || number > static_cast<int>(parts))
  {
    throw Error("There is no part " + text + "; the domain has " + std::to_string(parts) +
      (parts == 1 ? " part." : " parts, the largest is number 1."));
  }
  return number - 1;
}
}
