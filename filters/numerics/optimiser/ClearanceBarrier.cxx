#include "ClearanceBarrier.h"

#include "Segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// See the constructor.
constexpr double Repelling = 0.1;

/// b and its derivatives in d for κ = 1.
struct Well
{
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
};

Well EvaluateWell(double d, double distance)
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
  const double rest = 1.0 - t;
  const double logarithm = std::log(t);
  return { -rest * rest * logarithm, (2.0 * rest * logarithm - rest * rest / t) / distance,
    (-2.0 * logarithm + 4.0 * rest / t + rest * rest / (t * t)) / (distance * distance) };
}

/// Second derivatives of a distance.
Eigen::Matrix2d Bend(const Point& normal, double d)
{
  return (Eigen::Matrix2d::Identity() - normal * normal.transpose()) / d;
}

/// Second derivatives of a function of the difference of two places.
void AddPair(
  Eigen::MatrixXd& matrix, Eigen::Index row, Eigen::Index column, const Eigen::Matrix2d& block)
{
  matrix.block<2, 2>(row, row) += block;
  matrix.block<2, 2>(column, column) += block;
  matrix.block<2, 2>(row, column) -= block;
  matrix.block<2, 2>(column, row) -= block;
}
}

ClearanceBarrier::ClearanceBarrier(
  const PlanarDomain& domain, const Configuration& configuration, double distance)
  : Distance(distance)
{
  for (const Singularity& singularity : configuration)
  {
    this->Quarters.push_back(
      singularity.quarterIndex == 0 ? 1.0 : static_cast<double>(singularity.quarterIndex));
  }
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& to = loop[(i + 1) % loop.size()];
      this->Sides.push_back({ loop[i], to, std::min(1.0, (to - loop[i]).norm() / distance) });
    }
  }
}

ClearanceBarrier::Value ClearanceBarrier::Evaluate(const Eigen::VectorXd& places) const
{
  Value result;
  result.gradient = Eigen::VectorXd::Zero(places.size());
  result.hessian = Eigen::MatrixXd::Zero(places.size(), places.size());
  result.bend = result.hessian;
  for (std::size_t i = 0; i < this->Quarters.size(); ++i)
  {
    const Eigen::Index row = 2 * static_cast<Eigen::Index>(i);
    const Point here = places.segment<2>(row);
    const double own = this->Quarters[i];
    for (const Side& side : this->Sides)
    {
      const double t = NearestFraction(here, side.from, side.to);
      const Point apart = WayFromSegment(here, side.from, side.to);
      const double d = apart.norm();
      if (d < 2.0 * this->Distance)
      {
        const Well well = EvaluateWell(d, this->Distance);
        const double factor = Repelling * own * own * side.weight;
        const Point normal = apart / d;
        result.energy += factor * well.value;
        result.gradient.segment<2>(row) += factor * well.first * normal;
        result.hessian.block<2, 2>(row, row) += factor * well.second * normal * normal.transpose();
        if (t == 0.0 || t == 1.0)
        {
          result.bend.block<2, 2>(row, row) += factor * well.first * Bend(normal, d);
        }
      }
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      const Eigen::Index column = 2 * static_cast<Eigen::Index>(j);
      const Point apart = here - places.segment<2>(column);
      const double d = apart.norm();
      if (d < 2.0 * this->Distance)
      {
        const Well well = EvaluateWell(d, this->Distance);
        const double product = own * this->Quarters[j];
        const double factor = product < 0.0 ? -product : Repelling * product;
        const Point normal = apart / d;
        result.energy += factor * well.value;
        result.gradient.segment<2>(row) += factor * well.first * normal;
        result.gradient.segment<2>(column) -= factor * well.first * normal;
        AddPair(result.hessian, row, column, factor * well.second * normal * normal.transpose());
        AddPair(result.bend, row, column, factor * well.first * Bend(normal, d));
      }
    }
  }
  return result;
}
}
