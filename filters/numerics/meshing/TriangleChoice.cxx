#include "TriangleChoice.h"

#include "DomainQueries.h"
#include "Error.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <string>

namespace crossfield
{
namespace
{
using EdgeEnds = std::array<int, 2>;

EdgeEnds Sorted(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

std::string Name(std::size_t row, const Singularity& singularity)
{
  return "singularity " + std::to_string(row + 1) + " at " + Describe(singularity.position);
}

/// Returns the minimum distance of a point to the sides of a triangle, negative outside.
double Depth(const TriangleMesh& mesh, const std::array<int, 3>& triangle, const Point& point)
{
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point& from = mesh.points[triangle[i]];
    const Point along = mesh.points[triangle[(i + 1) % 3]] - from;
    depth = std::min(depth, Cross(along, point - from) / along.norm());
  }
  return depth;
}

void CheckPoint(const PlanarDomain& domain, std::size_t row, const Singularity& singularity)
{
  if (!singularity.position.allFinite())
  {
    throw Error("Row " + std::to_string(row + 1) +
      " of the singularities has a coordinate that is not a finite number; correct it.");
  }
  if (std::abs(singularity.quarterIndex) != 1)
  {
    throw Error("The " + Name(row, singularity) + " has quarter index " +
      std::to_string(singularity.quarterIndex) +
      ", but the three edges of a triangle can carry 1 or -1 only; split it or drill a hole.");
  }
  if (SignedDistance(singularity.position, domain) < 0.0)
  {
    throw Error("The " + Name(row, singularity) + " lies outside the domain; move it inside.");
  }
}
}

void MarkTriangles(
  const PlanarDomain& domain, const Configuration& configuration, TriangleMesh& mesh)
{
  std::set<EdgeEnds> boundary;
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    boundary.insert(Sorted(edge.vertices[0], edge.vertices[1]));
  }
  std::map<EdgeEnds, std::size_t> taken;
  for (std::size_t row = 0; row < configuration.size(); ++row)
  {
    const Singularity& here = configuration[row];
    CheckPoint(domain, row, here);
    const auto nearest = std::max_element(mesh.triangles.begin(), mesh.triangles.end(),
      [&](const auto& a, const auto& b)
      { return Depth(mesh, a, here.position) < Depth(mesh, b, here.position); });
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int from = (*nearest)[i];
      const int to = (*nearest)[(i + 1) % 3];
      if (boundary.count(Sorted(from, to)) != 0)
      {
        throw Error("The triangle of " + Name(row, here) +
          " has an edge on the boundary, where the cross is prescribed; move it inward or use a "
          "smaller mesh size.");
      }
      const auto [other, isNew] = taken.emplace(Sorted(from, to), row);
      if (!isNew)
      {
        throw Error("The triangles of " + Name(other->second, configuration[other->second]) +
          " and " + Name(row, here) +
          " share an edge; move them apart or use a smaller mesh size.");
      }
      mesh.imprinted.push_back(
        { { to, from }, BoundaryKind::ImprintedCircle, static_cast<int>(row), here.quarterIndex });
    }
  }
}
}
