#include "UnwantedSingularities.h"

#include <algorithm>
#include <cstdlib>

namespace crossfield
{
namespace
{
/// Indices found near a position at which a certain sum of quarter indices is expected.
struct Found
{
  int sum = 0;
  int size = 0; ///< Σ |k|.
};

/// Returns the distance from the centre of an imprinted circle within which singularities belong to
/// it: its radius plus one edge, which is the accuracy of a singularity's position.
double ReachOf(const BoundaryLoop& circle, const Point& centre, const PlanarTopology& topology)
{
  double reach = 0.0;
  for (const int edge : circle.edges)
  {
    const auto& [from, to] = topology.mesh.imprinted[edge].vertices;
    const Point& start = topology.PointAt(from);
    reach = std::max(reach, (start - centre).norm() + (topology.PointAt(to) - start).norm());
  }
  return reach;
}
}

int CountUnwanted(
  const CrossField& field, const FieldIndices& indices, const WantedSingularities& wanted)
{
  const PlanarTopology& topology = *field.topology;
  std::vector<Point> centres;
  std::vector<double> reaches;
  for (const BoundaryLoop& circle :
    wanted.inCircles ? topology.imprinted : std::vector<BoundaryLoop>())
  {
    centres.push_back(CentreOf(circle, topology.mesh));
    reaches.push_back(ReachOf(circle, centres.back(), topology));
  }
  std::vector<Found> inCircles(centres.size());
  std::vector<int> atPoints(wanted.points.size(), 0);
  int elsewhere = 0;

  FieldSingularityOptions options;
  options.chosenVertices = wanted.chosenVertices;
  for (const FieldSingularity& singularity : FindFieldSingularities(field, indices, options))
  {
    const auto within = [&singularity](const Point& place, double reach)
    { return (singularity.position - place).norm() <= reach; };
    std::size_t circle = 0;
    while (circle < centres.size() && !within(centres[circle], reaches[circle]))
    {
      ++circle;
    }
    if (circle < centres.size())
    {
      inCircles[circle].sum += singularity.quarterIndex;
      inCircles[circle].size += std::abs(singularity.quarterIndex);
      continue;
    }
    const double resolution = 2.0 * singularity.edge;
    const auto point = std::find_if(wanted.points.begin(), wanted.points.end(),
      [&](const Singularity& other) { return within(other.position, resolution); });
    if (point != wanted.points.end())
    {
      atPoints[point - wanted.points.begin()] += singularity.quarterIndex;
      continue;
    }
    const bool chosen = std::any_of(wanted.chosenVertices.begin(), wanted.chosenVertices.end(),
      [&](int vertex) { return within(topology.PointAt(vertex), resolution); });
    elsewhere += chosen ? 0 : std::abs(singularity.quarterIndex);
  }

  int unwanted = std::max(0, elsewhere - std::abs(wanted.anywhere));
  for (std::size_t i = 0; i < inCircles.size(); ++i)
  {
    const int prescribed = topology.imprinted[i].quarterIndex;
    unwanted += inCircles[i].size - (inCircles[i].sum == prescribed ? std::abs(prescribed) : 0);
  }
  for (std::size_t i = 0; i < atPoints.size(); ++i)
  {
    unwanted += std::abs(atPoints[i] - wanted.points[i].quarterIndex);
  }
  return unwanted;
}
}
