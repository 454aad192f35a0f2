#include "QuadNodes.h"

#include "Error.h"

#include <string>

namespace crossfield
{
void CountValences(const MeshTopology& topology, QuadMesh& mesh)
{
  for (const auto& quad : mesh.quads)
  {
    for (const int point : quad)
    {
      ++mesh.points[point].valence;
    }
  }
  if (mesh.EulerCharacteristic() != topology.edges.EulerCharacteristic(topology.mesh))
  {
    throw Error("The quads do not cover the domain; use a smaller size.");
  }
  for (const QuadPoint& point : mesh.points)
  {
    if (point.valence != (point.curve.loop < 0 ? 4 : 2) - point.quarterIndex)
    {
      throw Error("The node at " + DescribePlace(point.place) + " has " +
        std::to_string(point.valence) + " quads, not the requested number; use a smaller size.");
    }
  }
}

void FixCorners(const MeshBoundary& curves, QuadMesh& mesh)
{
  for (const CurvePlace& corner : curves.Corners())
  {
    const SpacePoint place = curves.PlaceAt(corner);
    QuadPoint* nearest = nullptr;
    double distance = 2.0 * curves.Length(corner.loop);
    for (QuadPoint& point : mesh.points)
    {
      if (point.curve.loop == corner.loop && (point.place - place).norm() < distance)
      {
        distance = (point.place - place).norm();
        nearest = &point;
      }
    }
    if (nearest != nullptr && !nearest->fixed)
    {
      nearest->curve = corner;
      nearest->MoveToCurve(curves);
      nearest->fixed = true;
    }
  }
}
}
