#pragma once

#include "BoundaryPieces.h"
#include "RigidMotion.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace crossfield
{
/// A side of one piece on its loop.
struct SideSpan
{
  int loop = 0;
  double start = 0.0;  ///< Arc length.
  double length = 0.0; ///< Up to the end of the side.
};

/// Two sides that are images of each other, with the domain on opposite sides of them: the second,
/// followed backwards, is the image of the first. They are periodic sides, or both sides of an interface,
/// whose motion is the identity.
struct PairedSides
{
  int first = 0; ///< Index in BoundarySides::names.
  int second = 0;
  std::string name;      ///< What it is, for messages.
  RigidMotion motion;    ///< Takes the first to the second.
  bool isClosed = false; ///< Both are whole loops, and any nodes may be the first ones.
  /// Both sides of an interface: its nodes become one in the mesh of all regions (WeldRegions.h).
  bool isInterface = false;
  bool isOpen = false; ///< Of an interface: nodes at the same place stay two.
  /// Where its sides are. Set for those of a slit, which are on one loop and nearly at the same place, and on a surface.
  std::optional<std::array<SideSpan, 2>> spans;
  /// Nodes of a mesh in order from the ends of the sides: one of the first side, and its image.
  std::vector<std::array<int, 2>> nodes;
};

/// Distance, relative to the diagonal, that one side may have from the image of the other.
constexpr double PairReach = 1e-6;

/// Returns where a side is. Throws Error if it is closed or has several pieces.
SideSpan FindSpan(const BoundarySides& sides, const std::vector<LoopArc>& loops, int side);

/// Finds the motions of pairs of sides (docs/method.md §19.1). A motion within PairReach of a
/// translation is a translation. `curves` are those of the boundary.
///
/// Throws Error if there is no such side, a side is in two pairs, closed or of several pieces, or no
/// motion takes the first side to the second.
std::vector<PairedSides> FindPairedSides(const PlanarDomain& domain, const BoundarySides& sides,
  const CurvedBoundary& curves, const std::vector<std::array<std::string, 2>>& pairs);
}
