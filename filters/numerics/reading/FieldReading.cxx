#include "FieldReading.h"

#include "Error.h"
#include "UnwantedSingularities.h"

#include <numeric>
#include <string>

namespace crossfield
{
namespace
{
/// Reads the degrees of holes and imprinted circles and compares them with the prescribed ones, if
/// any. Returns the sum over the holes, which the indices inside do not include.
int ReadDegrees(const CrossField& field, const FieldRequest& request, FieldReading& reading)
{
  int excess = 0;
  int ofHoles = 0;
  const auto read = [&](const BoundaryLoop& loop)
  {
    reading.holes.push_back(ReadHole(loop, field.topology->edges, field.u));
    const int degree = reading.holes.back().degree;
    const int prescribed = request.byItself ? degree : loop.quarterIndex;
    reading.wrongDegrees += degree != prescribed ? 1 : 0;
    excess += degree - prescribed;
    return degree;
  };
  for (const BoundaryLoop& loop : field.topology->loops)
  {
    ofHoles += loop.kind == BoundaryKind::Hole ? read(loop) : 0;
  }
  for (const BoundaryLoop& loop : field.topology->imprinted)
  {
    read(loop);
  }
  reading.degreesReached = request.onlyTheSum ? excess == 0 : reading.wrongDegrees == 0;
  return ofHoles;
}
}

FieldReading ReadField(const CrossField& field, const FieldRequest& request)
{
  const PlanarTopology& topology = *field.topology;
  FieldReading reading;
  reading.count = request.count;
  const int degrees = ReadDegrees(field, request, reading);
  const FieldIndices indices = ReadIndices(topology, field.u);
  const int sum = std::accumulate(indices.ofTriangle.begin(), indices.ofTriangle.end(), 0) +
    std::accumulate(indices.ofVertex.begin(), indices.ofVertex.end(), 0) + degrees;
  if (sum != 4 * request.count.eulerCharacteristic || !field.u.allFinite())
  {
    throw Error("The indices of the field add up to " + std::to_string(sum) + " instead of " +
      std::to_string(4 * request.count.eulerCharacteristic) +
      ", which is impossible; the field has a zero or non-finite value on an edge.");
  }
  WantedSingularities wanted;
  wanted.points = request.points;
  for (const CountedCorner& corner : request.count.corners)
  {
    if (corner.chosen)
    {
      wanted.chosenVertices.push_back(topology.VertexOf(corner));
    }
  }
  wanted.inCircles = !request.byItself;
  if (request.byItself || (reading.holes.empty() && wanted.points.empty()))
  {
    wanted.anywhere = request.count.requiredInteriorQuarters;
  }
  reading.unwantedSingularities = CountUnwanted(field, indices, wanted);
  return reading;
}
}
