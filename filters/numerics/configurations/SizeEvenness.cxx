#include "SizeEvenness.h"

#include "TriangleArea.h"

#include <cmath>

namespace crossfield
{
namespace
{
/// Of a mean edge. Values at vertices stand for means over cells, and a logarithm is finite in the mean:
/// log r of the disk that a vertex stands for, of area (√3/2) h², has the mean log(0.32 h).
constexpr double Core = 0.35;
}

double SizeEvenness::Value::Spread() const
{
  return std::sqrt(2.0 * this->energy);
}

SizeEvenness::SizeEvenness(const PointPotential& potential)
{
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
  this->Masses = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.points.size()));
  for (const auto& triangle : mesh.triangles)
  {
    const double area = TriangleArea(mesh, triangle);
    for (const int vertex : triangle)
    {
      this->Masses[vertex] += area / 3.0;
    }
  }
  const double area = this->Masses.sum();
  // Edges of an equilateral triangle of mean area.
  this->SquaredCore =
    Core * Core * 4.0 / std::sqrt(3.0) * area / static_cast<double>(mesh.triangles.size());
  this->Masses /= area;
}

Eigen::VectorXd SizeEvenness::SizesOf(
  const PointPotential& potential, const PointPotential::Solution& solution) const
{
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
  Eigen::VectorXd h = 0.25 * solution.regular.head(this->Masses.size());
  for (Eigen::Index v = 0; v < h.size(); ++v)
  {
    const Point& x = mesh.points[static_cast<std::size_t>(v)];
    for (const LogSource& log : solution.logs)
    {
      h[v] += 0.125 * log.strength * std::log((x - log.position).squaredNorm() + this->SquaredCore);
    }
  }
  h.array() -= this->Masses.dot(h);
  return h;
}

SizeEvenness::Value SizeEvenness::Evaluate(
  const PointPotential& potential, const PointPotential::Solution& solution) const
{
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
  const Eigen::Index vertices = this->Masses.size();
  const auto inside =
    static_cast<Eigen::Index>(solution.logs.size() - potential.GetBoundaryLogs().size());

  // 1. H, and J.
  const Eigen::VectorXd h = this->SizesOf(potential, solution);
  Value result;
  const Eigen::VectorXd weighted = this->Masses.cwiseProduct(h);
  result.energy = 0.5 * weighted.dot(h);

  // 2. The logarithms move, and the sources of R: its operator is symmetric, so one solution is enough.
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(solution.sources.size());
  sources.head(vertices) = weighted;
  sources[0] -= weighted.sum(); // rounding, which a Neumann problem must not see as a source
  const Eigen::VectorXd adjoint = potential.SolveSingleValued(sources);
  result.gradient = Eigen::VectorXd::Zero(2 * inside);
  for (Eigen::Index j = 0; j < inside; ++j)
  {
    const LogSource& log = solution.logs[static_cast<std::size_t>(j)];
    Point sum = Point::Zero();
    for (Eigen::Index v = 0; v < vertices; ++v)
    {
      const Point y = mesh.points[static_cast<std::size_t>(v)] - log.position;
      sum -= weighted[v] / (y.squaredNorm() + this->SquaredCore) * y;
    }
    for (const BoundaryHalf& half : potential.GetHalves())
    {
      sum -= adjoint[half.vertex] *
        (LogSource::TurnDerivative(half.to, log.position) -
          LogSource::TurnDerivative(half.from, log.position));
    }
    result.gradient.segment<2>(2 * j) = 0.25 * log.strength * sum;
  }
  return result;
}
}
