#pragma once

#include "Plane.h"

#include <array>
#include <complex>

namespace crossfield
{
/// Logarithmic source: the function strength · log|x − position|, which is subtracted from a
/// potential that is singular there (docs/method.md §5.3, §11.3). Its conjugate is strength · arg(x
/// − position).
struct LogSource
{
  Point position = Point::Zero();
  double strength = 0.0;
  double angle = 2.0 * Pi; ///< Angle of the domain at the position: 2π inside, α at a corner.

  double Value(const Point& x) const
  {
    return this->strength * std::log((x - this->position).norm());
  }

  /// Returns the angle in (−π, π] under which the position sees the segment from one point to
  /// another.
  double Turn(const Point& from, const Point& to) const
  {
    return AngleBetween(from - this->position, to - this->position);
  }

  /// Returns the derivative of arg(x − position) with respect to the position.
  static Point TurnDerivative(const Point& x, const Point& position)
  {
    const Point y = x - position;
    return Point(y.y(), -y.x()) / y.squaredNorm();
  }

  /// Returns the second derivatives of arg(x − position) with respect to the position.
  static Eigen::Matrix2d TurnCurvature(const Point& x, const Point& position)
  {
    const Point y = (x - position) / (x - position).squaredNorm();
    const double mixed = y.y() * y.y() - y.x() * y.x();
    const double twice = 2.0 * y.x() * y.y();
    return (Eigen::Matrix2d() << twice, mixed, mixed, -twice).finished();
  }

  /// Returns the derivative of log|x − position| with respect to the position.
  static Point LogDerivative(const Point& x, const Point& position)
  {
    const Point y = x - position;
    return -y / y.squaredNorm();
  }
};

/// Returns Σ strength · log|x − position|. Integer strengths are evaluated as powers of the
/// distances, so that several sources share one logarithm.
double SumOfLogs(const std::vector<LogSource>& logs, const Point& x);

/// Returns Σ strength · Turn(from, to) over a range of sources. Integer strengths are evaluated as
/// powers, so that several sources that see the segment under less than a right angle share one
/// arctangent.
double SumOfTurns(const LogSource* begin, const LogSource* end, const Point& from, const Point& to);

/// Returns e^{i Σ strength · arg(x − position)} over the first `count` sources, whose strengths
/// must be integers. A source at x is ignored.
std::complex<double> UnitOfTurns(
  const std::vector<LogSource>& logs, std::size_t count, const Point& x);

/// Returns the exact value of ∫ log|x − centre| along the straight segment from one point to
/// another.
double LogIntegral(const Point& from, const Point& to, const Point& centre);

/// Returns the exact value of ∫ log|x − centre| over the triangulated polygon with this boundary.
/// The identity log r = div(½ (x − centre) (log r − ½)) reduces it to integrals of log r along
/// straight edges.
double LogIntegral(const std::vector<std::array<Point, 2>>& boundary, const Point& centre);
}
