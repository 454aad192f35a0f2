#include "QuadQuality.h"

#include "Index.h"
#include "Parts.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace crossfield
{
namespace
{
/// Returns the place of a corner in the plane, on a surface in that of the diagonals of the quad, whose normal
/// points to the same side as that of the surface.
Point At(const QuadMesh& mesh, std::size_t quad, std::size_t corner)
{
  const auto place = [&](std::size_t i) -> const SpacePoint&
  { return mesh.points[mesh.quads[quad][i % 4]].place; };
  if (mesh.normals.empty())
  {
    return place(corner).head<2>();
  }
  const SpacePoint diagonal = place(2) - place(0);
  const SpacePoint own = diagonal.cross(place(3) - place(1));
  const SpacePoint normal = own.dot(mesh.normals[quad]) < 0.0 ? -own : own;
  const SpacePoint axis = diagonal.normalized();
  const SpacePoint offset = place(corner) - place(0);
  return { offset.dot(axis), offset.dot(normal.normalized().cross(axis)) };
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

/// Returns the angle that the quads at each point have together, 0 at points that slide along the
/// boundary.
std::vector<double> AnglesForQuads(const QuadMesh& mesh)
{
  std::vector<double> angles(mesh.points.size(), 0.0);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    angles[p] = mesh.points[p].curve.loop < 0 ? 2.0 * Pi : 0.0;
  }
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      const int p = mesh.quads[q][c];
      if (IsCorner(mesh.points[p]))
      {
        angles[p] += std::abs(
          AngleBetween(At(mesh, q, c + 1) - At(mesh, q, c), At(mesh, q, c + 3) - At(mesh, q, c)));
      }
    }
  }
  return angles;
}

/// Returns the attainable scaled Jacobian at a point with an angle for its quads.
double AttainableAt(const QuadPoint& point, double angle)
{
  return IsCorner(point) || point.curve.loop < 0 ? std::sin(std::min(Pi, angle / point.valence))
                                                 : 1.0;
}

/// Returns the sine of the angle of a quad at one of its corners, 0 if a side has no length.
double SineAt(const QuadMesh& mesh, std::size_t quad, std::size_t corner)
{
  const Point next = At(mesh, quad, corner + 1) - At(mesh, quad, corner);
  const Point previous = At(mesh, quad, corner + 3) - At(mesh, quad, corner);
  const double lengths = next.norm() * previous.norm();
  return lengths > 0.0 ? Cross(next, previous) / lengths : 0.0;
}
}

double ScaledJacobian(const QuadMesh& mesh, std::size_t quad)
{
  double minimum = 1.0;
  for (std::size_t c = 0; c < 4; ++c)
  {
    minimum = std::min(minimum, SineAt(mesh, quad, c));
  }
  return minimum;
}

double AttainableJacobian(const QuadMesh& mesh)
{
  const std::vector<double> angles = AnglesForQuads(mesh);
  double bound = 1.0;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    bound = std::min(bound, AttainableAt(mesh.points[p], angles[p]));
  }
  return bound;
}

QuadQuality MeasureQuads(const QuadMesh& mesh, double size)
{
  QuadQuality quality;
  const std::size_t count = mesh.quads.size();
  std::vector<double> eta(count);
  std::vector<double> sizes(count);
  std::vector<double> minimumAngles(count);
  quality.scaledJacobian.resize(count);
  quality.sizeRatio.resize(count);
  ForRanges(static_cast<std::ptrdiff_t>(count),
    [&](int begin, int end)
    {
      for (std::size_t q = Index(begin); q < Index(end); ++q)
      {
        quality.scaledJacobian[q] = ScaledJacobian(mesh, q);
        const QuadAngles angles = AnglesOf(mesh, q);
        eta[q] = angles.eta;
        minimumAngles[q] = angles.minimum;
        sizes[q] = std::sqrt(std::max(0.0, Area(mesh, q)));
        double scale = 0.0;
        for (const int point : mesh.quads[q])
        {
          scale += 0.25 * mesh.points[point].scale;
        }
        quality.sizeRatio[q] = sizes[q] / (size * scale);
      }
    });
  quality.inverted = static_cast<int>(std::count_if(quality.scaledJacobian.begin(),
    quality.scaledJacobian.end(), [](double jacobian) { return !(jacobian > 0.0); }));
  if (count > 0)
  {
    quality.minimumAngle = *std::min_element(minimumAngles.begin(), minimumAngles.end());
    const auto worst =
      std::min_element(quality.scaledJacobian.begin(), quality.scaledJacobian.end());
    quality.where = SpacePoint::Zero();
    for (const int point : mesh.quads[worst - quality.scaledJacobian.begin()])
    {
      quality.where += 0.25 * mesh.points[point].place;
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

std::string DescribeWorstQuad(const QuadMesh& mesh, const QuadQuality& quality)
{
  // Below, solvers fail, or elements are far from what is possible with these irregular nodes.
  constexpr double MinimumJacobian = 0.05;
  constexpr double MinimumFraction = 0.2;
  if (mesh.quads.empty() || quality.inverted > 0 ||
    quality.jacobian.min >= std::max(MinimumJacobian, MinimumFraction * quality.bound))
  {
    return "";
  }
  const auto worst = static_cast<std::size_t>(
    std::min_element(quality.scaledJacobian.begin(), quality.scaledJacobian.end()) -
    quality.scaledJacobian.begin());
  std::size_t corner = 0;
  for (std::size_t c = 1; c < 4; ++c)
  {
    corner = SineAt(mesh, worst, c) < SineAt(mesh, worst, corner) ? c : corner;
  }
  std::ostringstream text;
  text.precision(2);
  text << "The worst quad, near " << DescribePlace(quality.where) << ", has a scaled Jacobian of "
       << quality.jacobian.min;
  const std::size_t p = Index(mesh.quads[worst][corner]);
  const QuadPoint& point = mesh.points[p];
  const double angle = AnglesForQuads(mesh)[p];
  if (AttainableAt(point, angle) >= MinimumJacobian)
  {
    text << ", where " << quality.bound << " is attainable.";
  }
  else if (point.curve.loop < 0)
  {
    text << ", where a node of valence " << point.valence
         << " leaves no other angle; give singularities of quarter index 1 in place of this one.";
  }
  else
  {
    const double degrees = angle * 180.0 / Pi;
    text << ", where the boundary has an angle of " << std::fixed << std::setprecision(0) << degrees
         << "° for " << point.valence << (point.valence == 1 ? " quad; " : " quads; ")
         << (degrees < 90.0 * point.valence ? "cut off the sharp corner."
                                            : "give a smaller quarter index there.");
  }
  return text.str();
}
}
