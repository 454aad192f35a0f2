#include "RegionSides.h"

#include "Index.h"
#include "MakeRegionSet.h"

#include <set>

namespace crossfield
{
std::string DescribeRegion(const RegionSet& set, std::size_t region)
{
  const Region& one = set.regions[region];
  const std::string what = set.materials.size() > 1
    ? "Material '" + set.materials[Index(one.material)] + "'"
    : std::string("The region");
  return what + " near " + Describe(one.domain.loops[0][0]);
}

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
  for (std::size_t p = 0; p < given.size(); ++p)
  {
    if (given[p].size() == 1 && !given[p].begin()->empty())
    {
      set.interfaces[p].side = *given[p].begin();
    }
  }
  NumberInterfaces(set);
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
        names[l][i] = set.interfaces[Index(piece / 2)].NameIn(Index(piece % 2));
      }
    }
  }
  return NameSides(one.domain, names, taken);
}
}
