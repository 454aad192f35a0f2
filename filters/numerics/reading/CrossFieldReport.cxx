#include "CrossFieldReport.h"

#include "Error.h"
#include "FieldSingularities.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <string>
#include <tuple>

namespace crossfield
{
namespace
{
/// Whether each vertex is one with a chosen quarter index.
std::vector<bool> FindChosen(const TriangleMesh& mesh, const PoincareHopfCount& counted)
{
  std::vector<bool> chosen(mesh.points.size(), false);
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    const auto vertex = static_cast<std::size_t>(edge.vertices[0]);
    chosen[vertex] = std::any_of(counted.corners.begin(), counted.corners.end(),
      [&](const CountedCorner& corner)
      { return corner.chosen && corner.position == mesh.points[vertex]; });
  }
  return chosen;
}

/// Whether each vertex is a corner of an aligned loop.
std::vector<bool> FindCorners(const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops)
{
  std::vector<bool> corner(mesh.points.size(), false);
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind != BoundaryKind::Outer && loop.kind != BoundaryKind::Inner)
    {
      continue;
    }
    const auto direction = [&](std::size_t i)
    {
      const auto& ends = mesh.boundary[static_cast<std::size_t>(loop.edges[i])].vertices;
      return Point(mesh.points[static_cast<std::size_t>(ends[1])] -
        mesh.points[static_cast<std::size_t>(ends[0])]);
    };
    const std::size_t count = loop.edges.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t next = (i + 1) % count;
      // The outer loop is walked along its edges, an inner loop against them.
      const auto& edge = mesh.boundary[static_cast<std::size_t>(loop.edges[i])];
      const auto vertex =
        static_cast<std::size_t>(edge.vertices[loop.kind == BoundaryKind::Outer ? 1 : 0]);
      corner[vertex] = IsCorner(AngleBetween(direction(i), direction(next)));
    }
  }
  return corner;
}

/// Reads the degrees of holes and imprinted circles and compares them with the prescribed ones;
/// returns the sum over the holes, which the indices inside do not contain.
int ReadDegrees(const std::vector<BoundaryLoop>& loops, const std::vector<BoundaryLoop>& imprinted,
  CrossField& field)
{
  field.holes.clear();
  field.wrongDegrees = 0;
  int excess = 0;
  int ofHoles = 0;
  const auto read = [&](const BoundaryLoop& loop)
  {
    field.holes.push_back(ReadHole(loop, field.edges, field.u));
    const int degree = field.holes.back().degree;
    field.wrongDegrees += degree != loop.quarterIndex ? 1 : 0;
    excess += degree - loop.quarterIndex;
    return degree;
  };
  for (const BoundaryLoop& loop : loops)
  {
    ofHoles += loop.kind == BoundaryKind::Hole ? read(loop) : 0;
  }
  for (const BoundaryLoop& loop : imprinted)
  {
    read(loop);
  }
  field.degreesReached = field.globalConstraint ? excess == 0 : field.wrongDegrees == 0;
  return ofHoles;
}

/// An imprinted circle, and what is found in it.
struct Circle
{
  Point centre = Point::Zero();
  double reach = 0.0; ///< Its radius and one edge: how well the place of a singularity is known.
  int wanted = 0;
  int sum = 0;  ///< Of the quarter indices found,
  int size = 0; ///< and of their absolute values.
};

Circle Describe(const TriangleMesh& mesh, const BoundaryLoop& loop)
{
  Circle circle;
  circle.wanted = loop.quarterIndex;
  circle.centre = CentreOf(loop, mesh);
  const auto ends = [&](int edge) -> const std::array<int, 2>&
  { return mesh.imprinted[static_cast<std::size_t>(edge)].vertices; };
  const auto point = [&](int vertex) { return mesh.points[static_cast<std::size_t>(vertex)]; };
  for (const int edge : loop.edges)
  {
    const double length = (point(ends(edge)[1]) - point(ends(edge)[0])).norm();
    circle.reach = std::max(circle.reach, (point(ends(edge)[0]) - circle.centre).norm() + length);
  }
  return circle;
}

/// Singularities of the field beyond those that imprinted circles ask for, by |k|.
int CountAppeared(
  const TriangleMesh& mesh, const std::vector<BoundaryLoop>& imprinted, const CrossField& field)
{
  std::vector<Circle> circles;
  circles.reserve(imprinted.size());
  for (const BoundaryLoop& loop : imprinted)
  {
    circles.push_back(Describe(mesh, loop));
  }
  int appeared = 0;
  for (const FieldSingularity& singularity : FindFieldSingularities(mesh, field.edges, field.u))
  {
    const auto around = std::find_if(circles.begin(), circles.end(),
      [&](const Circle& circle)
      { return (singularity.position - circle.centre).norm() <= circle.reach; });
    if (around == circles.end())
    {
      appeared += std::abs(singularity.quarterIndex);
    }
    else
    {
      around->sum += singularity.quarterIndex;
      around->size += std::abs(singularity.quarterIndex);
    }
  }
  for (const Circle& circle : circles)
  {
    appeared += circle.size - (circle.sum == circle.wanted ? std::abs(circle.wanted) : 0);
  }
  return appeared;
}
}

void ReadReport(const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops, CrossField& field)
{
  const std::vector<BoundaryLoop> imprinted = FindImprintedLoops(mesh);
  const int degrees = ReadDegrees(loops, imprinted, field);
  FieldIndices indices = ReadIndices(mesh, field.edges, field.u);
  const int sum = std::accumulate(indices.ofTriangle.begin(), indices.ofTriangle.end(), 0) +
    std::accumulate(indices.ofVertex.begin(), indices.ofVertex.end(), 0) + degrees;
  if (sum != 4 * field.count.eulerCharacteristic || !field.u.allFinite())
  {
    throw Error("The indices of the field add up to " + std::to_string(sum) + " instead of " +
      std::to_string(4 * field.count.eulerCharacteristic) +
      ", which cannot be; the field has a zero or non-finite value on an edge.");
  }
  if (!imprinted.empty() || field.epsilon > 0.0)
  {
    field.unwantedSingularities = CountAppeared(mesh, imprinted, field);
    return;
  }
  const std::vector<bool> corner = FindCorners(mesh, loops);
  const std::vector<bool> chosen = FindChosen(mesh, field.count);
  MergeAtVertices(mesh, chosen, indices);
  field.unwantedSingularities = 0;
  for (int index : indices.ofTriangle)
  {
    field.unwantedSingularities += index != 0 ? 1 : 0;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    field.unwantedSingularities += indices.ofVertex[v] != 0 && !corner[v] && !chosen[v] ? 1 : 0;
  }
}

bool IsBetter(const CrossField& field, const CrossField& other)
{
  const auto shortcomings = [](const CrossField& of)
  { return std::make_tuple(!of.converged, of.wrongDegrees, of.unwantedSingularities, of.energy); };
  return shortcomings(field) < shortcomings(other);
}
}
