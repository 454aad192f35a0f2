#include "WeldRegions.h"

#include "Index.h"
#include "UnionFind.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
void JoinEqualNames(std::vector<std::string>& names, std::vector<QuadBoundaryEdge>& boundary,
  std::vector<PairedSides>& pairs)
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
  for (PairedSides& pair : pairs)
  {
    pair.first = number[Index(pair.first)];
    pair.second = number[Index(pair.second)];
  }
  names = std::move(different);
}

/// Sorts boundary edges so that they follow each other around the loops of the whole, with the kinds and
/// numbers of these: in the plane outer loops by decreasing area, then inner ones, and those around open lines, from left
/// to right; on a surface the longest loop, the outer one, first. Edges of interfaces come last, in their order.
void NumberLoops(
  const std::vector<QuadPoint>& points, bool isPlanar, std::vector<QuadBoundaryEdge>& boundary)
{
  struct Chain
  {
    std::vector<QuadBoundaryEdge> edges;
    double area = 0.0;
    double length = 0.0;
    Point leftmost = Point::Zero();

    /// An open line has an area of rounding errors.
    bool IsOuter() const { return this->area > 1e-12 * this->length * this->length; }
  };
  std::multimap<int, std::size_t> startingAt; // several where loops touch
  std::vector<QuadBoundaryEdge> interfaces;
  for (std::size_t e = 0; e < boundary.size(); ++e)
  {
    if (boundary[e].kind == BoundaryKind::Interface)
    {
      interfaces.push_back(boundary[e]);
    }
    else
    {
      startingAt.emplace(boundary[e].points[0], e);
    }
  }
  std::vector<Chain> chains;
  const auto isBefore = [](const Point& a, const Point& b)
  { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); };
  while (!startingAt.empty())
  {
    Chain chain;
    for (auto next = startingAt.begin(); next != startingAt.end();)
    {
      const QuadBoundaryEdge& edge = boundary[next->second];
      const Point from = points[Index(edge.points[0])].InPlane();
      const Point to = points[Index(edge.points[1])].InPlane();
      chain.area += 0.5 * Cross(from, to);
      chain.length +=
        (points[Index(edge.points[1])].place - points[Index(edge.points[0])].place).norm();
      chain.leftmost =
        chain.edges.empty() || isBefore(from, chain.leftmost) ? from : chain.leftmost;
      chain.edges.push_back(edge);
      startingAt.erase(next);
      next = startingAt.find(edge.points[1]);
    }
    chains.push_back(std::move(chain));
  }
  std::stable_sort(chains.begin(), chains.end(),
    [&](const Chain& a, const Chain& b)
    {
      if (!isPlanar)
      {
        return a.length > b.length;
      }
      const bool bothAreInner = !a.IsOuter() && !b.IsOuter();
      return bothAreInner            ? isBefore(a.leftmost, b.leftmost)
        : a.IsOuter() != b.IsOuter() ? a.IsOuter()
                                     : a.area > b.area;
    });
  boundary.clear();
  for (std::size_t c = 0; c < chains.size(); ++c)
  {
    for (QuadBoundaryEdge edge : chains[c].edges)
    {
      const bool isOuter = isPlanar ? chains[c].IsOuter() : c == 0;
      edge.kind = isOuter ? BoundaryKind::Outer : BoundaryKind::Inner;
      edge.id = static_cast<int>(c);
      boundary.push_back(edge);
    }
  }
  boundary.insert(boundary.end(), interfaces.begin(), interfaces.end());
}
}

void WeldRegions(QuadMesh& mesh)
{
  const std::size_t count = mesh.points.size();
  UnionFind sets(count);
  std::set<int> firstSides;
  std::set<int> secondSides;
  std::vector<PairedSides> periodic;
  for (const PairedSides& pair : mesh.periodic)
  {
    if (!pair.isInterface)
    {
      periodic.push_back(pair);
      continue;
    }
    if (pair.isOpen)
    {
      continue;
    }
    firstSides.insert(pair.first);
    secondSides.insert(pair.second);
    for (const auto& [first, second] : pair.nodes)
    {
      sets.Join(first, second);
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
      edge.id = -1;
    }
    else
    {
      isOnBoundary[Index(edge.points[0])] = isOnBoundary[Index(edge.points[1])] = true;
    }
    boundary.push_back(edge);
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    QuadPoint& point = points[p];
    const bool isEnd = !isOnBoundary[p] && point.curve.loop >= 0; // of a line inside of a region
    if (isWelded[p] || isEnd)
    {
      point.cone = -1;
      point.quarterIndex = (isOnBoundary[p] ? 2 : 4) - point.valence;
      point.curve = isOnBoundary[p] ? point.curve : CurvePlace();
    }
  }
  for (PairedSides& pair : periodic)
  {
    for (std::array<int, 2>& nodes : pair.nodes)
    {
      nodes = { number[Index(nodes[0])], number[Index(nodes[1])] };
    }
  }
  JoinEqualNames(mesh.sideNames, boundary, periodic);
  NumberLoops(points, mesh.normals.empty(), boundary);
  for (const QuadBoundaryEdge& edge : boundary)
  {
    if (edge.kind != BoundaryKind::Interface)
    {
      points[Index(edge.points[0])].curve.loop = edge.id;
    }
  }
  mesh.points = std::move(points);
  mesh.boundary = std::move(boundary);
  mesh.periodic = std::move(periodic);
}
}
