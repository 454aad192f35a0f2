#include "QuadQuality.h"

#include "Index.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
const Point& At(const QuadMesh& mesh, std::size_t quad, std::size_t corner)
{
  return mesh.points[Index(mesh.quads[quad][corner % 4])].place;
}

Range RangeOf(const std::vector<double>& values)
{
  Range range;
  if (values.empty())
  {
    return range;
  }
  range.min = values.front();
  range.max = values.front();
  for (const double value : values)
  {
    range.min = std::min(range.min, value);
    range.max = std::max(range.max, value);
    range.mean += value / static_cast<double>(values.size());
  }
  return range;
}

struct QuadAngles
{
  double eta = 1.0;
  double minimum = 0.0;
};

QuadAngles AnglesOf(const QuadMesh& mesh, std::size_t quad)
{
  // At a convex corner the sine of |π/2 − angle| is |cos angle|, so one arc sine of the largest
  // suffices.
  double largestCosine = 0.0;
  double worst = 0.0;
  double cosineOfMinimum = -1.0;
  double minimumElsewhere = 2.0 * Pi;
  for (std::size_t c = 0; c < 4; ++c)
  {
    const Point next = At(mesh, quad, c + 1) - At(mesh, quad, c);
    const Point previous = At(mesh, quad, c + 3) - At(mesh, quad, c);
    if (Cross(next, previous) > 0.0)
    {
      const double cosine =
        next.dot(previous) / std::sqrt(next.squaredNorm() * previous.squaredNorm());
      largestCosine = std::max(largestCosine, std::abs(cosine));
      cosineOfMinimum = std::max(cosineOfMinimum, cosine);
      continue;
    }
    const double signedAngle = AngleBetween(next, previous);
    const double angle = signedAngle < 0.0 ? signedAngle + 2.0 * Pi : signedAngle;
    worst = std::max(worst, std::abs(0.5 * Pi - angle));
    minimumElsewhere = std::min(minimumElsewhere, angle);
  }
  return { 1.0 - 2.0 / Pi * std::max(worst, std::asin(std::min(1.0, largestCosine))),
    std::min(minimumElsewhere, std::acos(std::min(1.0, cosineOfMinimum))) };
}

double Area(const QuadMesh& mesh, std::size_t quad)
{
  return 0.5 * Cross(At(mesh, quad, 2) - At(mesh, quad, 0), At(mesh, quad, 3) - At(mesh, quad, 1));
}

bool IsCorner(const QuadPoint& point)
{
  return point.curve.loop >= 0 && point.fixed;
}

}

double ScaledJacobian(const QuadMesh& mesh, std::size_t quad)
{
  double minimum = 1.0;
  for (std::size_t c = 0; c < 4; ++c)
  {
    const Point next = At(mesh, quad, c + 1) - At(mesh, quad, c);
    const Point previous = At(mesh, quad, c + 3) - At(mesh, quad, c);
    const double lengths = next.norm() * previous.norm();
    minimum = std::min(minimum, lengths > 0.0 ? Cross(next, previous) / lengths : 0.0);
  }
  return minimum;
}

double AttainableJacobian(const QuadMesh& mesh)
{
  double bound = 1.0;
  std::vector<double> angles(mesh.points.size(), 0.0);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      const int p = mesh.quads[q][c];
      if (IsCorner(mesh.points[Index(p)]))
      {
        angles[Index(p)] += std::abs(
          AngleBetween(At(mesh, q, c + 1) - At(mesh, q, c), At(mesh, q, c + 3) - At(mesh, q, c)));
      }
    }
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const QuadPoint& point = mesh.points[p];
    const bool corner = IsCorner(point);
    if (corner || point.curve.loop < 0)
    {
      const double around = corner ? angles[p] : 2.0 * Pi;
      bound = std::min(bound, std::sin(std::min(Pi, around / point.valence)));
    }
  }
  return bound;
}

QuadQuality MeasureQuads(const QuadMesh& mesh, double size)
{
  QuadQuality quality;
  std::vector<double> eta;
  std::vector<double> sizes;
  double worst = 2.0;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    const double jacobian = ScaledJacobian(mesh, q);
    quality.scaledJacobian.push_back(jacobian);
    const QuadAngles angles = AnglesOf(mesh, q);
    eta.push_back(angles.eta);
    quality.minimumAngle = q == 0 ? angles.minimum : std::min(quality.minimumAngle, angles.minimum);
    sizes.push_back(std::sqrt(std::max(0.0, Area(mesh, q))));
    double scale = 0.0;
    Point centre = Point::Zero();
    for (const int point : mesh.quads[q])
    {
      scale += 0.25 * mesh.points[Index(point)].scale;
      centre += 0.25 * mesh.points[Index(point)].place;
    }
    quality.sizeRatio.push_back(sizes.back() / (size * scale));
    quality.inverted += jacobian > 0.0 ? 0 : 1;
    if (jacobian < worst)
    {
      worst = jacobian;
      quality.where = centre;
    }
  }
  quality.jacobian = RangeOf(quality.scaledJacobian);
  quality.eta = RangeOf(eta);
  quality.size = RangeOf(sizes);
  double squares = 0.0;
  for (const double value : sizes)
  {
    squares += (value - quality.size.mean) * (value - quality.size.mean);
  }
  quality.variation = sizes.empty()
    ? 0.0
    : std::sqrt(squares / static_cast<double>(sizes.size())) / quality.size.mean;
  quality.bound = AttainableJacobian(mesh);
  return quality;
}
}
