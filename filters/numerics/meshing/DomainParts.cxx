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
    const SegmentSearch enclosed(PlanarDomain{ { loops[outer] } });
    for (std::size_t inner = 0; inner < loops.size(); ++inner)
    {
      if (depths[inner] == depths[outer] + 1 && enclosed.SignedDistance(loops[inner].front()) > 0.0)
      {
        ofPart.push_back(loops[inner]);
      }
    }
    parts.push_back(MakePlanarDomain(std::move(ofPart)));
  }
  const auto isBefore = [](const PlanarDomain& a, const PlanarDomain& b)
  {
    const Point& first = a.loops[0][0];
    const Point& second = b.loops[0][0];
    return std::make_tuple(-a.Area(), first.x(), first.y()) <
      std::make_tuple(-b.Area(), second.x(), second.y());
  };
  std::sort(parts.begin(), parts.end(), isBefore);
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
