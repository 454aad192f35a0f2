#include "ConeMetric.h"

#include "Error.h"
#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
MetricAngles AnglesFromLogLengths(const std::array<double, 3>& logs)
{
  // Lengths relative to the longest side, because they range over many orders of magnitude.
  const double longest = *std::max_element(logs.begin(), logs.end());
  std::array<double, 3> opposite;
  for (std::size_t i = 0; i < 3; ++i)
  {
    opposite[i] = std::exp(logs[(i + 1) % 3] - longest);
  }
  const double half = 0.5 * (opposite[0] + opposite[1] + opposite[2]);
  MetricAngles result;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double a = std::max(0.0, half - opposite[i]);
    const double b = std::max(0.0, half - opposite[(i + 1) % 3]);
    const double c = std::max(0.0, half - opposite[(i + 2) % 3]);
    // tan²(α/2) = (s − b) (s − c) / (s (s − a)); cot α = (1 − tan²(α/2)) / (2 tan(α/2))
    const double numerator = std::sqrt(b * c);
    const double denominator = std::sqrt(half * a);
    result.angle[i] = 2.0 * std::atan2(numerator, denominator);
    result.cotangent[i] = 0.5 * (denominator / numerator - numerator / denominator);
  }
  return result;
}

ConeMetric::ConeMetric(const MeshTopology& topology, const std::vector<std::array<int, 3>>& jumps,
  const std::vector<Cone>& cones)
  : InPlane(!topology.charts)
  , AllTriangles(topology.mesh.triangles.size())
  , BoundaryEdges(topology.mesh.boundary)
  , BoundarySides(topology.mesh.boundary.size())
  , Quarters(topology.mesh.points.size(), 4)
{
  for (int v = 0; v < topology.VertexCount(); ++v)
  {
    this->Positions.push_back(topology.PositionOf(v));
  }
  std::vector<int> entries(Index(topology.edges.Count()), -1);
  for (int i = 0; i < static_cast<int>(this->BoundaryEdges.size()); ++i)
  {
    entries[topology.EdgeOfBoundary(i)] = i;
    this->Quarters[this->BoundaryEdges[i].vertices[0]] = 2;
  }
  for (const Cone& cone : cones)
  {
    this->Quarters[cone.vertex] = cone.Quarters();
  }
  for (int e = 0; e < topology.edges.Count(); ++e)
  {
    this->Logs.push_back(std::log(topology.Length(e)));
  }
  for (int t = 0; t < static_cast<int>(this->AllTriangles.size()); ++t)
  {
    Triangle& triangle = this->AllTriangles[t];
    triangle.vertices = topology.mesh.triangles[t];
    triangle.edges = topology.edges.ofTriangle[t];
    triangle.jumps = jumps[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int entry = entries[triangle.edges[i]];
      triangle.neighbours[i] = entry >= 0 ? -1 - entry : topology.Neighbour(t, static_cast<int>(i));
    }
    this->Attach(t);
    this->Measure(t);
  }
  for (const BoundaryLoop& loop : topology.loops)
  {
    this->Starts.push_back(loop.edges.front());
    this->PropagateDirections(loop.edges.front());
  }
}

TriangleMesh ConeMetric::Triangulation() const
{
  TriangleMesh mesh;
  for (const SpacePoint& point : this->Positions)
  {
    mesh.points.emplace_back(point.head<2>());
  }
  for (const Triangle& triangle : this->AllTriangles)
  {
    mesh.triangles.push_back(triangle.vertices);
  }
  mesh.boundary = this->BoundaryEdges;
  return mesh;
}

double ConeMetric::Length(int edge) const
{
  return std::exp(this->Logs[edge]);
}

void ConeMetric::SetLogLengths(std::vector<double> logs)
{
  this->Logs = std::move(logs);
  for (int t = 0; t < static_cast<int>(this->AllTriangles.size()); ++t)
  {
    this->Measure(t);
  }
}

void ConeMetric::Measure(int triangle)
{
  const auto& edges = this->AllTriangles[triangle].edges;
  this->Angles.resize(this->AllTriangles.size());
  this->Angles[triangle] =
    AnglesFromLogLengths({ this->Logs[edges[0]], this->Logs[edges[1]], this->Logs[edges[2]] });
}

bool ConeMetric::IsValid() const
{
  for (int t = 0; t < static_cast<int>(this->AllTriangles.size()); ++t)
  {
    const MetricAngles& angles = this->AnglesOf(t);
    const auto [smallest, largest] = std::minmax_element(angles.angle.begin(), angles.angle.end());
    // Cotangents of smaller angles are rounding errors, and may overflow.
    if (!(*smallest > AngleRounding) || !(*largest < Pi - AngleRounding))
    {
      return false;
    }
  }
  return true;
}

double ConeMetric::AreaOf(int triangle) const
{
  const auto& edges = this->AllTriangles[triangle].edges;
  return 0.5 * this->Length(edges[0]) * this->Length(edges[2]) *
    std::sin(this->AnglesOf(triangle).angle[0]);
}

double ConeMetric::AngleOnSurface(int triangle, int corner) const
{
  const auto& v = this->AllTriangles[triangle].vertices;
  const SpacePoint& apex = this->Positions[v[corner]];
  const SpacePoint next = this->Positions[v[NextSide(corner)]] - apex;
  const SpacePoint last = this->Positions[v[NextSide(NextSide(corner))]] - apex;
  return std::atan2(next.cross(last).norm(), next.dot(last));
}

ConeMetric::Side ConeMetric::Across(Side side) const
{
  const Triangle& triangle = this->AllTriangles[side.triangle];
  const int neighbour = triangle.neighbours[side.side];
  const auto& edges = this->AllTriangles[neighbour].edges;
  const auto found = std::find(edges.begin(), edges.end(), triangle.edges[side.side]);
  return { neighbour, static_cast<int>(found - edges.begin()) };
}

void ConeMetric::TurnLoop(std::size_t loop, int quarters)
{
  const Side side = this->AtBoundary(this->Starts[loop]);
  this->AllTriangles[side.triangle].jumps[side.side] += quarters;
  this->PropagateDirections(this->Starts[loop]);
}

std::pair<int, int> ConeMetric::NextOnLoop(int entry) const
{
  Side side = this->AtBoundary(entry);
  int jumps = 0;
  for (;;)
  {
    side.side = NextSide(side.side);
    const Triangle& triangle = this->AllTriangles[side.triangle];
    const int neighbour = triangle.neighbours[side.side];
    if (neighbour < 0)
    {
      return { -1 - neighbour, jumps };
    }
    jumps += triangle.jumps[side.side];
    side = this->Across(side);
  }
}

void ConeMetric::PropagateDirections(int entry)
{
  // Along the boundary the direction turns by π minus the angle at the vertex.
  const auto directionAt = [this](int i) -> int&
  {
    const Side side = this->AtBoundary(i);
    return this->AllTriangles[side.triangle].jumps[side.side];
  };
  for (int current = entry;;)
  {
    const auto [next, jumps] = this->NextOnLoop(current);
    const int vertex = this->BoundaryEdges[next].vertices[0];
    const int direction = directionAt(current) + 2 - this->QuartersAt(vertex) + jumps;
    if (next == entry)
    {
      if ((direction - directionAt(entry)) % 4 != 0)
      {
        throw Error("The crosses do not close around the boundary loop through " +
          DescribePlace(this->Positions[vertex]) +
          ": the quarter indices of its corners and of the singularities contradict each other; "
          "use a finer mesh.");
      }
      return;
    }
    directionAt(next) = direction;
    current = next;
  }
}

void ConeMetric::Attach(int triangle)
{
  const Triangle& here = this->AllTriangles[triangle];
  for (int i = 0; i < 3; ++i)
  {
    const int neighbour = here.neighbours[i];
    if (neighbour < 0)
    {
      this->BoundarySides[-1 - neighbour] = { triangle, i };
      continue;
    }
    Triangle& other = this->AllTriangles[neighbour];
    for (std::size_t j = 0; j < 3; ++j)
    {
      if (other.edges[j] == here.edges[i])
      {
        other.neighbours[j] = triangle;
      }
    }
  }
}

void ConeMetric::AlignCharts(Side side)
{
  const int turn = this->AllTriangles[side.triangle].jumps[side.side];
  const int other = this->Across(side).triangle;
  // Directions in the chart of the other triangle decrease by the jump across the side.
  for (int i = 0; i < 3; ++i)
  {
    Triangle& turned = this->AllTriangles[other];
    turned.jumps[i] += turned.neighbours[i] < 0 ? -turn : turn;
    if (turned.neighbours[i] >= 0)
    {
      const Side back = this->Across({ other, i });
      this->AllTriangles[back.triangle].jumps[back.side] -= turn;
    }
  }
}

double ConeMetric::LogOtherDiagonal(Side side) const
{
  // The triangles are (a, b, p) and (b, a, q):
  // |pq|² = (|ap| − |aq|)² + 4 |ap| |aq| sin²(half the angle at a)
  const Side across = this->Across(side);
  const double angle = this->AnglesOf(side.triangle).angle[side.side] +
    this->AnglesOf(across.triangle).angle[NextSide(across.side)];
  const double ap =
    this->Length(this->AllTriangles[side.triangle].edges[NextSide(NextSide(side.side))]);
  const double aq = this->Length(this->AllTriangles[across.triangle].edges[NextSide(across.side)]);
  const double sine = std::sin(0.5 * angle);
  return 0.5 * std::log((ap - aq) * (ap - aq) + 4.0 * ap * aq * sine * sine);
}

void ConeMetric::Flip(Side side)
{
  this->AlignCharts(side);
  const Side across = this->Across(side);
  const int s = side.side;
  const int r = across.side;
  // The triangles are (a, b, p) and (b, a, q), the new ones (p, q, b) and (q, p, a).
  const Triangle one = this->AllTriangles[side.triangle];
  const Triangle two = this->AllTriangles[across.triangle];
  const int edge = one.edges[s];
  this->Logs[edge] = this->LogOtherDiagonal(side);

  const int a = one.vertices[s];
  const int b = one.vertices[NextSide(s)];
  const int p = one.vertices[NextSide(NextSide(s))];
  const int q = two.vertices[NextSide(NextSide(r))];
  const auto take = [](Triangle& into, int i, const Triangle& from, int j)
  {
    into.edges[i] = from.edges[j];
    into.neighbours[i] = from.neighbours[j];
    into.jumps[i] = from.jumps[j];
  };
  // Sets a triangle with the new edge as side 0.
  const auto set = [&](int t, int neighbour, const std::array<int, 3>& vertices) -> Triangle&
  {
    Triangle& triangle = this->AllTriangles[t];
    triangle.vertices = vertices;
    triangle.edges[0] = edge;
    triangle.neighbours[0] = neighbour;
    triangle.jumps[0] = 0;
    return triangle;
  };
  Triangle& first = set(side.triangle, across.triangle, { p, q, b });
  take(first, 1, two, NextSide(NextSide(r)));
  take(first, 2, one, NextSide(s));
  Triangle& second = set(across.triangle, side.triangle, { q, p, a });
  take(second, 1, one, NextSide(NextSide(s)));
  take(second, 2, two, NextSide(r));
  for (const int t : { side.triangle, across.triangle })
  {
    this->Attach(t);
    this->Measure(t);
  }
}

void ConeMetric::Split(Side side, double fraction)
{
  const int neighbour = this->AllTriangles[side.triangle].neighbours[side.side];
  if (neighbour >= 0)
  {
    this->AlignCharts(side);
  }
  const int s = side.side;
  const Triangle old = this->AllTriangles[side.triangle];
  const int a = old.vertices[s];
  const int b = old.vertices[NextSide(s)];
  const int edge = old.edges[s];
  const double length = this->Length(edge);
  const int middle = static_cast<int>(this->Positions.size());
  this->Positions.push_back((1.0 - fraction) * this->Positions[a] + fraction * this->Positions[b]);
  this->Quarters.push_back(neighbour < 0 ? 2 : 4);
  const auto addEdge = [this](double newLength)
  {
    this->Logs.push_back(std::log(newLength));
    return static_cast<int>(this->Logs.size()) - 1;
  };
  // The edge keeps the half at a, the new one has that at b.
  const int half = addEdge((1.0 - fraction) * length);

  // Divides the triangle of a side into one with its first vertex and a new one with its second;
  // `part` is the fraction of the side in the first.
  const auto divide = [&](Side whole, double part, int firstEdge, int secondEdge)
  {
    const int i = whole.side;
    const int j = NextSide(i);
    const int k = NextSide(j);
    const Triangle before = this->AllTriangles[whole.triangle];
    const double toFirst = this->Length(before.edges[k]);
    const double toSecond = this->Length(before.edges[j]);
    // Stewart's theorem
    const int cut = addEdge(std::sqrt(std::max(0.0,
      (1.0 - part) * toFirst * toFirst + part * toSecond * toSecond -
        part * (1.0 - part) * length * length)));
    const int added = static_cast<int>(this->AllTriangles.size());
    Triangle second = before;
    second.vertices[i] = middle;
    second.edges[i] = secondEdge;
    second.edges[k] = cut;
    second.neighbours[k] = whole.triangle;
    second.jumps[k] = 0;
    Triangle& first = this->AllTriangles[whole.triangle];
    first.vertices[j] = middle;
    first.edges[i] = firstEdge;
    first.edges[j] = cut;
    first.neighbours[j] = added;
    first.jumps[j] = 0;
    this->AllTriangles.push_back(second);
    return added;
  };

  if (neighbour < 0)
  {
    const int entry = -1 - neighbour;
    const int added = divide(side, fraction, edge, half);
    BoundaryEdge second = this->BoundaryEdges[entry];
    second.vertices[0] = middle;
    this->BoundaryEdges[entry].vertices[1] = middle;
    this->AllTriangles[added].neighbours[s] = -1 - static_cast<int>(this->BoundaryEdges.size());
    this->BoundaryEdges.push_back(second);
    this->BoundarySides.push_back({ added, s });
    this->Logs[edge] = std::log(fraction * length);
    for (const int t : { side.triangle, added })
    {
      this->Attach(t);
      this->Measure(t);
    }
    return;
  }
  const Side across = this->Across(side);
  const int added = divide(side, fraction, edge, half);
  const int addedAcross = divide(across, 1.0 - fraction, half, edge);
  this->Logs[edge] = std::log(fraction * length);
  // The triangle of the side has the half at a, whose other side is now the added triangle across.
  this->AllTriangles[side.triangle].neighbours[s] = addedAcross;
  this->AllTriangles[addedAcross].neighbours[across.side] = side.triangle;
  this->AllTriangles[added].neighbours[s] = across.triangle;
  this->AllTriangles[across.triangle].neighbours[across.side] = added;
  for (const int t : { side.triangle, added, across.triangle, addedAcross })
  {
    this->Attach(t);
    this->Measure(t);
  }
}
}
