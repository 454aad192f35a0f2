#include "MeshBudget.h"

#include "Error.h"
#include "MemoryBudget.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace crossfield
{
namespace
{
/// Equilateral triangles with edges of length 1 per unit area.
const double TrianglesPerArea = 4.0 / std::sqrt(3.0);

/// Maximum number of triangles: the Crouzeix-Raviart matrix has five entries for each of 3/2 edges
/// per triangle, with int indices.
constexpr double MaximumTriangles = 2147483647.0 / 7.5;

/// Integral of h⁻² − maximum⁻² over a square, by the midpoint rule on a quadtree.
class Excess
{
public:
  Excess(double maximum, double gradation)
    : Maximum(maximum)
    , Gradation(gradation)
  {
  }

  double Integrate(
    const Point& centre, double halfWidth, const std::vector<SizeSource>& sources) const
  {
    const double reach = this->Gradation * std::sqrt(2.0) * halfWidth;
    const auto valueOf = [&](const SizeSource& source)
    { return source.size + this->Gradation * (centre - source.position).norm(); };
    double size = this->Maximum;
    for (const SizeSource& source : sources)
    {
      size = std::min(size, valueOf(source));
    }
    // h differs by at most `reach` between the centre and a corner. Sources with larger values have
    // no effect.
    std::vector<SizeSource> kept;
    double smallest = this->Maximum;
    for (const SizeSource& source : sources)
    {
      if (valueOf(source) <= size + 2.0 * reach && valueOf(source) - reach < this->Maximum)
      {
        kept.push_back(source);
        smallest = std::min(smallest, std::max(source.size, valueOf(source) - reach));
      }
    }
    // Stop where h is constant within a factor of two, or where the square is too small for
    // coordinates to resolve. If a source is at the centre, h has its minimum there and is larger
    // all around.
    const double largest = std::min(this->Maximum, size + reach);
    if (kept.empty() || (smallest >= 0.5 * size && largest <= 2.0 * size) ||
      halfWidth <= 1e-12 * centre.norm())
    {
      return 4.0 * halfWidth * halfWidth *
        (1.0 / (size * size) - 1.0 / (this->Maximum * this->Maximum));
    }
    double sum = 0.0;
    const double half = 0.5 * halfWidth;
    for (const Point& step :
      { Point(-half, -half), Point(half, -half), Point(-half, half), Point(half, half) })
    {
      sum += this->Integrate(centre + step, half, kept);
    }
    return sum;
  }

private:
  double Maximum;
  double Gradation;
};

Eigen::AlignedBox2d BoundingBox(const PlanarDomain& domain)
{
  Eigen::AlignedBox2d box;
  for (const Point& point : domain.loops.front())
  {
    box.extend(point);
  }
  return box;
}

/// Rounds up to two significant digits.
double RoundUp(double length)
{
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
  return std::ceil(length / unit) * unit;
}
}

double PredictTriangles(const PlanarDomain& domain, const std::vector<SizeSource>& sources,
  double maximum, double gradation)
{
  const double bulk = TrianglesPerArea * domain.Area() / (maximum * maximum);
  if (sources.empty())
  {
    return bulk;
  }
  const Eigen::AlignedBox2d box = BoundingBox(domain);
  return bulk +
    0.5 * TrianglesPerArea *
    Excess(maximum, gradation).Integrate(box.center(), 0.5 * box.sizes().maxCoeff(), sources);
}

void RequireMemoryForMesh(const PlanarDomain& domain, const std::vector<SizeSource>& sources,
  double maximum, double gradation)
{
  constexpr double Countless = 1e300; // finite even if the square of the edge length underflows
  const double bulk = std::min(Countless, PredictTriangles(domain, {}, maximum, gradation));
  const double triangles = sources.empty() || bulk == Countless
    ? bulk
    : PredictTriangles(domain, sources, maximum, gradation);
  // The lattice of points fills the box, with two triangles per point, before those outside are
  // dropped; a growing vector needs twice its size.
  const double latticeBytesPerTriangle =
    0.5 * 2.0 * sizeof(Point) * BoundingBox(domain).volume() / domain.Area();
  const double bytes = std::max(triangles * MeshBytesPerTriangle, bulk * latticeBytesPerTriangle);
  const double available = AvailableMemory().value_or(bytes);
  if (bytes <= available && triangles <= MaximumTriangles)
  {
    return;
  }
  std::ostringstream what;
  what.precision(3);
  what << "A mesh with edge length " << maximum << " would have about " << triangles
       << " triangles";
  std::ostringstream remedy;
  remedy.precision(3);
  remedy << "choose ";
  if (bulk < 0.5 * triangles)
  {
    remedy << "larger holes, longer segments of the boundary or a larger gradation";
  }
  else
  {
    const double possible = std::clamp(
      available / std::max(MeshBytesPerTriangle, latticeBytesPerTriangle), 1.0, MaximumTriangles);
    remedy << "a larger edge length, about "
           << RoundUp(std::sqrt(TrianglesPerArea * domain.Area() / possible) * triangles / bulk);
  }
  RequireMemory(bytes, what.str() + " and", remedy.str());
  if (triangles <= MaximumTriangles)
  {
    return; // memory has become available in the meantime
  }
  throw Error(
    what.str() + ", more than the 280 million that can be numbered; " + remedy.str() + ".");
}
}
