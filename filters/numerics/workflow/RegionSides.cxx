#include "RegionSides.h"

#include "Index.h"

#include <map>
#include <set>

namespace crossfield
{
void UseGivenNames(const std::vector<SegmentNames>& ofRegions, RegionSet& set)
{
  std::vector<std::set<std::string>> given(set.interfaces.size());
  for (std::size_t r = 0; r < set.regions.size(); ++r)
  {
    const std::vector<std::vector<int>>& pieces = set.regions[r].pieces;
    for (std::size_t l = 0; l < pieces.size() && !ofRegions[r].empty(); ++l)
    {
      for (std::size_t i = 0; i < pieces[l].size(); ++i)
      {
        if (pieces[l][i] >= 0)
        {
          given[Index(pieces[l][i] / 2)].insert(ofRegions[r][l][i]);
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
  const Region& one = set.regions[region];
  names.resize(one.pieces.size());
  for (std::size_t l = 0; l < one.pieces.size(); ++l)
  {
    names[l].resize(one.pieces[l].size());
    for (std::size_t i = 0; i < one.pieces[l].size(); ++i)
    {
      const int piece = one.pieces[l][i];
      if (piece >= 0)
      {
        names[l][i] = set.interfaces[Index(piece / 2)].NameOn(Index(piece % 2));
      }
    }
  }
  return NameSides(one.domain, names, taken);
}
}
