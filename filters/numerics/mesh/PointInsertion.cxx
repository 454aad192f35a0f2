#include "PointInsertion.h"

#include "Error.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

/// A triangle and one of its sides: side i leads from corner i to corner i + 1.
struct Side
{
  int triangle;
  int side;
};

/// A triangulation that points are put into.
class Insertion
{
public:
  explicit Insertion(const MeshTopology& topology)
    : Mesh(topology.mesh)
    , Fixed(topology.mesh.points.size(), false)
  {
    for (const auto* marked : { &this->Mesh.boundary, &this->Mesh.imprinted })
    {
      for (const BoundaryEdge& edge : *marked)
      {
        this->Fixed[Index(edge.vertices[0])] = true;
        this->Fixed[Index(edge.vertices[1])] = true;
      }
    }
    this->Neighbours.reserve(this->Mesh.triangles.size());
    for (std::size_t t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      std::array<int, 3> neighbours{};
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto& two = topology.edges.triangles[Index(topology.edges.ofTriangle[t][i])];
        neighbours[i] = two[0] == static_cast<int>(t) ? two[1] : two[0];
      }
      this->Neighbours.push_back(neighbours);
    }
  }

  void Insert(const Point& point)
  {
    const int triangle = this->Locate(point);
    const auto corners = this->Mesh.triangles[Index(triangle)];
    const int nearest = *std::min_element(corners.begin(), corners.end(),
      [&](int a, int b)
      { return (this->PointAt(a) - point).norm() < (this->PointAt(b) - point).norm(); });
    if (!this->Move(nearest, triangle, point))
    {
      this->Split(triangle, point);
    }
    this->Legalise();
  }

  TriangleMesh Take() { return std::move(this->Mesh); }

private:
  const Point& PointAt(int vertex) const { return this->Mesh.points[Index(vertex)]; }
  int Corner(const Side& s, int offset) const
  {
    return this->Mesh.triangles[Index(s.triangle)][Index((s.side + offset) % 3)];
  }
  double Area(int a, int b, int c) const
  {
    return Cross(this->PointAt(b) - this->PointAt(a), this->PointAt(c) - this->PointAt(a));
  }

  int Locate(const Point& point) const
  {
    for (std::size_t t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      const auto& v = this->Mesh.triangles[t];
      bool inside = true;
      for (std::size_t i = 0; i < 3 && inside; ++i)
      {
        const Point& from = this->PointAt(v[i]);
        inside = Cross(this->PointAt(v[(i + 1) % 3]) - from, point - from) >= 0.0;
      }
      if (inside)
      {
        return static_cast<int>(t);
      }
    }
    throw Error("The point " + Describe(point) + " lies outside the mesh; move it inside.");
  }

  /// The same edge seen from the other triangle.
  Side Opposite(const Side& s) const
  {
    const int other = this->Neighbours[Index(s.triangle)][Index(s.side)];
    const int end = this->Corner(s, 1);
    const auto& corners = this->Mesh.triangles[Index(other)];
    const auto found = std::find(corners.begin(), corners.end(), end);
    return { other, static_cast<int>(found - corners.begin()) };
  }

  void Link(const Side& s, int neighbour)
  {
    this->Neighbours[Index(s.triangle)][Index(s.side)] = neighbour;
  }

  /// The triangles at a vertex, as its sides that leave it; nothing where it is at the boundary.
  std::vector<Side> Star(int vertex, int triangle) const
  {
    std::vector<Side> star;
    int t = triangle;
    do
    {
      const auto& corners = this->Mesh.triangles[Index(t)];
      const auto found = std::find(corners.begin(), corners.end(), vertex);
      const Side leaving{ t, static_cast<int>(found - corners.begin()) };
      star.push_back(leaving);
      t = this->Neighbours[Index(t)][Index((leaving.side + 2) % 3)];
    } while (t >= 0 && t != triangle);
    return t < 0 ? std::vector<Side>() : star;
  }

  /// Moves a vertex if its triangles keep a good part of their area.
  bool Move(int vertex, int triangle, const Point& point)
  {
    if (this->Fixed[Index(vertex)])
    {
      return false;
    }
    // Less makes obtuse triangles where a split makes short edges, which do no harm.
    constexpr double LeastPart = 0.5;
    const std::vector<Side> star = this->Star(vertex, triangle);
    for (const Side& s : star)
    {
      const Point& b = this->PointAt(this->Corner(s, 1));
      const Point& c = this->PointAt(this->Corner(s, 2));
      const double moved = Cross(b - point, c - point);
      if (moved < LeastPart * this->Area(vertex, this->Corner(s, 1), this->Corner(s, 2)))
      {
        return false;
      }
    }
    this->Mesh.points[Index(vertex)] = point;
    this->Fixed[Index(vertex)] = true;
    for (const Side& s : star)
    {
      this->Suspects.push_back(s);
      this->Suspects.push_back({ s.triangle, (s.side + 1) % 3 });
    }
    return true;
  }

  /// Three triangles instead of one.
  void Split(int triangle, const Point& point)
  {
    const int vertex = static_cast<int>(this->Mesh.points.size());
    this->Mesh.points.push_back(point);
    this->Fixed.push_back(true);
    const auto corners = this->Mesh.triangles[Index(triangle)];
    const auto neighbours = this->Neighbours[Index(triangle)];
    const int first = static_cast<int>(this->Mesh.triangles.size());
    const std::array<int, 3> parts = { triangle, first, first + 1 };
    this->Mesh.triangles.resize(this->Mesh.triangles.size() + 2);
    this->Neighbours.resize(this->Neighbours.size() + 2);
    for (int i = 0; i < 3; ++i)
    {
      // Side 0 of a part is side i of the triangle.
      if (neighbours[Index(i)] >= 0 && i > 0)
      {
        this->Link(
          this->SideAt(neighbours[Index(i)], corners[Index((i + 1) % 3)]), parts[Index(i)]);
      }
      this->Mesh.triangles[Index(parts[Index(i)])] = { corners[Index(i)],
        corners[Index((i + 1) % 3)], vertex };
      this->Neighbours[Index(parts[Index(i)])] = { neighbours[Index(i)], parts[Index((i + 1) % 3)],
        parts[Index((i + 2) % 3)] };
      this->Suspects.push_back({ parts[Index(i)], 0 });
    }
  }

  /// The side of a triangle that leaves a vertex.
  Side SideAt(int triangle, int vertex) const
  {
    const auto& corners = this->Mesh.triangles[Index(triangle)];
    const auto found = std::find(corners.begin(), corners.end(), vertex);
    return { triangle, static_cast<int>(found - corners.begin()) };
  }

  /// Lawson's flips of what may not be Delaunay.
  void Legalise()
  {
    while (!this->Suspects.empty())
    {
      const Side s = this->Suspects.back();
      this->Suspects.pop_back();
      if (this->Neighbours[Index(s.triangle)][Index(s.side)] >= 0 && this->WantsFlip(s))
      {
        this->Flip(s);
      }
    }
  }

  bool WantsFlip(const Side& s) const
  {
    const Side opposite = this->Opposite(s);
    const int a = this->Corner(s, 0);
    const int b = this->Corner(s, 1);
    const int c = this->Corner(s, 2);
    const int d = this->Corner(opposite, 2);
    if (!(this->Area(a, d, c) > 0.0) || !(this->Area(d, b, c) > 0.0))
    {
      return false; // not convex
    }
    const auto angle = [this](int at, int from, int to)
    {
      return std::abs(AngleBetween(
        this->PointAt(from) - this->PointAt(at), this->PointAt(to) - this->PointAt(at)));
    };
    // Of four points on a circle, as in a lattice, neither edge is better: rounding must not flip for ever.
    constexpr double Equal = 1e-9;
    return angle(c, a, b) + angle(d, b, a) > Pi + Equal;
  }

  /// Edge ab of triangles abc and bad becomes dc.
  void Flip(const Side& s)
  {
    const Side opposite = this->Opposite(s);
    const int a = this->Corner(s, 0);
    const int b = this->Corner(s, 1);
    const int c = this->Corner(s, 2);
    const int d = this->Corner(opposite, 2);
    const auto neighbourAt = [this](const Side& of, int offset)
    { return this->Neighbours[Index(of.triangle)][Index((of.side + offset) % 3)]; };
    const int bc = neighbourAt(s, 1);
    const int ca = neighbourAt(s, 2);
    const int ad = neighbourAt(opposite, 1);
    const int db = neighbourAt(opposite, 2);
    const int first = s.triangle;
    const int second = opposite.triangle;
    if (ad >= 0)
    {
      this->Link(this->SideAt(ad, d), first);
    }
    if (bc >= 0)
    {
      this->Link(this->SideAt(bc, c), second);
    }
    this->Mesh.triangles[Index(first)] = { a, d, c };
    this->Mesh.triangles[Index(second)] = { d, b, c };
    this->Neighbours[Index(first)] = { ad, second, ca };
    this->Neighbours[Index(second)] = { db, bc, first };
    this->Suspects.insert(
      this->Suspects.end(), { { first, 0 }, { first, 2 }, { second, 0 }, { second, 1 } });
  }

  TriangleMesh Mesh;
  std::vector<bool> Fixed; ///< On the boundary, or put where it is.
  std::vector<std::array<int, 3>> Neighbours;
  std::vector<Side> Suspects;
};
}

TriangleMesh InsertPoints(const MeshTopology& topology, const std::vector<Point>& points)
{
  Insertion insertion(topology);
  for (const Point& point : points)
  {
    insertion.Insert(point);
  }
  return insertion.Take();
}
}
