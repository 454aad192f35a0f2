#include "SizeUniformity.h"

#include "DenseProduct.h"
#include "TriangleArea.h"

#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// ε relative to the mean edge length. Values at vertices represent means over cells, and the mean
/// of a logarithm is finite: log r over the disk that a vertex represents, of area (√3/2) h², has
/// the mean log(0.32 h).
constexpr double CoreFactor = 0.35;
}

double SizeUniformity::Value::Spread() const
{
  return std::sqrt(2.0 * this->energy);
}

SizeUniformity::SizeUniformity(const PointPotential& potential, TargetSizes target)
  : Target(std::move(target))
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
  // The edge length of an equilateral triangle of mean area.
  this->SquaredCore = CoreFactor * CoreFactor * 4.0 / std::sqrt(3.0) * area /
    static_cast<double>(mesh.triangles.size());
  this->Masses /= area;
  this->LogTarget = Eigen::VectorXd::Zero(this->Masses.size());
  for (Eigen::Index v = 0; v < this->LogTarget.size(); ++v)
  {
    this->LogTarget[v] = std::log(this->Target.At(mesh.points[v]));
  }
  if (this->Target.sizing == Sizing::Field)
  {
    // By area alone, places with small quads would hardly count.
    const Eigen::VectorXd quads = this->Masses.array() * (-2.0 * this->LogTarget.array()).exp();
    this->Masses = 0.5 * this->Masses + 0.5 / quads.sum() * quads;
  }
}

bool SizeUniformity::IsInvariantUnder(const PointPotential& potential, const Isometry& map) const
{
  constexpr double MaximumDifference = 0.01;
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
  double squares = 0.0;
  for (Eigen::Index v = 0; v < this->LogTarget.size(); ++v)
  {
    const Point image = map(mesh.points[v]);
    const double difference = std::log(this->Target.At(image)) - this->LogTarget[v];
    squares += this->Masses[v] * difference * difference;
    if (squares > MaximumDifference * MaximumDifference)
    {
      return false;
    }
  }
  return true;
}

Eigen::VectorXd SizeUniformity::LogSizeDeviations(
  const PointPotential& potential, const PointPotential::Solution& solution) const
{
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
  Eigen::VectorXd d = 0.25 * solution.regular.head(this->Masses.size()) - this->LogTarget;
  for (Eigen::Index v = 0; v < d.size(); ++v)
  {
    const Point& x = mesh.points[v];
    for (const LogSource& log : solution.logs)
    {
      d[v] += 0.125 * log.strength * std::log((x - log.position).squaredNorm() + this->SquaredCore);
    }
  }
  d.array() -= this->Masses.dot(d);
  return d;
}

double SizeUniformity::SpreadOf(
  const PointPotential& potential, const PointPotential::Solution& solution) const
{
  return std::sqrt(this->Masses.dot(this->LogSizeDeviations(potential, solution).cwiseAbs2()));
}

Eigen::VectorXd SizeUniformity::Adjoint(
  const PointPotential& potential, const Eigen::VectorXd& weighted) const
{
  const PotentialSolver& solver = *potential.GetProblem().potential;
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(solver.Rows());
  sources.head(weighted.size()) = weighted;
  // removes rounding errors, since the sources of a Neumann problem must sum to zero
  sources[0] -= weighted.sum();
  return solver.SolveSingleValued(sources);
}

SizeUniformity::Value SizeUniformity::Evaluate(
  const PointPotential& potential, const PointPotential::Solution& solution) const
{
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
  const Eigen::Index vertices = this->Masses.size();
  const auto inside =
    static_cast<Eigen::Index>(solution.logs.size() - potential.GetBoundaryLogs().size());

  // 1. D and J.
  const Eigen::VectorXd d = this->LogSizeDeviations(potential, solution);
  Value result;
  const Eigen::VectorXd weighted = this->Masses.cwiseProduct(d);
  result.energy = 0.5 * weighted.dot(d);

  // 2. The logarithms and the sources of R depend on the positions. The operator of R is symmetric,
  // so that one adjoint solution suffices.
  const Eigen::VectorXd adjoint = this->Adjoint(potential, weighted);
  result.gradient = Eigen::VectorXd::Zero(2 * inside);
  for (Eigen::Index j = 0; j < inside; ++j)
  {
    const LogSource& log = solution.logs[j];
    Point sum = Point::Zero();
    for (Eigen::Index v = 0; v < vertices; ++v)
    {
      const Point y = mesh.points[v] - log.position;
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
Eigen::MatrixXd SizeUniformity::Differentiate(const PointPotential& potential,
  const PointPotential::Solution& solution, const Eigen::MatrixXd& regular) const
{
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
  const Eigen::Index vertices = this->Masses.size();
  const Eigen::VectorXd weighted =
    this->Masses.cwiseProduct(this->LogSizeDeviations(potential, solution));
  const Eigen::VectorXd adjoint = this->Adjoint(potential, weighted);

  // 1. Derivatives of D at the vertices, and second derivatives by the position of one singularity.
  Eigen::MatrixXd derivatives = 0.25 * regular.topRows(vertices);
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(regular.cols(), regular.cols());
  for (Eigen::Index j = 0; j < regular.cols() / 2; ++j)
  {
    const LogSource& log = solution.logs[j];
    const double factor = 0.25 * log.strength;
    Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
    for (Eigen::Index v = 0; v < vertices; ++v)
    {
      const Point y = mesh.points[v] - log.position;
      const double inverse = 1.0 / (y.squaredNorm() + this->SquaredCore);
      derivatives(v, 2 * j) -= factor * inverse * y.x();
      derivatives(v, 2 * j + 1) -= factor * inverse * y.y();
      block +=
        weighted[v] * inverse * (Eigen::Matrix2d::Identity() - 2.0 * inverse * y * y.transpose());
    }
    for (const BoundaryHalf& half : potential.GetHalves())
    {
      block -= adjoint[half.vertex] *
        (LogSource::TurnCurvature(half.to, log.position) -
          LogSource::TurnCurvature(half.from, log.position));
    }
    hessian.block<2, 2>(2 * j, 2 * j) = factor * block;
  }

  // 2. Products of first derivatives, without their means, which D does not contain.
  derivatives.rowwise() -= (this->Masses.transpose() * derivatives).eval();
  return hessian + AdjointProduct(derivatives, this->Masses.asDiagonal() * derivatives);
}
}
