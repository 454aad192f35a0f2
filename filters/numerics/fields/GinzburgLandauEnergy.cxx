#include "GinzburgLandauEnergy.h"

#include "Error.h"
#include "TriangleArea.h"

#include <cmath>
#include <string>

namespace crossfield
{
namespace
{
const GinzburgLandauPinning& CheckPinning(
  const GinzburgLandauPinning& pinning, const TriangleMesh& mesh, const EdgeNumbering& numbering)
{
  const auto triangles = static_cast<Eigen::Index>(mesh.triangles.size());
  const Eigen::Index edges = numbering.Count();
  const Eigen::Index norms = pinning.norm.size();
  if (norms != 0 && norms != triangles && norms != edges)
  {
    throw Error("The target norm of the penalty has " + std::to_string(norms) +
      " values on a mesh with " + std::to_string(triangles) + " triangles and " +
      std::to_string(edges) + " edges; give one value per triangle or one per edge.");
  }
  if (!pinning.norm.allFinite() || (norms != 0 && pinning.norm.minCoeff() < 0.0))
  {
    throw Error("The target norm of the penalty is negative or not finite somewhere; give "
                "values of 0 or more, 1 where nothing is pinned.");
  }
  const Eigen::Index weights = pinning.gradientWeight.size();
  if (weights != 0 && weights != triangles)
  {
    throw Error("The weight of the gradient term has " + std::to_string(weights) +
      " values on a mesh with " + std::to_string(triangles) +
      " triangles; give one value per triangle.");
  }
  if (!pinning.gradientWeight.allFinite() ||
    (weights != 0 && !(pinning.gradientWeight.minCoeff() > 0.0)))
  {
    throw Error("The weight of the gradient term is not positive or not finite somewhere; give "
                "positive values, 1 where nothing is pinned.");
  }
  return pinning;
}

/// Returns the matrix that acts on real and imaginary parts separately, with all entries of the
/// diagonal blocks stored.
SparseMatrix OnBothParts(const SparseMatrix& matrix)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(2 * (matrix.nonZeros() + matrix.rows())));
  for (int column = 0; column < static_cast<int>(matrix.cols()); ++column)
  {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      const auto row = static_cast<int>(entry.row());
      entries.emplace_back(2 * row, 2 * column, entry.value());
      entries.emplace_back(2 * row + 1, 2 * column + 1, entry.value());
    }
    entries.emplace_back(2 * column, 2 * column + 1, 0.0);
    entries.emplace_back(2 * column + 1, 2 * column, 0.0);
  }
  SparseMatrix both(2 * matrix.rows(), 2 * matrix.cols());
  both.setFromTriplets(entries.begin(), entries.end());
  return both;
}

/// Returns the position of an entry in the value array of a matrix.
std::ptrdiff_t PositionOf(SparseMatrix& matrix, Eigen::Index row, Eigen::Index column)
{
  return &matrix.coeffRef(row, column) - matrix.valuePtr();
}
}

GinzburgLandauEnergy::GinzburgLandauEnergy(
  const PlanarTopology& topology, double epsilon, const GinzburgLandauPinning& pinning)
  : InverseSquare(1.0 / (epsilon * epsilon))
  , Aligned(topology, CheckPinning(pinning, topology.mesh, topology.edges).gradientWeight)
{
  const TriangleMesh& mesh = topology.mesh;
  const EdgeNumbering& edges = topology.edges;
  if (!(epsilon > 0.0) || !std::isfinite(epsilon))
  {
    throw Error("The length epsilon of the Ginzburg-Landau penalty must be positive; give a length "
                "of about the size of a triangle.");
  }
  const auto triangleCount = static_cast<Eigen::Index>(mesh.triangles.size());
  this->Mass = this->Pull = this->Offset = Eigen::VectorXd::Zero(edges.Count());
  const bool perTriangle = pinning.norm.size() == triangleCount;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const double share = TriangleArea(mesh, mesh.triangles[t]) / 3.0;
    for (const int edge : edges.ofTriangle[t])
    {
      const double norm = pinning.norm.size() == 0 ? 1.0
        : perTriangle                              ? pinning.norm[static_cast<Eigen::Index>(t)]
                                                   : pinning.norm[edge];
      this->Mass[edge] += share;
      this->Pull[edge] += share * norm * norm;
      this->Offset[edge] += share * norm * norm * norm * norm;
    }
  }

  this->Pattern = OnBothParts(this->Aligned.freeStiffness);
  for (Eigen::Index i = 0; i < this->Aligned.freeStiffness.rows(); ++i)
  {
    this->Blocks.push_back({ PositionOf(this->Pattern, 2 * i, 2 * i),
      PositionOf(this->Pattern, 2 * i + 1, 2 * i), PositionOf(this->Pattern, 2 * i, 2 * i + 1),
      PositionOf(this->Pattern, 2 * i + 1, 2 * i + 1) });
  }
}

double GinzburgLandauEnergy::GradientPart(const ComplexVector& u) const
{
  return 0.5 * u.dot(ComplexVector(this->Aligned.stiffness * u)).real();
}

double GinzburgLandauEnergy::PenaltyPart(const ComplexVector& u) const
{
  const Eigen::ArrayXd square = u.array().abs2();
  // Complete the square, so that a small penalty is not lost in the rounding of large terms.
  const Eigen::ArrayXd targetSquare = this->Pull.array() / this->Mass.array();
  const Eigen::ArrayXd spread = this->Offset.array() - this->Pull.array() * targetSquare;
  return 0.25 * this->InverseSquare *
    (this->Mass.array() * (square - targetSquare).square() + spread).sum();
}

Eigen::VectorXd GinzburgLandauEnergy::Gradient(const ComplexVector& u) const
{
  const ComplexVector elastic = this->Aligned.stiffness * u;
  Eigen::VectorXd gradient(2 * static_cast<Eigen::Index>(this->Aligned.free.size()));
  for (std::size_t i = 0; i < this->Aligned.free.size(); ++i)
  {
    const int edge = this->Aligned.free[i];
    const double push =
      this->InverseSquare * (this->Mass[edge] * std::norm(u[edge]) - this->Pull[edge]);
    const Complex value = elastic[edge] + push * u[edge];
    gradient[2 * static_cast<Eigen::Index>(i)] = value.real();
    gradient[2 * static_cast<Eigen::Index>(i) + 1] = value.imag();
  }
  return gradient;
}

double GinzburgLandauEnergy::ResidualScale(const ComplexVector& u) const
{
  ComplexVector inside = ComplexVector::Zero(u.size());
  double penalty = 0.0;
  for (const int edge : this->Aligned.free)
  {
    inside[edge] = u[edge];
    penalty += std::norm(
      this->InverseSquare * (this->Mass[edge] * std::norm(u[edge]) - this->Pull[edge]) * u[edge]);
  }
  const ComplexVector elastic = this->Aligned.stiffness * inside;
  const ComplexVector load = this->Aligned.stiffness * ComplexVector(u - inside);
  double elasticSum = 0.0;
  double loadSum = 0.0;
  for (const int edge : this->Aligned.free)
  {
    elasticSum += std::norm(elastic[edge]);
    loadSum += std::norm(load[edge]);
  }
  return std::sqrt(elasticSum) + std::sqrt(loadSum) + std::sqrt(penalty);
}

Eigen::SparseMatrix<double> GinzburgLandauEnergy::Hessian(
  const ComplexVector& u, double shift) const
{
  SparseMatrix hessian = this->Pattern;
  double* values = hessian.valuePtr();
  for (std::size_t i = 0; i < this->Aligned.free.size(); ++i)
  {
    const int edge = this->Aligned.free[i];
    const double mass = this->InverseSquare * this->Mass[edge];
    const double push =
      mass * std::norm(u[edge]) + (shift - 1.0) * this->InverseSquare * this->Pull[edge];
    const double x = u[edge].real();
    const double y = u[edge].imag();
    const auto& [xx, yx, xy, yy] = this->Blocks[i];
    values[xx] += push + 2.0 * mass * x * x;
    values[yx] += 2.0 * mass * x * y;
    values[xy] += 2.0 * mass * x * y;
    values[yy] += push + 2.0 * mass * y * y;
  }
  return hessian;
}

Eigen::VectorXd GinzburgLandauEnergy::Metric() const
{
  Eigen::VectorXd metric(2 * static_cast<Eigen::Index>(this->Aligned.free.size()));
  for (std::size_t i = 0; i < this->Aligned.free.size(); ++i)
  {
    metric.segment<2>(2 * static_cast<Eigen::Index>(i))
      .setConstant(this->InverseSquare * this->Pull[this->Aligned.free[i]]);
  }
  return metric;
}

std::vector<int> GinzburgLandauEnergy::UnknownOrder(const std::vector<int>& trailing) const
{
  std::vector<int> order;
  order.reserve(2 * this->Aligned.free.size());
  for (const int i : this->Aligned.EliminationOrder(trailing))
  {
    order.push_back(2 * i);
    order.push_back(2 * i + 1);
  }
  return order;
}
}
