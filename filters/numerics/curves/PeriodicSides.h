#pragma once

#include "BoundaryPieces.h"
#include "RigidMotion.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Names of two sides that are images of each other.
struct PeriodicNames
{
  std::string first;
  std::string second;
};

/// Two sides that are images of each other, with the domain on opposite sides of them: the second,
/// followed backwards, is the image of the first.
struct PeriodicSides
{
  int first = 0; ///< Index in BoundarySides::names.
  int second = 0;
  RigidMotion motion; ///< Takes the first to the second.
};

/// Distance, relative to the diagonal, that one side may have from the image of the other.
constexpr double PeriodicReach = 1e-6;

/// A side of one piece on its loop.
struct SideSpan
{
  int loop = 0;
  double start = 0.0;  ///< Arc length.
  double length = 0.0; ///< Up to the end of the side.
};

/// Returns where a side is. Throws Error if it is closed or has several pieces.
SideSpan FindSpan(const BoundarySides& sides, const std::vector<LoopArc>& loops, int side);

/// Finds the motions of pairs of sides (docs/method.md §19.1). A motion within PeriodicReach of a
/// translation is a translation. `curves` are those of the boundary.
///
/// Throws Error if there is no such side, a side is in two pairs, closed or of several pieces, or no
/// motion takes the first side to the second.
std::vector<PeriodicSides> FindPeriodicSides(const PlanarDomain& domain, const BoundarySides& sides,
  const CurvedBoundary& curves, const std::vector<PeriodicNames>& pairs);
}
