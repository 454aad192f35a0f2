#include "FaceJoin.h"

#include "Index.h"
#include "JoinLayouts.h"
#include "MeshBoundary.h"
#include "TMeshSplit.h"

#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
LayoutSet JoinFaces(const SurfaceBody& body, const std::vector<Layout>& layouts)
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
  for (const FeatureLine& line : body.lines)
  {
    PairedSides pair;
    pair.first = static_cast<int>(2 * pairs.size());
    pair.second = pair.first + 1;
    const std::vector<int>& left = line.points[0];
    const std::vector<int>& right = line.points[1];
    pair.name = "The sharp edge at " +
      DescribeInSpace(curves.PlaceAt(placeIn(line.faces[0], left[left.size() / 2])));
    pair.isClosed = line.isClosed;
    pair.isInterface = true;
    // The face on the right has the line on its left in the opposite direction.
    pair.spans = { spanOf(line.faces[0], left.front(), left.back(), line.isClosed),
      spanOf(line.faces[1], line.isClosed ? right.front() : right.back(), right.front(),
        line.isClosed) };
    pairs.push_back(std::move(pair));
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
  return LayoutSet(std::move(joined), std::move(pairs));
}
}
