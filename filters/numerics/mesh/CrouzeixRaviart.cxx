#include "CrouzeixRaviart.h"

#include "Error.h"

namespace crossfield
{
SparseMatrix CrouzeixRaviartStiffness(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const Eigen::VectorXd& weights)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& triangle = mesh.triangles[t];
    Point along[3]; // edge vectors p0p1, p1p2, p2p0; rotated and divided by the area they are ∇ψ
    for (std::size_t i = 0; i < 3; ++i)
    {
      along[i] = mesh.points[triangle[(i + 1) % 3]] - mesh.points[triangle[i]];
    }
    const double area = 0.5 * Cross(along[0], along[1]);
    if (!(area > 0.0))
    {
      throw Error("Triangle " + std::to_string(t) +
        " has no area or is clockwise; remesh the domain with the drill filter.");
    }
    const double weight = weights.size() == 0 ? 1.0 : weights[static_cast<Eigen::Index>(t)];
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        entries.emplace_back(
          edges.ofTriangle[t][i], edges.ofTriangle[t][j], weight * along[i].dot(along[j]) / area);
      }
    }
  }
  SparseMatrix matrix(edges.Count(), edges.Count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Complex AlignedRepresentation(const Point& direction)
{
  const Complex unit = Complex(direction.x(), direction.y()) / direction.norm();
  const Complex square = unit * unit;
  return square * square;
}
}
