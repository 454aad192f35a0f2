#include "VertexFan.h"

#include "CoarseMeshError.h"
#include "Index.h"

#include <algorithm>
#include <string>

namespace crossfield
{
namespace
{
/// Returns the angle of a direction in eighths of a turn: 2q on the axis i^q, 2q + 1 between that
/// and the next axis.
int Eighths(const Point& direction)
{
  const double x = direction.x();
  const double y = direction.y();
  if (y == 0.0)
  {
    return x > 0.0 ? 0 : 4;
  }
  if (x == 0.0)
  {
    return y > 0.0 ? 2 : 6;
  }
  if (y > 0.0)
  {
    return x > 0.0 ? 1 : 3;
  }
  return x < 0.0 ? 5 : 7;
}

int Modulo(int value, int modulus)
{
  return ((value % modulus) + modulus) % modulus;
}

/// Walks around vertices, counter-clockwise from triangle to triangle.
class FanWalk
{
public:
  explicit FanWalk(const SeamlessMap& map)
    : Map(map)
    , Topology(*map.topology)
    , Start(Index(this->Topology.VertexCount()), -1)
    , Boundary(Index(this->Topology.VertexCount()), -1)
  {
    for (int t = 0; t < this->Topology.TriangleCount(); ++t)
    {
      for (const int v : this->Topology.mesh.triangles[t])
      {
        this->Start[v] = t;
      }
    }
    for (int i = 0; i < static_cast<int>(this->Topology.mesh.boundary.size()); ++i)
    {
      this->Boundary[this->Topology.BoundaryAt(i).vertices[0]] = i;
    }
  }

  std::vector<Departure> Around(const Cone& cone) const
  {
    int triangle = this->Start[cone.vertex];
    int here = 0; // direction in eighths of the spoke with which the triangle starts, in its chart
    if (cone.onBoundary)
    {
      const int position = this->Boundary[cone.vertex];
      triangle = this->Topology.SideOfBoundary(position).first;
      here = 2 * this->Map.directions[position];
    }
    else
    {
      const int corner = this->CornerOf(triangle, cone.vertex);
      here = Eighths(this->Map.At(triangle, (corner + 1) % 3) - this->Map.At(triangle, corner));
    }
    std::vector<Departure> departures;
    const int first = triangle;
    int total = 0;
    do
    {
      const int corner = this->CornerOf(triangle, cone.vertex);
      const int side = (corner + 2) % 3; // the spoke that the triangle ends with
      const int next = this->Topology.Neighbour(triangle, side);
      const int end = next >= 0
        ? Eighths(this->Map.At(triangle, side) - this->Map.At(triangle, corner))
        : 2 * (this->DirectionOf(this->Topology.EdgeOf(triangle, side)) + 2);
      const int span = Modulo(end - here, 8);
      for (int eighth = 1; eighth <= span; ++eighth)
      {
        const bool alongBoundary = next < 0 && eighth == span;
        if ((here + eighth) % 2 == 0 && !alongBoundary)
        {
          departures.push_back({ triangle, corner, Modulo((here + eighth) / 2, 4) });
        }
      }
      total += span;
      if (next >= 0)
      {
        here = Modulo(end + 2 * this->Map.Across(triangle, side).rotation, 8);
      }
      triangle = next;
    } while (triangle >= 0 && triangle != first);
    const auto expected = static_cast<std::size_t>(cone.Quarters() - (cone.onBoundary ? 1 : 0));
    if (total != 2 * cone.Quarters() || departures.size() != expected)
    {
      throw CoarseMeshError("The triangles of the seamless map around " +
        this->Topology.Where(cone.vertex) + " add up to " + std::to_string(total) +
        " eighths of a turn instead of " + std::to_string(2 * cone.Quarters()) +
        "; use a finer mesh there.");
    }
    return departures;
  }

private:
  int CornerOf(int triangle, int vertex) const
  {
    const auto& v = this->Topology.mesh.triangles[triangle];
    return static_cast<int>(std::find(v.begin(), v.end(), vertex) - v.begin());
  }

  /// Returns the direction of a boundary edge in the chart of its triangle.
  int DirectionOf(int edge) const
  {
    for (const int v : this->Topology.edges.vertices[edge])
    {
      const int position = this->Boundary[v];
      if (position >= 0 && this->Topology.EdgeOfBoundary(position) == edge)
      {
        return this->Map.directions[position];
      }
    }
    return 0;
  }

  const SeamlessMap& Map;
  const MeshTopology& Topology;
  std::vector<int> Start;    ///< A triangle at every vertex.
  std::vector<int> Boundary; ///< Entry of mesh.boundary that starts at every vertex; −1 inside.
};
}

std::vector<std::vector<Departure>> FindDepartures(const SeamlessMap& map)
{
  const FanWalk walk(map);
  std::vector<std::vector<Departure>> departures;
  for (const Cone& cone : map.cones)
  {
    departures.push_back(walk.Around(cone));
  }
  return departures;
}
}
