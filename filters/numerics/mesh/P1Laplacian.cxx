#include "P1Laplacian.h"

#include "Error.h"
#include "Parts.h"
#include "SymmetricAssembly.h"
#include "TriangleArea.h"

#include <algorithm>
#include <string>

namespace crossfield
{
namespace
{
double PositiveArea(const TriangleMesh& mesh, std::size_t t)
{
  const double area = TriangleArea(mesh, mesh.triangles[t]);
  if (!(area > 0.0))
  {
    throw Error("Triangle " + std::to_string(t) +
      " has no area or is clockwise; remesh the domain with the drill filter.");
  }
  return area;
}

/// Returns the entry of a triangle's element matrix for two of its vertices.
double OffDiagonal(const TriangleMesh& mesh, std::size_t t, const std::array<int, 2>& vertices)
{
  const auto& triangle = mesh.triangles[t];
  const auto third = *std::find_if(triangle.begin(), triangle.end(),
    [&vertices](int vertex) { return vertex != vertices[0] && vertex != vertices[1]; });
  const Point& corner = mesh.points[third];
  return -(mesh.points[vertices[0]] - corner).dot(mesh.points[vertices[1]] - corner) /
    (4.0 * PositiveArea(mesh, t));
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

Eigen::SparseMatrix<double> P1Stiffness(const TriangleMesh& mesh, const EdgeNumbering& edges)
{
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
            sum += OffDiagonal(mesh, static_cast<std::size_t>(t), edges.vertices[e]);
          }
        }
        ofEdge[e] = { edges.vertices[e][0], edges.vertices[e][1], sum };
      }
    });
  return AssembleZeroRowSums(static_cast<Eigen::Index>(mesh.points.size()), ofEdge);
}
}
