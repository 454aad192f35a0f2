#include "TMeshPatches.h"

#include "Error.h"
#include "TMeshArcs.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Returns the half-edges that start at every node, sorted by slot.
std::vector<std::vector<int>> Stars(const TMesh& mesh)
{
  std::vector<std::vector<int>> stars(mesh.nodes.size());
  for (int h = 0; h < static_cast<int>(mesh.halfEdges.size()); ++h)
  {
    stars[mesh.halfEdges[h].node].push_back(h);
  }
  for (std::vector<int>& star : stars)
  {
    std::sort(star.begin(), star.end(),
      [&mesh](int a, int b) { return mesh.halfEdges[a].slot < mesh.halfEdges[b].slot; });
  }
  return stars;
}

bool AtBoundary(const TNode& node)
{
  return node.kind == NodeKind::Corner || node.kind == NodeKind::OnBoundary;
}

/// Links every half-edge to the next one around its patch, and returns the angles between them in
/// quarter turns; 0 outside the domain.
std::vector<int> LinkHalfEdges(TMesh& mesh)
{
  const std::vector<std::vector<int>> stars = Stars(mesh);
  std::vector<int> angles(mesh.halfEdges.size(), 0);
  for (int h = 0; h < static_cast<int>(mesh.halfEdges.size()); ++h)
  {
    const int back = TMesh::Twin(h);
    const int at = mesh.halfEdges[back].node;
    const std::vector<int>& star = stars[at];
    const auto here = std::find(star.begin(), star.end(), back);
    const int slot = mesh.halfEdges[back].slot;
    if (here != star.begin())
    {
      mesh.halfEdges[h].next = *(here - 1);
      angles[h] = slot - mesh.halfEdges[*(here - 1)].slot;
    }
    else if (!AtBoundary(mesh.nodes[at]))
    {
      mesh.halfEdges[h].next = star.back();
      angles[h] = slot - mesh.halfEdges[star.back()].slot + mesh.nodes[at].quarters;
    }
  }
  return angles;
}

[[noreturn]] void ThrowNoRectangles(const SpacePoint& location)
{
  throw Error(
    "The separatrices do not divide the domain into rectangles near " + DescribePlace(location),
    "use a finer mesh", Error::Kind::CoarseMesh);
}

/// Follows the links around every patch and collects its sides.
void CollectPatches(TMesh& mesh)
{
  const std::vector<int> angles = LinkHalfEdges(mesh);
  for (int first = 0; first < static_cast<int>(mesh.halfEdges.size()); ++first)
  {
    if (mesh.halfEdges[first].patch >= 0 || mesh.halfEdges[first].next < 0)
    {
      continue;
    }
    const SpacePoint& location = mesh.nodes[mesh.halfEdges[first].node].place;
    const auto number = static_cast<int>(mesh.patches.size());
    // The half-edges around the patch, then rotated to start after the first right angle.
    std::vector<int> around;
    int h = first;
    do
    {
      if (h < 0 || mesh.halfEdges[h].patch >= 0)
      {
        ThrowNoRectangles(location);
      }
      mesh.halfEdges[h].patch = number;
      around.push_back(h);
      h = mesh.halfEdges[h].next;
    } while (h != first);
    const auto corner =
      std::find_if(around.begin(), around.end(), [&angles](int edge) { return angles[edge] == 1; });
    if (corner == around.end())
    {
      ThrowNoRectangles(location);
    }
    std::rotate(around.begin(), corner + 1, around.end());
    TPatch patch;
    std::size_t side = 0;
    for (const int edge : around)
    {
      if (side > 3 || angles[edge] < 1 || angles[edge] > 2)
      {
        ThrowNoRectangles(location);
      }
      patch.sides[side].push_back(edge);
      side += angles[edge] == 1 ? 1U : 0U;
    }
    if (side != 4)
    {
      ThrowNoRectangles(location);
    }
    mesh.patches.push_back(std::move(patch));
  }
}
}

TMesh MakeTMesh(const SeamlessMap& map, const TraceGraph& graph)
{
  TMesh mesh = BuildArcs(map, graph);
  CollectPatches(mesh);
  const auto count = [](std::size_t size) { return static_cast<int>(size); };
  const int euler = map.topology->edges.EulerCharacteristic(map.topology->mesh);
  if (count(mesh.nodes.size()) - count(mesh.arcs.size()) + count(mesh.patches.size()) != euler)
  {
    ThrowNoRectangles(mesh.nodes.empty() ? SpacePoint::Zero() : mesh.nodes.front().place);
  }
  return mesh;
}
}
