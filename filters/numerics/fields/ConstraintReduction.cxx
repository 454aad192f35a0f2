#include "ConstraintReduction.h"

#include <numeric>
#include <utility>

namespace crossfield
{
DegreeConstraint ConstrainLoop(const PlanarTopology& topology, const BoundaryLoop& loop, int first)
{
  std::vector<int> unknowns(loop.edges.size());
  std::iota(unknowns.begin(), unknowns.end(), first);
  std::vector<Point> midpoints;
  for (const int edge : EdgesOf(loop, topology.edges))
  {
    midpoints.push_back(topology.Midpoint(edge));
  }
  return MakeDegreeConstraint(
    std::move(unknowns), midpoints, CentreOf(loop, topology.mesh), loop.quarterIndex);
}
}
