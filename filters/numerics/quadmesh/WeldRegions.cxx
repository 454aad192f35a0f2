#include "WeldRegions.h"

#include "Index.h"
#include "UnionFind.h"

#include <algorithm>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
void JoinEqualNames(std::vector<std::string>& names, std::vector<QuadBoundaryEdge>& boundary)
{
  std::vector<std::string> different;
  std::vector<int> number;
  for (const std::string& name : names)
  {
    const auto found = std::find(different.begin(), different.end(), name);
    number.push_back(static_cast<int>(found - different.begin()));
    if (found == different.end())
    {
      different.push_back(name);
    }
  }
  for (QuadBoundaryEdge& edge : boundary)
  {
    edge.side = edge.side < 0 ? -1 : number[Index(edge.side)];
  }
  names = std::move(different);
}
}

std::vector<int> WeldRegions(QuadMesh& mesh)
{
  const std::size_t count = mesh.points.size();
  UnionFind sets(count);
  std::set<int> firstSides;
  std::set<int> secondSides;
  for (const PairedSides& pair : mesh.periodic)
  {
    if (pair.isInterface)
    {
      firstSides.insert(pair.first);
      secondSides.insert(pair.second);
      for (const auto& [first, second] : pair.nodes)
      {
        sets.Join(first, second);
      }
    }
  }
  std::vector<int> numberOfSet(count, -1);
  std::vector<int> number(count);
  std::vector<QuadPoint> points;
  std::vector<bool> isWelded;
  for (std::size_t p = 0; p < count; ++p)
  {
    int& of = numberOfSet[Index(sets.Find(static_cast<int>(p)))];
    if (of < 0)
    {
      of = static_cast<int>(points.size());
      points.push_back(mesh.points[p]);
      isWelded.push_back(false);
    }
    else
    {
      points[Index(of)].valence += mesh.points[p].valence;
      isWelded[Index(of)] = true;
    }
    number[p] = of;
  }
  for (std::array<int, 4>& quad : mesh.quads)
  {
    for (int& point : quad)
    {
      point = number[Index(point)];
    }
  }
  std::vector<QuadBoundaryEdge> boundary;
  std::vector<bool> isOnBoundary(points.size(), false);
  for (QuadBoundaryEdge edge : mesh.boundary)
  {
    if (secondSides.count(edge.side) > 0)
    {
      continue;
    }
    edge.points = { number[Index(edge.points[0])], number[Index(edge.points[1])] };
    if (firstSides.count(edge.side) > 0)
    {
      edge.kind = BoundaryKind::Interface;
    }
    else
    {
      isOnBoundary[Index(edge.points[0])] = isOnBoundary[Index(edge.points[1])] = true;
    }
    boundary.push_back(edge);
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (isWelded[p])
    {
      QuadPoint& point = points[p];
      point.cone = -1;
      point.quarterIndex = (isOnBoundary[p] ? 2 : 4) - point.valence;
      point.curve = isOnBoundary[p] ? point.curve : CurvePlace();
    }
  }
  JoinEqualNames(mesh.sideNames, boundary);
  mesh.points = std::move(points);
  mesh.boundary = std::move(boundary);
  mesh.periodic.erase(std::remove_if(mesh.periodic.begin(), mesh.periodic.end(),
                        [](const PairedSides& pair) { return pair.isInterface; }),
    mesh.periodic.end());
  for (PairedSides& pair : mesh.periodic)
  {
    for (std::array<int, 2>& nodes : pair.nodes)
    {
      nodes = { number[Index(nodes[0])], number[Index(nodes[1])] };
    }
  }
  return number;
}
}
