#pragma once

#include "TMesh.h"

#include <complex>
#include <optional>
#include <vector>

namespace crossfield
{
/// Path through a seamless map from one cone to another that determines the length of an arc of the
/// T-mesh: along a separatrix to the arc, along the arc, and back along another separatrix to its
/// cone. Unfolded so that the arc has direction i and the separatrices have direction ±1, its end
/// minus its start has the imaginary part ℓ, the length of the arc (docs/method.md §14.10).
struct ArcPath
{
  /// The part of the path in one triangle.
  struct Piece
  {
    int triangle = 0;
    Point from = Point::Zero();     ///< Start in the plane.
    Point to = Point::Zero();       ///< End in the plane.
    std::complex<double> step{ 0 }; ///< End minus start in the unfolded map.
  };

  int firstCone = -1; ///< Cone where the path starts; −1 if it starts on the boundary.
  int lastCone = -1;  ///< Cone where the path ends; −1 if it ends on the boundary.
  std::vector<Piece> pieces;
};

/// The paths of the arcs of a T-mesh.
class ArcPaths
{
public:
  /// Stores references to the map and its T-mesh, which must outlive this object.
  ArcPaths(const SeamlessMap& map, const TMesh& tMesh);

  /// Returns the path of an arc. Empty if one of its ends is on an extra separatrix, which starts on
  /// the boundary and at no cone.
  std::optional<ArcPath> Of(int arc) const;

  /// Returns the straight paths from cone to cone along separatrices that meet, each once. Unfolded,
  /// they have direction 1; the imaginary part of end minus start is 0 while they meet.
  std::vector<ArcPath> Joined() const;

private:
  /// The path from the end of an arc along a separatrix to its cone.
  struct Way
  {
    int cone = -1;
    std::vector<ArcPath::Piece> pieces;
  };

  /// Returns the path from the start of a half-edge to a cone. `direction` is that of the half-edge
  /// in the unfolded map, away from its start.
  std::optional<Way> FromEnd(int halfEdge, const std::complex<double>& direction) const;
  /// Follows a separatrix from the start of a half-edge to the cone where the separatrix starts.
  std::optional<Way> Follow(int halfEdge, const std::complex<double>& direction) const;
  /// Appends the pieces of a half-edge.
  void Append(
    int halfEdge, const std::complex<double>& direction, std::vector<ArcPath::Piece>& pieces) const;
  /// Returns the half-edge that starts at a node in a direction; −1 if there is none.
  int At(int node, int slot) const;

  const SeamlessMap& Map;
  const TMesh& Mesh;
  std::vector<std::vector<int>> BySlot; ///< Half-edges that start at each node, by slot.
};
}
