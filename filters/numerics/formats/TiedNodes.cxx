#include "TiedNodes.h"

#include "SidePairs.h"

#include <deque>
#include <map>
#include <set>

namespace crossfield
{
std::vector<TiedNode> TieNodes(const SolverMesh& mesh, const MeshFaces& faces)
{
  std::map<int, std::vector<TiedNode>> images; // of each point
  for (const SidePair& pair : mesh.pairs)
  {
    const Eigen::Matrix3d rotation = pair.motion.topLeftCorner<3, 3>();
    for (const auto& [first, second] : MatchPair(mesh, faces, pair).nodes)
    {
      images[first].push_back({ second, first, rotation });
      images[second].push_back({ first, second, rotation.transpose() });
    }
  }
  std::vector<TiedNode> ties;
  std::set<int> visited;
  for (const auto& [start, unused] : images)
  {
    std::deque<TiedNode> next;
    if (visited.insert(start).second)
    {
      next.push_back({ start, start, Eigen::Matrix3d::Identity() });
    }
    for (; !next.empty(); next.pop_front())
    {
      const TiedNode here = next.front();
      if (here.node != start)
      {
        ties.push_back(here);
      }
      for (const TiedNode& image : images[here.node])
      {
        if (image.node == here.node && here.node == start && !image.rotation.isIdentity())
        {
          if (ties.empty() || ties.back().node != start) // not for the way back
          {
            ties.push_back({ start, start, image.rotation });
          }
        }
        else if (visited.insert(image.node).second)
        {
          next.push_back({ image.node, start, image.rotation * here.rotation });
        }
      }
    }
  }
  return ties;
}
}
