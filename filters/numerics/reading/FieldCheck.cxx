#include "FieldCheck.h"

#include "Error.h"

#include <algorithm>
#include <numeric>

namespace crossfield
{
namespace
{
/// Returns, for every vertex, whether it is a corner or has a chosen index.
std::vector<bool> MarkCounted(const PlanarTopology& topology, const PoincareHopfCount& count)
{
  std::vector<bool> counted(topology.mesh.points.size(), false);
  for (const CountedCorner& corner : count.corners)
  {
    counted[topology.VertexOf(corner)] = true;
  }
  return counted;
}

/// Returns the indices of the field at corners, and elsewhere on aligned loops where they are not
/// 0.
std::vector<CornerChoice> IndicesOfField(
  const PlanarTopology& topology, const FieldIndices& indices, const std::vector<bool>& counted)
{
  std::vector<CornerChoice> taken;
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    const auto vertex = static_cast<std::size_t>(edge.vertices[0]);
    if (edge.IsAligned() && (indices.ofVertex[vertex] != 0 || counted[vertex]))
    {
      taken.push_back({ topology.mesh.points[vertex], indices.ofVertex[vertex] });
    }
  }
  return taken;
}

/// Counts the corners with a chosen index at which the field has a different one.
int CountOtherCorners(
  const std::vector<CountedCorner>& prescribed, const std::vector<CountedCorner>& taken)
{
  return static_cast<int>(std::count_if(prescribed.begin(), prescribed.end(),
    [&taken](const CountedCorner& corner)
    {
      return corner.chosen &&
        std::none_of(taken.begin(), taken.end(),
          [&corner](const CountedCorner& other)
          {
            return other.loop == corner.loop && other.vertex == corner.vertex &&
              other.quarterIndex == corner.quarterIndex;
          });
    }));
}

std::string Describe(const FieldCheck& check, int otherCorners)
{
  std::string wrong;
  int wrongHoles = 0;
  for (std::size_t i = 0; i < check.prescribedDegrees.size(); ++i)
  {
    if (check.holes[i].degree != check.prescribedDegrees[i])
    {
      ++wrongHoles;
      wrong = "The field has degree " + std::to_string(check.holes[i].degree) + " instead of " +
        std::to_string(check.prescribedDegrees[i]) + " on hole " + std::to_string(i + 1);
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
      std::to_string(check.unwantedSingularities) + " unwanted singularities";
  }
  if (otherCorners > 0)
  {
    wrong += (wrong.empty() ? "The field takes" : " and takes") +
      std::string(" other quarter indices than chosen at ") + std::to_string(otherCorners) +
      " corners";
  }
  if (wrong.empty() && check.prescribedDegrees.empty())
  {
    return "The field has interior quarter indices of total " +
      std::to_string(check.interiorQuarters) +
      ", as its boundary requires, and no holes that prescribe any.";
  }
  return wrong.empty()
    ? "The field has the prescribed degrees on its holes and no other singularities inside."
    : wrong + "; move the holes, split large quarter indices or use the unit-norm method.";
}
}

FieldCheck CheckField(const CrossField& field, const std::vector<CornerChoice>& choices,
  const Configuration& points, bool byItself)
{
  if (!field.u.allFinite())
  {
    throw Error("The field has values that are not finite numbers; compute it again.");
  }
  const PlanarTopology& topology = *field.topology;
  const PoincareHopfCount prescribed = CountMeshQuarters(topology, choices);
  const FieldReading reading = ReadField(field, { prescribed, points, false, byItself });

  FieldCheck check;
  check.holes = reading.holes;
  check.unwantedSingularities = reading.unwantedSingularities;
  int given = 0;
  std::size_t hole = 0;
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      given += check.holes[hole++].degree;
      check.prescribedDegrees.push_back(loop.quarterIndex);
    }
  }
  for (const BoundaryLoop& circle : topology.imprinted)
  {
    // the degree is already part of the indices inside
    check.prescribedDegrees.push_back(circle.quarterIndex);
  }
  if (byItself)
  {
    check.prescribedDegrees.clear();
  }
  FieldIndices indices = ReadIndices(topology, field.u);
  const std::vector<bool> counted = MarkCounted(topology, prescribed);
  MergeAtVertices(topology.mesh, counted, indices);
  check.interiorQuarters =
    std::accumulate(indices.ofTriangle.begin(), indices.ofTriangle.end(), 0) +
    std::accumulate(indices.ofVertex.begin(), indices.ofVertex.end(), 0);
  for (const std::vector<int>& loop : topology.alignedVertices)
  {
    for (const int vertex : loop)
    {
      check.interiorQuarters -= indices.ofVertex[vertex];
    }
  }

  check.count = CountMeshQuarters(topology, IndicesOfField(topology, indices, counted));
  check.count.givenInteriorQuarters = given + check.interiorQuarters;
  const int otherCorners = CountOtherCorners(prescribed.corners, check.count.corners);
  check.asPrescribed =
    reading.wrongDegrees == 0 && check.unwantedSingularities == 0 && otherCorners == 0;
  check.reason = Describe(check, otherCorners);
  return check;
}
}
