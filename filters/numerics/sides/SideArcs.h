#pragma once

#include "BoundarySides.h"
#include "MeshBoundary.h"
#include "TMesh.h"

#include "SeamlessMap.h"

#include <map>
#include <vector>

namespace crossfield
{
/// Chains of boundary arcs on one side. The T-mesh must be split at the ends of the sides
/// (SplitAtSides) and outlive the object.
class SideArcs
{
public:
  SideArcs(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
    const TMesh& mesh);

  /// Returns the arcs of a side.
  std::vector<int> Of(int side) const;
  /// Returns the arcs of a side in parts between corners or ends; a closed curve without them is one
  /// part.
  std::vector<std::vector<int>> PartsOf(int side) const;
  /// Returns the position on the boundary inside the piece that contains the middle of an arc.
  const CurvePlace& MiddleOf(int arc) const { return this->Middles.at(arc); }
  /// Returns the length of arcs in the plane.
  double LengthOf(const std::vector<int>& arcs) const;

private:
  /// Removes arcs from `remaining`, from a first one up to the next distinct node, and returns them.
  std::vector<int> Follow(int arc, std::vector<int>& remaining) const;

  const TMesh& Mesh;
  std::map<int, CurvePlace> Middles; ///< Per arc on the boundary.
  std::map<int, int> SideOf;         ///< Per arc on the boundary.
  std::map<int, int> From;           ///< Boundary arc that starts at a node.
};
}
