#include "SidePrescription.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the number of edges of a geometric sequence with given first and last edge, as a real
/// number: from q^(n−1) = b / a and a (qⁿ − 1) / (q − 1) = L follows q = (L − a) / (L − b).
double GeometricCount(double length, double first, double last)
{
  const double quotient = (length - first) / (length - last);
  return std::abs(quotient - 1.0) < 1e-9 ? length / first
                                         : 1.0 + std::log(last / first) / std::log(quotient);
}
/// Returns the last edge over the first.
double RatioOf(const Progression& progression)
{
  return progression.HasLengths() ? progression.last / progression.first : progression.ratio;
}
}

std::vector<double> DivideLength(double length, int count, const Progression& progression)
{
  const double ratio = RatioOf(progression);
  // Exponents of the edges, 0 at the first and 1 at the last one or, towards both ends, the middle.
  std::vector<double> edges;
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double end = std::max(1, count - 1);
    const double part = progression.both
      ? std::min(i, count - 1 - i) / std::max(1.0, std::floor(0.5 * end))
      : i / end;
    edges.push_back(std::pow(ratio, part));
    sum += edges.back();
  }
  std::vector<double> places = { 0.0 };
  for (const double edge : edges)
  {
    places.push_back(places.back() + edge * length / sum);
  }
  places.back() = length;
  return places;
}

double EdgesWithin(double part, double length, double count, const Progression& progression)
{
  if (progression.both && part > 0.5 * length)
  {
    return count - EdgesWithin(length - part, length, count, progression);
  }
  const double within = progression.both ? 0.5 * length : length;
  const double edges = progression.both ? 0.5 * count : count;
  const double ratio = RatioOf(progression);
  if (edges < 2.0 || std::abs(ratio - 1.0) < 1e-9)
  {
    return count * part / length;
  }
  // with quotient q and first edge a, i edges have the length a (q^i − 1) / (q − 1)
  const double growth = std::log(ratio) / (edges - 1.0);
  return std::log1p(part / within * std::expm1(growth * edges)) / growth;
}

int CountForLengths(double length, const Progression& progression)
{
  const double count = progression.both
    ? 2.0 * GeometricCount(0.5 * length, progression.first, progression.last)
    : GeometricCount(length, progression.first, progression.last);
  return std::max(1, static_cast<int>(std::lround(count)));
}
}
