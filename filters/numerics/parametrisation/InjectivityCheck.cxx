#include "InjectivityCheck.h"

#include "Error.h"

#include <cmath>
#include <string>

namespace crossfield
{
namespace
{
/// Returns the remedy for a map that is not injective.
std::string Remedy(const SeamlessMap& map)
{
  std::size_t worst = 0;
  for (std::size_t k = 1; k < map.holonomyDefect.size(); ++k)
  {
    if (std::abs(map.holonomyDefect[k]) > std::abs(map.holonomyDefect[worst]))
    {
      worst = k;
    }
  }
  // Radians of the phase, 0.05 of θ: smaller defects do not invert triangles.
  constexpr double Harmless = 0.2;
  if (!map.holonomyDefect.empty() && std::abs(map.holonomyDefect[worst]) > Harmless)
  {
    return "inner loop " + std::to_string(worst + 1) + " has a holonomy defect of " +
      std::to_string(0.25 * map.holonomyDefect[worst]) +
      " radians of the cross, repair the holonomy (RepairHolonomy, --repair-holonomy): it moves "
      "the singularities.";
  }
  return "use a finer mesh, smooth the boundary if it has a thin tip there, or move singularities "
         "away from each other and from the boundary.";
}
}

void RequireInjective(const SeamlessMap& map)
{
  const MeshTopology& topology = *map.topology;
  const auto triangles = static_cast<int>(map.corners.size());
  int flipped = 0;
  Point location = Point::Zero();
  Eigen::VectorXd angles =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(topology.mesh.points.size()));
  for (int t = 0; t < triangles; ++t)
  {
    const Point& a = map.At(t, 0);
    const Point& b = map.At(t, 1);
    const Point& c = map.At(t, 2);
    const auto& v = topology.mesh.triangles[static_cast<std::size_t>(t)];
    if (!(Cross(b - a, c - a) > 0.0))
    {
      location = flipped == 0 ? topology.PointAt(v[0]) : location;
      ++flipped;
    }
    angles[v[0]] += AngleBetween(b - a, c - a);
    angles[v[1]] += AngleBetween(c - b, a - b);
    angles[v[2]] += AngleBetween(a - c, b - c);
  }
  if (flipped > 0)
  {
    throw Error("The seamless map folds over in " + std::to_string(flipped) +
      " triangles, the first near " + Describe(location) + "; " + Remedy(map));
  }
  std::vector<int> quarters(topology.mesh.points.size(), 4);
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    quarters[static_cast<std::size_t>(edge.vertices[0])] = 2;
  }
  for (const Cone& cone : map.cones)
  {
    quarters[static_cast<std::size_t>(cone.vertex)] = cone.Quarters();
  }
  for (int v = 0; v < static_cast<int>(quarters.size()); ++v)
  {
    const double expected = 0.5 * Pi * quarters[static_cast<std::size_t>(v)];
    // Seams and sides allow multiples of a quarter turn only; smaller differences are rounding.
    if (angles[v] > 0.0 && std::abs(angles[v] - expected) > 0.25 * Pi)
    {
      throw Error("The angles of the seamless map at " + Describe(topology.PointAt(v)) +
        " add up to " + std::to_string(angles[v]) + " instead of " + std::to_string(expected) +
        "; " + Remedy(map));
    }
  }
}
}
