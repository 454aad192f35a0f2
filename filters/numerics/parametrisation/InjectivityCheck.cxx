#include "InjectivityCheck.h"

#include <cmath>

namespace crossfield
{
std::string DescribeFault(const MapFault& fault)
{
  const auto degrees = [](double radians)
  { return std::to_string(static_cast<int>(std::round(radians * 180.0 / Pi))) + "°"; };
  return fault.reversed > 0 ? "The seamless map folds over in " + std::to_string(fault.reversed) +
      " triangles, the first near " + fault.where
                            : "The angles of the seamless map at " + fault.where + " add up to " +
      degrees(fault.angleSum) + " instead of " + degrees(fault.expectedSum);
}

std::optional<MapFault> FindFault(const SeamlessMap& map)
{
  const MeshTopology& topology = *map.topology;
  MapFault fault;
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(topology.VertexCount());
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const Point& a = map.At(t, 0);
    const Point& b = map.At(t, 1);
    const Point& c = map.At(t, 2);
    const auto& v = topology.mesh.triangles[t];
    if (!(Cross(b - a, c - a) > 0.0))
    {
      fault.where = fault.reversed == 0 ? topology.Where(v[0]) : fault.where;
      ++fault.reversed;
    }
    angles[v[0]] += AngleBetween(b - a, c - a);
    angles[v[1]] += AngleBetween(c - b, a - b);
    angles[v[2]] += AngleBetween(a - c, b - c);
  }
  if (fault.reversed > 0)
  {
    return fault;
  }
  std::vector<int> quarters(static_cast<std::size_t>(topology.VertexCount()), 4);
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    quarters[edge.vertices[0]] = 2;
  }
  for (const Cone& cone : map.cones)
  {
    quarters[cone.vertex] = cone.Quarters();
  }
  for (int v = 0; v < static_cast<int>(quarters.size()); ++v)
  {
    const double expected = 0.5 * Pi * quarters[v];
    // Seams and sides allow multiples of a quarter turn only; smaller differences are rounding.
    if (angles[v] > 0.0 && std::abs(angles[v] - expected) > 0.25 * Pi)
    {
      return MapFault{ 0, topology.Where(v), angles[v], expected };
    }
  }
  return std::nullopt;
}
}
