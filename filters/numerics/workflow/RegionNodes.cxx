#include "RegionNodes.h"

#include "NodeIndices.h"
#include "PoincareHopf.h"

#include <algorithm>

namespace crossfield
{
std::vector<std::vector<RegionCorner>> FindNodeCorners(
  const RegionSet& set, const std::vector<std::vector<CornerChoice>>& given)
{
  std::vector<std::vector<RegionCorner>> all;
  std::vector<NodeCorners> nodes;
  std::vector<std::vector<CornerChoice>> without = given; // with index 0 at nodes
  for (const RegionNode& node : set.nodes)
  {
    all.emplace_back();
    nodes.push_back({ {}, node.isOnBoundary });
    for (const RegionPoint& point : node.corners)
    {
      const Corner corner =
        MakeCorner(set.regions[point.region].domain.loops, point.loop, point.point);
      const auto isHere = [&corner](const CornerChoice& choice)
      { return choice.position == corner.position; };
      NodeCorner one{ static_cast<int>(point.region), corner.angle, std::nullopt };
      std::vector<CornerChoice>& own = without[point.region];
      const auto found = std::find_if(own.begin(), own.end(), isHere);
      if (found != own.end())
      {
        one.prescribed = found->quarterIndex;
        own.erase(found);
      }
      own.push_back({ corner.position, 0 });
      all.back().push_back({ point.region, corner, 0 });
      nodes.back().corners.push_back(one);
    }
  }
  std::vector<int> required;
  for (std::size_t r = 0; r < set.regions.size(); ++r)
  {
    const std::vector<Loop>& loops = set.regions[r].domain.loops;
    const std::vector<CornerChoice> capped =
      CapCorners(CountQuarters(loops, 0, DefaultCornerAngle, without[r]), without[r]);
    required.push_back(
      CountQuarters(loops, 0, DefaultCornerAngle, capped).requiredInteriorQuarters);
  }
  const std::vector<std::vector<int>> indices = ChooseNodeIndices(nodes, required);
  for (std::size_t n = 0; n < all.size(); ++n)
  {
    for (std::size_t i = 0; i < all[n].size(); ++i)
    {
      all[n][i].quarterIndex = indices[n][i];
    }
  }
  return all;
}

int IndexAt(const RegionNode& node, const std::vector<RegionCorner>& corners)
{
  std::vector<int> indices;
  std::transform(corners.begin(), corners.end(), std::back_inserter(indices),
    [](const RegionCorner& one) { return one.quarterIndex; });
  return IndexOfNode(indices, node.isOnBoundary);
}
}
