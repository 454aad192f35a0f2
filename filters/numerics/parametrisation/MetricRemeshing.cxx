#include "MetricRemeshing.h"

#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
using Side = ConeMetric::Side;

/// Largest angle of a corner that a vertex should need, radians. With fewer triangles an angle of π
/// has to fit into one, which then degenerates.
constexpr double LargestCorner = 2.3;

/// Two angles opposite to an edge that exceed π by this are worth a flip, radians.
constexpr double FlipExcess = 0.25;
/// Angle that is worth a split, 144° in radians.
constexpr double SplitAngle = 0.8 * Pi;
/// Range of the fraction of an edge at which it is divided.
constexpr double SmallestFraction = 0.2;
/// Least angle of new triangles on the surface, radians.
constexpr double LeastNewAngle = 0.06;
/// Largest sine of the angle between the normals of triangles that lie in one plane: rounding.
constexpr double Flat = 1e-9;

std::vector<int> CountTriangles(const ConeMetric& metric)
{
  std::vector<int> counts(metric.Points().size(), 0);
  for (const ConeMetric::Triangle& triangle : metric.Triangles())
  {
    for (const int v : triangle.vertices)
    {
      ++counts[v];
    }
  }
  return counts;
}

/// Returns whether a vertex can have the angle that it should have with this number of triangles.
bool IsEnough(const ConeMetric& metric, int vertex, int triangles)
{
  return triangles * LargestCorner >= 0.5 * Pi * metric.QuartersAt(vertex);
}

/// Returns the minimum angle of a triangle in a plane with a unit normal; negative if it is reversed.
double LeastAngle(
  const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& normal)
{
  const auto angle = [&normal](const SpacePoint& from, const SpacePoint& to)
  { return std::atan2(from.cross(to).dot(normal), from.dot(to)); };
  return std::min({ angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c) });
}

/// Returns whether the edge of a side should and can be flipped.
bool ShouldFlip(const ConeMetric& metric, const std::vector<int>& counts, Side side)
{
  const Side across = metric.Across(side);
  const auto& one = metric.AnglesOf(side.triangle).angle;
  const auto& two = metric.AnglesOf(across.triangle).angle;
  const auto s = Index(side.side);
  const auto r = Index(across.side);
  if (!(one[(s + 2) % 3] + two[(r + 2) % 3] > Pi + FlipExcess))
  {
    return false;
  }
  const auto& v = metric.Triangles()[side.triangle].vertices;
  const auto& w = metric.Triangles()[across.triangle].vertices;
  const int a = v[s];
  const int b = v[(s + 1) % 3];
  if (!IsEnough(metric, a, counts[a] - 1) || !IsEnough(metric, b, counts[b] - 1))
  {
    return false;
  }
  // Convex in the metric.
  const double atA = one[s] + two[(r + 1) % 3];
  const double atB = one[(s + 1) % 3] + two[r];
  if (!(std::max(atA, atB) < Pi))
  {
    return false;
  }
  const auto& points = metric.Points();
  const SpacePoint& p = points[v[(s + 2) % 3]];
  const SpacePoint& q = points[w[(r + 2) % 3]];
  const SpacePoint along = points[b] - points[a];
  const SpacePoint normal = along.cross(p - points[a]).normalized();
  if (!(normal.cross((q - points[a]).cross(along).normalized()).norm() <= Flat) ||
    !(std::min(LeastAngle(p, q, points[b], normal), LeastAngle(q, p, points[a], normal)) >=
      LeastNewAngle))
  {
    return false;
  }
  const auto largest = [](const std::array<double, 3>& angles)
  { return *std::max_element(angles.begin(), angles.end()); };
  const double diagonal = metric.LogOtherDiagonal(side);
  const auto logOf = [&metric](const Side& edge, std::size_t offset)
  {
    const auto& edges = metric.Triangles()[edge.triangle].edges;
    return metric.LogLengths()[edges[(Index(edge.side) + offset) % 3]];
  };
  // Triangles (p, q, b) and (q, p, a).
  const double after =
    std::max(largest(AnglesFromLogLengths({ diagonal, logOf(across, 2), logOf(side, 1) }).angle),
      largest(AnglesFromLogLengths({ diagonal, logOf(side, 2), logOf(across, 1) }).angle));
  return after < std::max(largest(one), largest(two));
}

/// Flips edges until none should be flipped, or a limit that is far above what is needed.
int FlipEdges(ConeMetric& metric, std::vector<int>& counts)
{
  constexpr int MaximumPasses = 20;
  int flips = 0;
  for (int pass = 0, before = -1; pass < MaximumPasses && before != flips; ++pass)
  {
    before = flips;
    for (int t = 0; t < static_cast<int>(metric.Triangles().size()); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        if (metric.Triangles()[t].neighbours[i] < 0 || !ShouldFlip(metric, counts, { t, i }))
        {
          continue;
        }
        const auto old = metric.Triangles()[t].vertices;
        --counts[old[i]];
        --counts[old[NextSide(i)]];
        metric.Flip({ t, i });
        // Vertices 0 and 1 are those of the new edge.
        ++counts[metric.Triangles()[t].vertices[0]];
        ++counts[metric.Triangles()[t].vertices[1]];
        ++flips;
        break;
      }
    }
  }
  return flips;
}

/// Divides the side opposite to every angle above the limit at the foot of its altitude.
int SplitSides(ConeMetric& metric, int maximum)
{
  int splits = 0;
  const auto triangles = static_cast<int>(metric.Triangles().size());
  for (int t = 0; t < triangles && splits < maximum; ++t)
  {
    const MetricAngles angles = metric.AnglesOf(t);
    const auto largest = std::max_element(angles.angle.begin(), angles.angle.end());
    if (*largest > SplitAngle)
    {
      const int side = NextSide(static_cast<int>(largest - angles.angle.begin()));
      // The foot divides the side in proportion to the cotangents at its ends.
      const double first = angles.cotangent[side];
      const double second = angles.cotangent[NextSide(side)];
      metric.Split({ t, side },
        std::clamp(first / (first + second), SmallestFraction, 1.0 - SmallestFraction));
      ++splits;
    }
  }
  return splits;
}
}

RemeshingCount SplitNarrowFans(ConeMetric& metric)
{
  RemeshingCount count;
  std::vector<int> counts = CountTriangles(metric);
  for (int v = 0; v < static_cast<int>(counts.size()); ++v)
  {
    while (!IsEnough(metric, v, counts[v]))
    {
      Side widest;
      double angle = -1.0;
      for (int t = 0; t < static_cast<int>(metric.Triangles().size()); ++t)
      {
        const auto& vertices = metric.Triangles()[t].vertices;
        const auto found = std::find(vertices.begin(), vertices.end(), v);
        if (found != vertices.end())
        {
          const int corner = static_cast<int>(found - vertices.begin());
          const double here = metric.AngleOnSurface(t, corner);
          if (here > angle)
          {
            angle = here;
            widest = { t, NextSide(corner) };
          }
        }
      }
      metric.Split(widest, 0.5);
      ++counts[v];
      ++count.splits;
    }
  }
  return count;
}

RemeshingCount ImproveTriangles(ConeMetric& metric, int maximumSplits)
{
  RemeshingCount count;
  std::vector<int> counts = CountTriangles(metric);
  count.flips = FlipEdges(metric, counts);
  count.splits = SplitSides(metric, maximumSplits);
  return count;
}
}
