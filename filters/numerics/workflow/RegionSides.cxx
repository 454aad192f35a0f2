#include "RegionSides.h"

#include "Index.h"

#include <array>
#include <map>
#include <set>

namespace crossfield
{
namespace
{
using Ends = std::array<double, 4>;

Ends EndsOf(const Point& from, const Point& to)
{
  return { from.x(), from.y(), to.x(), to.y() };
}

/// Returns the pieces of a region's segments, in their direction along the region.
std::map<Ends, std::size_t> PieceOfSegments(const RegionSet& set, std::size_t region)
{
  std::map<Ends, std::size_t> pieces;
  for (std::size_t p = 0; p < set.interfaces.size(); ++p)
  {
    const InterfacePiece& piece = set.interfaces[p];
    const std::size_t count = piece.line.size();
    for (std::size_t i = piece.isClosed ? 0 : 1; i < count; ++i)
    {
      const Point& from = piece.line[(i + count - 1) % count];
      const Point& to = piece.line[i];
      if (Index(piece.regions[0]) == region)
      {
        pieces[EndsOf(from, to)] = p;
      }
      if (Index(piece.regions[1]) == region)
      {
        pieces[EndsOf(to, from)] = p;
      }
    }
  }
  return pieces;
}
}

void UseGivenNames(const std::vector<SegmentNames>& ofRegions, RegionSet& set)
{
  std::vector<std::set<std::string>> given(set.interfaces.size());
  for (std::size_t r = 0; r < set.regions.size(); ++r)
  {
    const std::map<Ends, std::size_t> pieces = PieceOfSegments(set, r);
    const std::vector<Loop>& loops = set.regions[r].domain.loops;
    for (std::size_t l = 0; l < loops.size() && !ofRegions[r].empty(); ++l)
    {
      for (std::size_t i = 0; i < loops[l].size(); ++i)
      {
        const auto found = pieces.find(EndsOf(loops[l][i], loops[l][(i + 1) % loops[l].size()]));
        if (found != pieces.end())
        {
          given[found->second].insert(ofRegions[r][l][i]);
        }
      }
    }
  }
  std::map<std::string, int> counts;
  for (std::size_t p = 0; p < given.size(); ++p)
  {
    if (given[p].size() == 1 && !given[p].begin()->empty())
    {
      set.interfaces[p].side = *given[p].begin();
    }
    ++counts[set.interfaces[p].side];
  }
  std::map<std::string, int> numbers;
  for (InterfacePiece& piece : set.interfaces)
  {
    piece.name = piece.side;
    if (counts[piece.side] > 1)
    {
      const int number = ++numbers[piece.side];
      piece.name += "." + std::to_string(number);
    }
  }
}

BoundarySides SidesOfRegion(const RegionSet& set, std::size_t region, SegmentNames names,
  const std::vector<std::string>& taken)
{
  const std::map<Ends, std::size_t> pieces = PieceOfSegments(set, region);
  const PlanarDomain& domain = set.regions[region].domain;
  names.resize(domain.loops.size());
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    const Loop& loop = domain.loops[l];
    names[l].resize(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const auto found = pieces.find(EndsOf(loop[i], loop[(i + 1) % loop.size()]));
      if (found != pieces.end())
      {
        names[l][i] = set.interfaces[found->second].name;
      }
    }
  }
  return NameSides(domain, names, taken);
}
}
