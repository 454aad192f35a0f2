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
const double TrianglesPerArea = 4.0 / std::sqrt(3.0); ///< For edges of length 1.

/// The Crouzeix-Raviart matrix has five entries for each of 3/2 edges per triangle, with int indices.
constexpr double MostTriangles = 2147483647.0 / 7.5;

/// ∫ (h⁻² − maximum⁻²) over a square, by the midpoint rule on a quadtree.
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
    // h changes by at most `reach` between the centre and a corner. Further sources do not matter.
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
    // Within a factor of two h is constant; below the rounding of coordinates it cannot be told. It is least in
    // the middle where a source is there, and then larger all around.
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

/// Two digits, rounded up.
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
  constexpr double Countless = 1e300; // finite, where the square of the edge length is not
  const double bulk = std::min(Countless, PredictTriangles(domain, {}, maximum, gradation));
  const double triangles = sources.empty() || bulk == Countless
    ? bulk
    : PredictTriangles(domain, sources, maximum, gradation);
  // The lattice of points fills the box, two triangles to a point, before those outside are dropped;
  // a vector that grows takes twice its size.
  const double latticeBytesPerTriangle =
    0.5 * 2.0 * sizeof(Point) * BoundingBox(domain).volume() / domain.Area();
  const double bytes = std::max(triangles * MeshBytesPerTriangle, bulk * latticeBytesPerTriangle);
  const double available = AvailableMemory().value_or(bytes);
  if (bytes <= available && triangles <= MostTriangles)
  {
    return;
  }
  std::ostringstream what;
  what.precision(3);
  what << "A mesh with edge length " << maximum << " would have about " << triangles
       << " triangles";
  std::ostringstream mend;
  mend.precision(3);
  mend << "choose ";
  if (bulk < 0.5 * triangles)
  {
    mend << "larger holes, longer segments of the boundary or a larger gradation";
  }
  else
  {
    const double possible = std::clamp(
      available / std::max(MeshBytesPerTriangle, latticeBytesPerTriangle), 1.0, MostTriangles);
    mend << "a larger edge length, about "
         << RoundUp(std::sqrt(TrianglesPerArea * domain.Area() / possible) * triangles / bulk);
  }
  RequireMemory(bytes, what.str() + " and", mend.str());
  if (triangles <= MostTriangles)
  {
    return; // memory has become free meanwhile
  }
  throw Error(what.str() + ", more than the 280 million that can be numbered; " + mend.str() + ".");
}
}
