#include "FieldCheck.h"

#include "Error.h"

#include <algorithm>

namespace crossfield
{
namespace
{
bool IsAligned(const BoundaryEdge& edge)
{
  return edge.kind == BoundaryKind::Outer || edge.kind == BoundaryKind::Inner;
}

bool IsAmong(const std::vector<CountedCorner>& corners, const Point& place)
{
  return std::any_of(corners.begin(), corners.end(),
    [&place](const Corner& corner) { return corner.position == place; });
}

/// The indices that the field takes at corners, and where else on the boundary they are not 0.
std::vector<CornerChoice> TakenIndices(
  const TriangleMesh& mesh, const FieldIndices& indices, const std::vector<CountedCorner>& corners)
{
  std::vector<CornerChoice> taken;
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    if (!IsAligned(edge))
    {
      continue;
    }
    const auto vertex = static_cast<std::size_t>(edge.vertices[0]);
    const Point& place = mesh.points[vertex];
    const int index = indices.ofVertex[vertex];
    if (index != 0 || IsAmong(corners, place))
    {
      taken.push_back({ place, index });
    }
  }
  return taken;
}

/// Corners with a chosen index at which the field takes another one.
int CountOtherCorners(
  const std::vector<CountedCorner>& wanted, const std::vector<CountedCorner>& taken)
{
  return static_cast<int>(std::count_if(wanted.begin(), wanted.end(),
    [&taken](const CountedCorner& corner)
    {
      return corner.chosen &&
        std::none_of(taken.begin(), taken.end(),
          [&corner](const CountedCorner& other) {
            return other.position == corner.position && other.quarterIndex == corner.quarterIndex;
          });
    }));
}

std::string Describe(const FieldCheck& check, int otherCorners)
{
  std::string wrong;
  int wrongHoles = 0;
  for (std::size_t i = 0; i < check.holes.size(); ++i)
  {
    if (check.holes[i].degree != check.prescribedDegrees[i])
    {
      ++wrongHoles;
      wrong = "The field has degree " + std::to_string(check.holes[i].degree) + " instead of " +
        std::to_string(check.prescribedDegrees[i]) + " on hole " + std::to_string(i);
    }
  }
  if (wrongHoles > 1)
  {
    wrong =
      "The field has other degrees than prescribed on " + std::to_string(wrongHoles) + " holes";
  }
  if (check.unwantedSingularities > 0)
  {
    wrong += (wrong.empty() ? "The field has " : " and ") +
      std::to_string(check.unwantedSingularities) + " singularities that were not asked for";
  }
  if (otherCorners > 0)
  {
    wrong += (wrong.empty() ? "The field takes" : " and takes") +
      std::string(" other quarter indices than chosen at ") + std::to_string(otherCorners) +
      " corners";
  }
  if (wrong.empty() && check.holes.empty())
  {
    return "The field has interior quarter indices of total " +
      std::to_string(check.interiorQuarters) +
      ", as its boundary asks, and no holes that prescribe any.";
  }
  return wrong.empty()
    ? "The field has the prescribed degrees on its holes and no other singularities inside."
    : wrong + "; move the holes, split large quarter indices or use the unit-norm method.";
}
}

FieldCheck CheckField(
  const TriangleMesh& mesh, const ComplexVector& u, const std::vector<CornerChoice>& choices)
{
  if (!u.allFinite())
  {
    throw Error("The field has values that are not finite numbers; compute it again.");
  }
  const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
  CrossField field;
  field.edges = NumberEdges(mesh);
  field.u = u;
  field.count = CountMeshQuarters(mesh, loops, choices);
  ReadReport(mesh, loops, field);

  FieldCheck check;
  check.holes = field.holes;
  int given = 0;
  bool degrees = true;
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      const int degree = check.holes[check.prescribedDegrees.size()].degree;
      check.prescribedDegrees.push_back(loop.quarterIndex);
      degrees = degrees && degree == loop.quarterIndex;
      given += degree;
    }
  }
  for (const BoundaryLoop& circle : FindImprintedLoops(mesh))
  {
    // What is inside is counted there.
    const int degree = check.holes[check.prescribedDegrees.size()].degree;
    check.prescribedDegrees.push_back(circle.quarterIndex);
    degrees = degrees && degree == circle.quarterIndex;
  }
  FieldIndices indices = ReadIndices(mesh, field.edges, u);
  std::vector<bool> aligned(mesh.points.size(), false);
  std::vector<bool> corner(mesh.points.size(), false);
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    const auto vertex = static_cast<std::size_t>(edge.vertices[0]);
    aligned[vertex] = IsAligned(edge);
    corner[vertex] = IsAligned(edge) && IsAmong(field.count.corners, mesh.points[vertex]);
  }
  MergeAtVertices(mesh, corner, indices);
  const auto stray = [](int index) { return index != 0 ? 1 : 0; };
  for (int index : indices.ofTriangle)
  {
    check.interiorQuarters += index;
    check.unwantedSingularities += stray(index);
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    check.interiorQuarters += aligned[v] ? 0 : indices.ofVertex[v];
    check.unwantedSingularities += corner[v] ? 0 : stray(indices.ofVertex[v]);
  }

  check.count = CountMeshQuarters(mesh, loops, TakenIndices(mesh, indices, field.count.corners));
  check.count.givenInteriorQuarters = given + check.interiorQuarters;
  if (check.holes.empty() && check.interiorQuarters != 0)
  {
    check.unwantedSingularities = 0; // the boundary asks for them, and nothing says where
  }
  if (!mesh.imprinted.empty())
  {
    check.unwantedSingularities = field.unwantedSingularities; // circles have theirs inside
  }
  const int otherCorners = CountOtherCorners(field.count.corners, check.count.corners);
  check.asPrescribed = degrees && check.unwantedSingularities == 0 && otherCorners == 0;
  check.verdict = Describe(check, otherCorners);
  return check;
}
}
