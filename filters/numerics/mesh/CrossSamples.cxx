#include "CrossSamples.h"

#include "TriangleArea.h"

namespace crossfield
{
CrossSamples SampleField(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const ComplexVector& u)
{
  CrossSamples samples;
  samples.atTriangles.resize(static_cast<Eigen::Index>(mesh.triangles.size()));
  samples.atVertices = ComplexVector::Zero(static_cast<Eigen::Index>(mesh.points.size()));
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(samples.atVertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& triangle = mesh.triangles[t];
    const auto& numbers = edges.ofTriangle[t];
    const double area = TriangleArea(mesh, triangle);
    const Complex sum = u[numbers[0]] + u[numbers[1]] + u[numbers[2]];
    samples.atTriangles[static_cast<Eigen::Index>(t)] = sum / 3.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      // The linear function with these midpoint values, evaluated at the vertex opposite edge i +
      // 1.
      samples.atVertices[triangle[i]] += area * (sum - 2.0 * u[numbers[(i + 1) % 3]]);
      weights[triangle[i]] += area;
    }
  }
  for (Eigen::Index v = 0; v < weights.size(); ++v)
  {
    if (weights[v] > 0.0)
    {
      samples.atVertices[v] /= weights[v];
    }
  }
  return samples;
}
}
