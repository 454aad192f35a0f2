#include "FieldIndices.h"

#include "BothHalves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace crossfield
{
namespace
{
int Turns(double angle)
{
  return static_cast<int>(std::lround(angle / (2.0 * Pi)));
}

double WrappedStep(const Complex& from, const Complex& to)
{
  return std::arg(std::conj(from) * to);
}
}

FieldIndices ReadIndices(const MeshTopology& topology, const ComplexVector& u)
{
  const TriangleMesh& mesh = topology.mesh;
  const EdgeNumbering& edges = topology.edges;
  FieldIndices indices;
  indices.ofTriangle.resize(mesh.triangles.size());
  // Change of arg u around each vertex, from midpoint to midpoint inside the domain, for either
  // half of the triangles.
  std::array<std::vector<double>, 2> parts;
  const auto triangleCount = static_cast<int>(mesh.triangles.size());
  const auto read = [&](std::size_t half)
  {
    std::vector<double>& around = parts[half];
    around.assign(mesh.points.size(), 0.0);
    const auto [begin, end] = HalfRange(triangleCount, half);
    for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        // Edges i and i + 1 of the triangle meet in its vertex i + 1, around which the same step is
        // taken in the opposite direction. It is computed once, so that everything adds up to zero
        // regardless of rounding.
        const double step =
          WrappedStep(u[edges.ofTriangle[t][i]], u[edges.ofTriangle[t][(i + 1) % 3]]);
        sum += step;
        around[static_cast<std::size_t>(mesh.triangles[t][(i + 1) % 3])] -= step;
      }
      indices.ofTriangle[t] = Turns(sum);
    }
  };
  ForBothHalves(triangleCount >= MinimumParallelCount, read);
  std::vector<double>& around = parts[0];
  std::transform(
    around.begin(), around.end(), parts[1].begin(), around.begin(), std::plus<double>());

  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& after = mesh.boundary[i];
    double& here = around[static_cast<std::size_t>(after.vertices[0])];
    here += after.IsAligned()
      ? 4.0 * topology.turning[static_cast<Eigen::Index>(i)]
      : -WrappedStep(u[edges.ofBoundary[i]], u[topology.EdgeOfBoundary(topology.previous[i])]);
  }
  indices.ofVertex.resize(mesh.points.size());
  std::transform(around.begin(), around.end(), indices.ofVertex.begin(), Turns);
  return indices;
}

void MergeAtVertices(
  const TriangleMesh& mesh, const std::vector<bool>& marked, FieldIndices& indices)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (int vertex : mesh.triangles[t])
    {
      if (marked[static_cast<std::size_t>(vertex)])
      {
        indices.ofVertex[static_cast<std::size_t>(vertex)] += indices.ofTriangle[t];
        indices.ofTriangle[t] = 0;
      }
    }
  }
}

bool HoleReading::Reliable() const
{
  // Below a tenth of the largest norm the direction of u between two edges is unreliable.
  return this->largestStep <= 0.5 * Pi && this->minimumNorm > 0.1 * this->maximumNorm;
}

HoleReading ReadHole(const BoundaryLoop& loop, const EdgeNumbering& edges, const ComplexVector& u)
{
  HoleReading reading;
  const std::vector<int> numbers = EdgesOf(loop, edges);
  const auto value = [&](std::size_t i) { return u[numbers[i % numbers.size()]]; };
  reading.minimumNorm = reading.maximumNorm = std::abs(value(0));
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.edges.size(); ++i)
  {
    const double step = WrappedStep(value(i), value(i + 1));
    sum += step;
    reading.largestStep = std::max(reading.largestStep, std::abs(step));
    reading.minimumNorm = std::min(reading.minimumNorm, std::abs(value(i)));
    reading.maximumNorm = std::max(reading.maximumNorm, std::abs(value(i)));
  }
  reading.degree = Turns(sum);
  return reading;
}
}
