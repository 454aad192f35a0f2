#include "FaceJoin.h"

#include "Index.h"
#include "JoinLayouts.h"
#include "MeshBoundary.h"
#include "TMeshSplit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the name of the side that a line becomes: its own, `A+B` between two regions, else `features`.
std::string SideOf(const FeatureLine& line, const SurfaceBody& body, const SurfaceNames& names)
{
  if (line.name >= 0)
  {
    return names.lines[Index(line.name)];
  }
  const auto [one, other] =
    std::minmax(body.regionOf[Index(line.faces[0])], body.regionOf[Index(line.faces[1])]);
  return one == other ? "features" : names.regions[Index(one)] + "+" + names.regions[Index(other)];
}
}

LayoutSet JoinFaces(
  const SurfaceBody& body, const SurfaceNames& names, const std::vector<Layout>& layouts)
{
  Layout joined = JoinLayouts(layouts).layout;
  const MeshTopology& topology = *joined.map.topology;
  std::vector<int> first; // vertex of each face
  int vertices = 0;
  for (const Layout& layout : layouts)
  {
    first.push_back(vertices);
    vertices += layout.map.topology->VertexCount();
  }
  const MeshBoundary curves(topology);
  std::vector<CurvePlace> placeOf(Index(vertices));
  for (std::size_t l = 0; l < topology.alignedVertices.size(); ++l)
  {
    const std::vector<int>& loop = topology.alignedVertices[l];
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      placeOf[Index(loop[i])] = { static_cast<int>(l), curves.StartOf(static_cast<int>(l), i) };
    }
  }
  const auto placeIn = [&](int face, int point)
  { return placeOf[Index(first[Index(face)] + point)]; };
  const auto spanOf = [&](int face, int from, int to, bool isClosed)
  {
    const CurvePlace start = placeIn(face, from);
    const double loop = curves.Length(start.loop);
    const double length = placeIn(face, to).at - start.at;
    return SideSpan{ start.loop, start.at,
      isClosed ? loop : length - loop * std::floor(length / loop) };
  };
  std::vector<PairedSides> pairs;
  FaceSides sides;
  for (const FeatureLine& line : body.lines)
  {
    PairedSides pair;
    pair.first = static_cast<int>(2 * pairs.size());
    pair.second = pair.first + 1;
    const std::vector<int>& left = line.points[0];
    const std::vector<int>& right = line.points[1];
    pair.name = "The line between faces at " +
      DescribeInSpace(curves.PlaceAt(placeIn(line.faces[0], left[left.size() / 2])));
    pair.isClosed = line.isClosed;
    pair.isInterface = true;
    // The face on the right has the line on its left in the opposite direction.
    std::array<SideSpan, 2> spans = { spanOf(
                                        line.faces[0], left.front(), left.back(), line.isClosed),
      spanOf(line.faces[1], line.isClosed ? right.front() : right.back(), right.front(),
        line.isClosed) };
    if (body.regionOf[Index(line.faces[0])] > body.regionOf[Index(line.faces[1])])
    {
      std::swap(spans[0], spans[1]);
    }
    pair.spans = spans;
    pairs.push_back(std::move(pair));
    for (std::size_t i = 0; i < left.size(); ++i)
    {
      sides.twins.push_back(
        { first[Index(line.faces[0])] + left[i], first[Index(line.faces[1])] + right[i] });
    }
    sides.ofPairs.push_back(SideOf(line, body, names));
  }
  sides.ofBoundary.resize(topology.mesh.boundary.size());
  for (std::size_t f = 0; f < body.faces.size(); ++f)
  {
    for (const auto& [point, name] : body.boundaryNames[f])
    {
      sides.ofBoundary[Index(curves.PositionAt(placeIn(static_cast<int>(f), point)))] =
        names.lines[Index(name)];
    }
  }
  std::vector<int> nodes;
  for (const FeatureNode& node : body.nodes)
  {
    for (const FacePoint& corner : node.corners)
    {
      nodes.push_back(curves.PositionAt(placeIn(corner.face, corner.point)));
    }
  }
  SplitBoundaryArcs(joined.map, nodes, joined.tMesh);
  LayoutSet set(std::move(joined), std::move(pairs));
  set.sides = std::move(sides);
  return set;
}
}
