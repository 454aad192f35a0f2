#include "TiedNodes.h"

#include "SidePairs.h"

#include <deque>
#include <map>
#include <set>

namespace crossfield
{
std::vector<TiedNode> TieNodes(const SolverMesh& mesh, const MeshFaces& faces)
{
  std::map<int, std::vector<TiedNode>> images; // of each point, but for itself
  std::map<int, Eigen::Matrix3d> axes;         // rotations that do not move a point
  for (const SidePair& pair : mesh.pairs)
  {
    const Eigen::Matrix3d rotation = pair.motion.topLeftCorner<3, 3>();
    for (const auto& [first, second] : MatchPair(mesh, faces, pair).nodes)
    {
      if (first == second)
      {
        axes.emplace(first, rotation);
        images[first];
        continue;
      }
      images[first].push_back({ second, first, rotation });
      images[second].push_back({ first, second, rotation.transpose() });
    }
  }
  std::vector<TiedNode> ties;
  std::set<int> visited;
  for (const auto& [start, unused] : images)
  {
    if (!visited.insert(start).second)
    {
      continue;
    }
    const auto axis = axes.find(start);
    if (axis != axes.end())
    {
      ties.push_back({ start, start, axis->second });
    }
    std::deque<TiedNode> next = { { start, start, Eigen::Matrix3d::Identity() } };
    for (; !next.empty(); next.pop_front())
    {
      const TiedNode here = next.front();
      if (here.node != start)
      {
        ties.push_back(here);
      }
      for (const TiedNode& image : images[here.node])
      {
        if (visited.insert(image.node).second)
        {
          next.push_back({ image.node, start, image.rotation * here.rotation });
        }
      }
    }
  }
  return ties;
}
}
