#pragma once

#include "Plane.h"

#include <array>
#include <complex>

namespace crossfield
{
/// The function strength · log|x − position|, subtracted from a potential where it is singular
/// (docs/method.md §5.3, §11.3). Its conjugate is strength · arg(x − position).
struct LogSource
{
  Point position = Point::Zero();
  double strength = 0.0;
  double angle = 2.0 * Pi; ///< Of the domain around the position: 2π inside, α at a corner.

  double Value(const Point& x) const
  {
    return this->strength * std::log((x - this->position).norm());
  }

  /// The angle, in (−π, π], at which the position sees the way from one point to another.
  double Turn(const Point& from, const Point& to) const
  {
    return AngleBetween(from - this->position, to - this->position);
  }

  /// Derivative of arg(x − position) in the position.
  static Point TurnDerivative(const Point& x, const Point& position)
  {
    const Point y = x - position;
    return Point(y.y(), -y.x()) / y.squaredNorm();
  }

  /// Derivative of log|x − position| in the position.
  static Point LogDerivative(const Point& x, const Point& position)
  {
    const Point y = x - position;
    return -y / y.squaredNorm();
  }
};

/// Σ strength · log|x − position|. Whole strengths are taken as powers of the distances, so that there
/// is one logarithm for several sources.
double SumOfLogs(const std::vector<LogSource>& logs, const Point& x);

/// Σ strength · Turn(from, to) of the sources of a range. Whole strengths are taken as powers, so that there is one angle for
/// several sources that see the way under less than a right angle.
double SumOfTurns(const LogSource* begin, const LogSource* end, const Point& from, const Point& to);

/// e^{i Σ strength · arg(x − position)} of the first `count` sources, whose strengths are whole numbers;
/// a source at x counts for nothing.
std::complex<double> UnitOfTurns(
  const std::vector<LogSource>& logs, std::size_t count, const Point& x);

/// ∫ log|x − centre| along the straight way from one point to another, exactly.
double LogIntegral(const Point& from, const Point& to, const Point& centre);

/// ∫ log|x − centre| over the triangulated polygon with this boundary, exactly:
/// log r = div(½ (x − centre) (log r − ½)), which leaves integrals of log r along straight edges.
double LogIntegral(const std::vector<std::array<Point, 2>>& boundary, const Point& centre);
}
