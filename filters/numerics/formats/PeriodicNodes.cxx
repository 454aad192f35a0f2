#include "PeriodicNodes.h"

#include "CellLattice.h"
#include "Error.h"
#include "Index.h"
#include "NodeImages.h"
#include "SideFaces.h"

#include <set>

namespace crossfield
{
namespace
{
std::vector<int> PointsOf(const ExportMesh& mesh, const std::vector<SideFace>& faces)
{
  const CellLattice lattice(mesh.dimension, mesh.order);
  std::set<int> points;
  for (const SideFace& face : faces)
  {
    for (const int position : lattice.Face(face.face))
    {
      points.insert(mesh.Cell(face.cell)[position]);
    }
  }
  return { points.begin(), points.end() };
}
}

std::vector<std::array<int, 2>> PeriodicNodes(const ExportMesh& mesh, const PeriodicPair& pair)
{
  const SideFaces faces = FindSideFaces(mesh);
  const std::vector<int> from = PointsOf(mesh, faces.ofSide[Index(pair.first)]);
  const std::vector<int> to = PointsOf(mesh, faces.ofSide[Index(pair.second)]);
  const std::vector<int> found = FindImages(mesh.points, pair.motion, from, to);
  std::vector<std::array<int, 2>> nodes;
  std::set<int> images;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    if (found[i] >= 0)
    {
      nodes.push_back({ from[i], found[i] });
      images.insert(found[i]);
    }
  }
  if (nodes.size() != from.size() || images.size() != to.size())
  {
    throw Error("The periodic sides '" + mesh.sideNames[Index(pair.first)] + "' and '" +
      mesh.sideNames[Index(pair.second)] + "' have " + std::to_string(from.size()) + " and " +
      std::to_string(to.size()) + " nodes, and " + std::to_string(images.size()) +
      " of them match; make the mesh again, or remove the field data PeriodicSides.");
  }
  return nodes;
}
}
