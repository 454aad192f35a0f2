#include "P1Laplacian.h"

#include "Error.h"

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
  Eigen::VectorXd ofEdge = Eigen::VectorXd::Zero(edges.Count());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Eigen::Matrix3d element = P1ElementStiffness(mesh, t);
    for (int i = 0; i < 3; ++i)
    {
      diagonal[mesh.triangles[t][static_cast<std::size_t>(i)]] += element(i, i);
      ofEdge[edges.ofTriangle[t][static_cast<std::size_t>(i)]] += element(i, (i + 1) % 3);
    }
  }

  // Every column holds its diagonal entry and one entry per edge. Filled in the order of the edges
  // after a count, which is several times faster than sorting triplets; rows within a column are
  // sorted by transposing twice.
  Eigen::VectorXi count = Eigen::VectorXi::Ones(vertexCount);
  for (const auto& ends : edges.vertices)
  {
    ++count[ends[0]];
    ++count[ends[1]];
  }
  Eigen::SparseMatrix<double> unsorted(vertexCount, vertexCount);
  unsorted.resizeNonZeros(vertexCount + 2 * static_cast<Eigen::Index>(edges.Count()));
  int* starts = unsorted.outerIndexPtr();
  starts[0] = 0;
  for (Eigen::Index v = 0; v < vertexCount; ++v)
  {
    starts[v + 1] = starts[v] + count[v];
    count[v] = starts[v];
  }
  const auto place = [&](int row, int column, double value)
  {
    const int position = count[column]++;
    unsorted.innerIndexPtr()[position] = row;
    unsorted.valuePtr()[position] = value;
  };
  for (int v = 0; v < static_cast<int>(vertexCount); ++v)
  {
    place(v, v, diagonal[v]);
  }
  for (int e = 0; e < edges.Count(); ++e)
  {
    const auto& ends = edges.vertices[static_cast<std::size_t>(e)];
    place(ends[0], ends[1], ofEdge[e]);
    place(ends[1], ends[0], ofEdge[e]);
  }
  // The matrix equals its transpose, and transposing sorts the rows.
  return unsorted.transpose();
}
}
