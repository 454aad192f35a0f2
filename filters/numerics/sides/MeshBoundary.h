#pragma once

#include "BoundaryCurves.h"
#include "PlanarTopology.h"

#include <utility>

namespace crossfield
{
/// The aligned boundary loops of a triangle mesh as curves: positions along the mesh.
class MeshBoundary : public BoundaryCurves
{
public:
  explicit MeshBoundary(const PlanarTopology& topology, const CurvedBoundary& boundary = {});
  /// Makes that of a surface.
  explicit MeshBoundary(const MeshTopology& topology);

  /// Returns the position at a fraction of an entry of mesh.boundary.
  CurvePlace Place(int boundaryPosition, double fraction) const;
  /// Returns the positions of corner vertices (MeshTopology::corners).
  std::vector<CurvePlace> Corners() const;
  /// Returns the entry of mesh.boundary at a position.
  int PositionAt(const CurvePlace& place) const;

private:
  void NumberSides();

  const MeshTopology& Topology;
  std::vector<std::vector<int>> Positions; ///< Entries of mesh.boundary, per loop and side.
  std::vector<std::pair<int, std::size_t>> LoopAndEdge; ///< Per entry of mesh.boundary.
};
}
