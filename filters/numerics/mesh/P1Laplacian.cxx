#include "P1Laplacian.h"

#include "Error.h"
#include "Parts.h"
#include "SymmetricAssembly.h"
#include "TriangleArea.h"

#include <string>

namespace crossfield
{
namespace
{
double PositiveArea(const MeshTopology& topology, int t)
{
  const double area = topology.AreaOf(t);
  if (!(area > 0.0))
  {
    throw Error("Triangle " + std::to_string(t) +
      " has no area or is clockwise; remesh the domain with the drill filter.");
  }
  return area;
}

/// Returns the entry of a triangle's element matrix for the ends of an edge.
double OffDiagonal(const MeshTopology& topology, int t, int edge)
{
  const int side = topology.SideOf(t, edge);
  const Point& corner = topology.At(t, (side + 2) % 3);
  return -(topology.At(t, side) - corner).dot(topology.At(t, (side + 1) % 3) - corner) /
    (4.0 * PositiveArea(topology, t));
}
}

Eigen::Matrix3d P1ElementStiffness(const std::array<Point, 3>& corners)
{
  const double area = TriangleArea(corners[0], corners[1], corners[2]);
  if (!(area > 0.0))
  {
    throw Error("A triangle near " + Describe(corners[0]) +
      " has no area or is clockwise; remesh the domain with the drill filter.");
  }
  Eigen::Matrix<double, 2, 3> opposite;
  opposite << corners[2] - corners[1], corners[0] - corners[2], corners[1] - corners[0];
  return opposite.transpose() * opposite / (4.0 * area);
}

Eigen::SparseMatrix<double> P1Stiffness(const MeshTopology& topology)
{
  const EdgeNumbering& edges = topology.edges;
  const int edgeCount = edges.Count();
  std::vector<SymmetricEntry> ofEdge(static_cast<std::size_t>(edgeCount));
  // Off-diagonal entries: each edge sums over its one or two triangles.
  ForRanges(edgeCount,
    [&](int begin, int end)
    {
      for (auto e = static_cast<std::size_t>(begin); e < static_cast<std::size_t>(end); ++e)
      {
        double sum = 0.0;
        for (const int t : edges.triangles[e])
        {
          if (t >= 0)
          {
            sum += OffDiagonal(topology, t, static_cast<int>(e));
          }
        }
        ofEdge[e] = { edges.vertices[e][0], edges.vertices[e][1], sum };
      }
    });
  return AssembleZeroRowSums(topology.VertexCount(), ofEdge);
}
}
