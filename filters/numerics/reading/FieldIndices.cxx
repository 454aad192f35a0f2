#include "FieldIndices.h"

#include "Parts.h"

#include <algorithm>
#include <array>
#include <cmath>

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

FieldIndices ReadIndices(const PlanarTopology& topology, const ComplexVector& u)
{
  const TriangleMesh& mesh = topology.mesh;
  const EdgeNumbering& edges = topology.edges;
  FieldIndices indices;
  indices.ofTriangle.resize(mesh.triangles.size());
  // Change of arg u from edge i to edge i + 1 of each triangle. They meet in its vertex i + 1, around
  // which the same step is taken in the opposite direction. It is computed once, so that everything
  // adds up to zero regardless of rounding.
  std::vector<std::array<double, 3>> steps(mesh.triangles.size());
  ForRanges(static_cast<std::ptrdiff_t>(steps.size()),
    [&](int begin, int end)
    {
      for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
      {
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
        {
          steps[t][i] = WrappedStep(u[edges.ofTriangle[t][i]], u[edges.ofTriangle[t][(i + 1) % 3]]);
          sum += steps[t][i];
        }
        indices.ofTriangle[t] = Turns(sum);
      }
    });
  // Change of arg u around each vertex, from midpoint to midpoint inside the domain.
  std::vector<double> around(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < steps.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      around[mesh.triangles[t][(i + 1) % 3]] -= steps[t][i];
    }
  }

  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& after = mesh.boundary[i];
    double& here = around[after.vertices[0]];
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
      if (marked[vertex])
      {
        indices.ofVertex[vertex] += indices.ofTriangle[t];
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
