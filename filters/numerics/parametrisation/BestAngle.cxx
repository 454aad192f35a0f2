#include "BestAngle.h"

#include "ConeVectors.h"
#include "TriangleBending.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>

namespace crossfield
{
namespace
{
using Complex = std::complex<double>;

/// Returns the mean of e^{4i(direction of curvature − direction of crosses)}, by how much curvatures differ: its
/// argument is four times the angle by which crosses are to turn, and its absolute value, at most 1, is small
/// on a sphere.
Complex PrincipalFit(const SeamlessMap& map)
{
  Complex sum = 0.0;
  double weights = 0.0;
  for (int t = 0; t < map.topology->TriangleCount(); ++t)
  {
    const TriangleBending bending = BendingOf(*map.topology, t);
    const double area = map.topology->AreaOf(t);
    const double strength = std::abs(bending.directed);
    if (strength > 0.0)
    {
      sum += area / strength * bending.directed * bending.directed * std::conj(CrossOf(map, t));
    }
    weights += area * bending.absolute;
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

/// Returns an angle modulo π/2 in (−π/4, π/4].
double WrapQuarter(double angle)
{
  return 0.25 * WrapAngle(4.0 * angle);
}

/// A direction of vectors between singularities, with the sum of the inverses of their lengths.
struct Vote
{
  double angle;
  double weight;
};

/// Returns the directions of vectors; those that only rounding distinguishes are joined.
std::vector<Vote> CollectVotes(const std::vector<Point>& vectors)
{
  std::vector<Vote> votes;
  for (const Point& vector : vectors)
  {
    votes.push_back({ WrapQuarter(std::atan2(vector.y(), vector.x())), 1.0 / vector.norm() });
  }
  std::sort(
    votes.begin(), votes.end(), [](const Vote& a, const Vote& b) { return a.angle < b.angle; });
  std::vector<Vote> joined;
  for (const Vote& vote : votes)
  {
    if (!joined.empty() && vote.angle - joined.back().angle < AngleRounding)
    {
      joined.back().weight += vote.weight;
    }
    else
    {
      joined.push_back(vote);
    }
  }
  return joined;
}
}

std::complex<double> CrossOf(const SeamlessMap& map, int triangle)
{
  const auto complex = [](const Point& point) { return Complex(point.x(), point.y()); };
  const MeshTopology& topology = *map.topology;
  Eigen::Matrix2d from;
  Eigen::Matrix2d to;
  from << topology.At(triangle, 1) - topology.At(triangle, 0),
    topology.At(triangle, 2) - topology.At(triangle, 0);
  to << map.At(triangle, 1) - map.At(triangle, 0), map.At(triangle, 2) - map.At(triangle, 0);
  const Eigen::Matrix2d gradient = to * from.inverse();
  const Complex derivative =
    0.5 * (complex(gradient.col(0)) - Complex(0.0, 1.0) * complex(gradient.col(1)));
  const double length = std::abs(derivative);
  const Complex square = derivative * derivative / (length * length);
  return length > 0.0 ? std::conj(square * square) : Complex(0.0);
}

double BestAngle(const SeamlessMap& map)
{
  // Separatrices that miss a singularity by a smaller angle bound thin strips of blocks.
  constexpr double Near = 0.05;
  const Complex fit = PrincipalFit(map);
  const std::vector<Vote> votes = CollectVotes(VectorsBetweenCones(map));
  double best = 0.25 * std::arg(fit);
  double highest = 0.0;
  for (const Vote& one : votes)
  {
    double weight = 0.0;
    for (const Vote& other : votes)
    {
      weight +=
        other.weight * std::max(0.0, 1.0 - std::abs(WrapQuarter(one.angle - other.angle)) / Near);
    }
    const double score = weight * (1.0 + (fit * std::polar(1.0, -4.0 * one.angle)).real());
    // Equal ones differ by rounding, and the first of them is as good as others.
    constexpr double Equal = 1e-9;
    if (score > (1.0 + Equal) * highest)
    {
      highest = score;
      best = one.angle;
    }
  }
  return best;
}
}
