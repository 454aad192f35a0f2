#include "SidePairs.h"

#include "ElementNodes.h"
#include "Error.h"
#include "NodeImages.h"

#include <set>

namespace crossfield
{
namespace
{
std::vector<int> PointsOf(const SolverMesh& mesh, const std::vector<CellFace>& faces)
{
  const ElementNodes nodes(mesh, NodeOrder::Vtk);
  std::set<int> points;
  for (const CellFace& face : faces)
  {
    const std::vector<int> ofFace = nodes.OfFace(face);
    points.insert(ofFace.begin(), ofFace.end());
  }
  return { points.begin(), points.end() };
}
}

PairMatch MatchPair(const SolverMesh& mesh, const MeshFaces& faces, const SidePair& pair)
{
  const std::string sides = "The periodic sides '" + mesh.sideNames[pair.first] + "' and '" +
    mesh.sideNames[pair.second] + "' have ";
  const std::vector<int> from = PointsOf(mesh, faces.OfSide(pair.first));
  const std::vector<int> to = PointsOf(mesh, faces.OfSide(pair.second));
  const std::vector<int> found = FindImages(mesh.points, pair.motion, from, to);
  PairMatch match;
  std::set<int> images;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    if (found[i] >= 0)
    {
      match.nodes[from[i]] = found[i];
      images.insert(found[i]);
    }
  }
  if (match.nodes.size() != from.size() || images.size() != to.size())
  {
    throw Error(sides + std::to_string(from.size()) + " and " + std::to_string(to.size()) +
      " nodes, and " + std::to_string(images.size()) +
      " of them match; make the mesh again, or remove the field data PeriodicSides.");
  }
  std::map<MeshFaces::Key, int> second;
  for (const CellFace& face : faces.OfSide(pair.second))
  {
    second.emplace(faces.KeyOf(faces.NumberOf(face)), static_cast<int>(second.size()));
  }
  for (const CellFace& face : faces.OfSide(pair.first))
  {
    MeshFaces::Key key = faces.KeyOf(faces.NumberOf(face));
    for (int& corner : key)
    {
      corner = match.nodes.at(corner);
    }
    const auto image = second.find(MeshFaces::MakeKey(key.data(), key.size()));
    if (image == second.end())
    {
      throw Error(sides + "different faces; make the mesh again.");
    }
    match.faces.push_back(image->second);
  }
  return match;
}
}
