#include "ClearanceBarrier.h"

#include "Segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// κ relative to the product of the quarter indices; see the constructor.
constexpr double RepulsionFactor = 0.1;

/// b and its derivatives with respect to d, for κ = 1.
struct BarrierValue
{
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
};

BarrierValue EvaluateBarrier(double d, double distance)
{
  const double t = (d - distance) / distance;
  if (!(t > 0.0))
  {
    return { std::numeric_limits<double>::infinity(), 0.0, 0.0 };
  }
  if (t >= 1.0)
  {
    return {};
  }
  const double remainder = 1.0 - t;
  const double logarithm = std::log(t);
  return { -remainder * remainder * logarithm,
    (2.0 * remainder * logarithm - remainder * remainder / t) / distance,
    (-2.0 * logarithm + 4.0 * remainder / t + remainder * remainder / (t * t)) /
      (distance * distance) };
}

/// Returns the second derivatives of a distance d with gradient `normal`.
Eigen::Matrix2d DistanceHessian(const Point& normal, double d)
{
  return (Eigen::Matrix2d::Identity() - normal * normal.transpose()) / d;
}

/// Adds the second derivatives of a function of the difference of two positions.
void AddPair(
  Eigen::MatrixXd& matrix, Eigen::Index row, Eigen::Index column, const Eigen::Matrix2d& block)
{
  matrix.block<2, 2>(row, row) += block;
  matrix.block<2, 2>(column, column) += block;
  matrix.block<2, 2>(row, column) -= block;
  matrix.block<2, 2>(column, row) -= block;
}
}

ClearanceFactors FactorsOfParts(
  const PlanarDomain& domain, const PlanarDomain& refined, const ClearanceFactors& factors)
{
  ClearanceFactors ofParts(factors.size());
  for (std::size_t l = 0; l < factors.size(); ++l)
  {
    const Loop& loop = domain.loops[l];
    std::size_t edge = 0;
    for (const Point& vertex : refined.loops[l])
    {
      edge += edge + 1 < loop.size() && vertex == loop[edge + 1] ? 1 : 0;
      ofParts[l].push_back(factors[l].at(edge));
    }
  }
  return ofParts;
}

ClearanceBarrier::ClearanceBarrier(const PlanarDomain& domain, const Configuration& configuration,
  double distance, const ClearanceFactors& factors)
  : Distance(distance)
  , Boundary(domain)
{
  for (const Singularity& singularity : configuration)
  {
    this->Quarters.push_back(
      singularity.quarterIndex == 0 ? 1.0 : static_cast<double>(singularity.quarterIndex));
  }
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    const Loop& loop = domain.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& to = loop[(i + 1) % loop.size()];
      const double factor = FactorAt(factors, l, i);
      const double weight = std::min(1.0, (to - loop[i]).norm() / (factor * distance));
      this->Sides.push_back({ loop[i], to, weight, factor });
      this->LargestFactor = std::max(this->LargestFactor, factor);
    }
  }
}

ClearanceBarrier::Value ClearanceBarrier::Evaluate(const Eigen::VectorXd& positions) const
{
  Value result;
  result.gradient = Eigen::VectorXd::Zero(positions.size());
  result.hessian = Eigen::MatrixXd::Zero(positions.size(), positions.size());
  result.negativeHessian = result.hessian;
  for (std::size_t i = 0; i < this->Quarters.size(); ++i)
  {
    const Eigen::Index row = 2 * static_cast<Eigen::Index>(i);
    const Point position = positions.segment<2>(row);
    const double quarters = this->Quarters[i];
    const auto add = [&](std::size_t s)
    {
      const Side& side = this->Sides[s];
      const Point offset = OffsetFromSegment(position, side.from, side.to);
      const double reach = 2.0 * side.factor * this->Distance;
      if (offset.squaredNorm() < reach * reach)
      {
        const double t = NearestFraction(position, side.from, side.to);
        const double d = offset.norm();
        const BarrierValue barrier = EvaluateBarrier(d, side.factor * this->Distance);
        const double factor = RepulsionFactor * quarters * quarters * side.weight;
        const Point normal = offset / d;
        result.energy += factor * barrier.value;
        result.gradient.segment<2>(row) += factor * barrier.first * normal;
        result.hessian.block<2, 2>(row, row) +=
          factor * barrier.second * normal * normal.transpose();
        if (t == 0.0 || t == 1.0)
        {
          result.negativeHessian.block<2, 2>(row, row) +=
            factor * barrier.first * DistanceHessian(normal, d);
        }
      }
    };
    this->Boundary.ForNear(position, 2.0 * this->LargestFactor * this->Distance, add);
    for (std::size_t j = 0; j < i; ++j)
    {
      const Eigen::Index column = 2 * static_cast<Eigen::Index>(j);
      const Point offset = position - positions.segment<2>(column);
      if (offset.squaredNorm() < 4.0 * this->Distance * this->Distance)
      {
        const double d = offset.norm();
        const BarrierValue barrier = EvaluateBarrier(d, this->Distance);
        const double product = quarters * this->Quarters[j];
        const double factor = product < 0.0 ? -product : RepulsionFactor * product;
        const Point normal = offset / d;
        result.energy += factor * barrier.value;
        result.gradient.segment<2>(row) += factor * barrier.first * normal;
        result.gradient.segment<2>(column) -= factor * barrier.first * normal;
        AddPair(result.hessian, row, column, factor * barrier.second * normal * normal.transpose());
        AddPair(
          result.negativeHessian, row, column, factor * barrier.first * DistanceHessian(normal, d));
      }
    }
  }
  return result;
}
}
