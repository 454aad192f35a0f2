#include "LogSource.h"

namespace crossfield
{
namespace
{
/// Maximum number of squared distances in a product before its logarithm or angle is evaluated.
constexpr int MaximumFactors = 4;

/// Returns whether a product is out of the bounds up to which factors may be multiplied. Squared
/// distances within domains of the permitted extents (DomainExtent.h) are between 1e-160 and 1e121,
/// so no product overflows.
bool IsOutOfBounds(double product)
{
  constexpr double Largest = 1e140;
  return !(product > 1.0 / Largest && product < Largest);
}
}

double SumOfLogs(const std::vector<LogSource>& logs, const Point& x)
{
  double sum = 0.0;
  double product = 1.0;
  int factors = 0;
  const auto evaluate = [&]
  {
    sum += 0.5 * std::log(product);
    product = 1.0;
    factors = 0;
  };
  for (const LogSource& log : logs)
  {
    const double square = (x - log.position).squaredNorm();
    const int power = static_cast<int>(std::abs(log.strength));
    if (static_cast<double>(power) != std::abs(log.strength) || power > MaximumFactors)
    {
      sum += 0.5 * log.strength * std::log(square);
      continue;
    }
    if (factors + power > MaximumFactors)
    {
      evaluate();
    }
    for (int i = 0; i < power; ++i)
    {
      product = log.strength > 0.0 ? product * square : product / square;
      if (IsOutOfBounds(product))
      {
        evaluate();
      }
    }
    factors += power;
  }
  evaluate();
  return sum;
}

double SumOfTurns(const LogSource* begin, const LogSource* end, const Point& from, const Point& to)
{
  double sum = 0.0;
  double real = 1.0;
  double imaginary = 0.0;
  for (const LogSource* log = begin; log != end; ++log)
  {
    const Point start = from - log->position;
    const Point finish = to - log->position;
    const double along = start.dot(finish);
    const double across = Cross(start, finish);
    const int power = static_cast<int>(std::abs(log->strength));
    if (!(along > 0.0) || static_cast<double>(power) != std::abs(log->strength))
    {
      sum += log->strength * std::atan2(across, along);
      continue;
    }
    const double turned = log->strength < 0.0 ? -across : across;
    for (int i = 0; i < power; ++i)
    {
      // The angles of two numbers with positive real parts add up to less than π.
      const double before = real;
      real = before * along - imaginary * turned;
      imaginary = before * turned + imaginary * along;
      if (IsOutOfBounds(real))
      {
        sum += std::atan2(imaginary, real);
        real = 1.0;
        imaginary = 0.0;
      }
    }
  }
  return sum + std::atan2(imaginary, real);
}

std::complex<double> UnitOfTurns(
  const std::vector<LogSource>& logs, std::size_t count, const Point& x)
{
  std::complex<double> product = 1.0;
  int factors = 0;
  for (std::size_t m = 0; m < count; ++m)
  {
    const Point away = x - logs[m].position;
    if (away.isZero(0.0))
    {
      continue;
    }
    const std::complex<double> turn(away.x(), logs[m].strength < 0.0 ? -away.y() : away.y());
    for (int k = static_cast<int>(std::abs(logs[m].strength)); k > 0; --k)
    {
      product *= turn;
      const double square = std::norm(product);
      if (++factors == MaximumFactors || IsOutOfBounds(square))
      {
        product /= std::sqrt(square);
        factors = 0;
      }
    }
  }
  return product / std::sqrt(std::norm(product));
}

double LogIntegral(const Point& from, const Point& to, const Point& centre)
{
  const double length = (to - from).norm();
  const Point tangent = (to - from) / length;
  const Point start = from - centre;
  const Point end = to - centre;
  const auto sLogR = [&tangent](const Point& x)
  { return x.isZero(0.0) ? 0.0 : x.dot(tangent) * std::log(x.norm()); };
  const double angle = start.isZero(0.0) || end.isZero(0.0) ? 0.0 : AngleBetween(start, end);
  return sLogR(end) - sLogR(start) - length + Cross(start, tangent) * angle;
}

double LogIntegral(const std::vector<std::array<Point, 2>>& boundary, const Point& centre)
{
  double integral = 0.0;
  for (const auto& [from, to] : boundary)
  {
    // The outward normal is the tangent rotated by −90°, so (x − centre) · ν is constant along the
    // edge.
    const double length = (to - from).norm();
    const double height = Cross(from - centre, to - from) / length;
    integral += 0.5 * height * (LogIntegral(from, to, centre) - 0.5 * length);
  }
  return integral;
}
}
