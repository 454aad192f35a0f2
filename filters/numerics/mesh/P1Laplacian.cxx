#include "P1Laplacian.h"

#include "Error.h"
#include "SymmetricAssembly.h"

#include <string>

namespace crossfield
{
Eigen::Matrix3d P1ElementStiffness(const TriangleMesh& mesh, std::size_t t)
{
  const auto& triangle = mesh.triangles[t];
  const Point& p0 = mesh.points[static_cast<std::size_t>(triangle[0])];
  const Point& p1 = mesh.points[static_cast<std::size_t>(triangle[1])];
  const Point& p2 = mesh.points[static_cast<std::size_t>(triangle[2])];
  const double twiceArea = Cross(p1 - p0, p2 - p0);
  if (!(twiceArea > 0.0))
  {
    throw Error("Triangle " + std::to_string(t) +
      " has no area or is clockwise; remesh the domain with the drill filter.");
  }
  Eigen::Matrix<double, 2, 3> opposite;
  opposite << p2 - p1, p0 - p2, p1 - p0;
  return opposite.transpose() * opposite / (2.0 * twiceArea);
}

Eigen::SparseMatrix<double> P1Stiffness(const TriangleMesh& mesh, const EdgeNumbering& edges)
{
  const auto vertexCount = static_cast<Eigen::Index>(mesh.points.size());
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(vertexCount);
  std::vector<SymmetricEntry> ofEdge;
  ofEdge.reserve(edges.vertices.size());
  for (const auto& [from, to] : edges.vertices)
  {
    ofEdge.push_back({ from, to, 0.0 });
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Eigen::Matrix3d element = P1ElementStiffness(mesh, t);
    for (int i = 0; i < 3; ++i)
    {
      diagonal[mesh.triangles[t][static_cast<std::size_t>(i)]] += element(i, i);
      ofEdge[static_cast<std::size_t>(edges.ofTriangle[t][static_cast<std::size_t>(i)])].value +=
        element(i, (i + 1) % 3);
    }
  }
  return AssembleSymmetric(diagonal, ofEdge);
}
}
