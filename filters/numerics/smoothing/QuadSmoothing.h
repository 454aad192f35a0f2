#pragma once

#include "CoarseQuads.h"
#include "Progress.h"

#include <optional>

namespace crossfield
{
/// Report of SmoothQuads and MakeSymmetric.
struct SmoothingReport
{
  int iterations = 0;     ///< Steps on the mesh itself, without those on coarser meshes.
  bool keptStart = false; ///< The mesh was not changed, as its start was better.
  bool released = false;  ///< Singularities were free to move.
  double moved = 0.0;     ///< Maximum displacement of a cone if they were.
  int symmetries = 1; ///< Number of symmetries of the domain that the mesh has, with the identity.
  /// With symmetric positions, the nodes of periodic sides would not match.
  bool isAsymmetric = false;
};

/// Where the points of a mesh are.
struct SmoothingDomain
{
  const BoundaryCurves& curves;
  const SurfaceWalk* surface = nullptr; ///< Null in the plane.
};

/// Smooths a mesh with fixed connectivity (docs/method.md §14.5): minimises QuadEnergy by L-BFGS,
/// with ε decreasing to zero if the start has corners that are not positive. A large mesh takes a
/// few steps, with corrections from coarser meshes of every second line of its blocks, so the cost
/// is linear in quads; without blocks, it takes as many steps as a small one. Inner singularities are fixed, unless a quad is not positive with them
/// fixed. Keeps the start if its minimum scaled Jacobian is larger.
///
/// With target sizes other than those of the map, `sizePart` is the weight of sizes against shapes,
/// between 0 and 1. Then singularities are free, and the start is kept only if its quads are positive
/// and those of the smoothed mesh are not. With the sizes of the map it is absent.
///
/// `hold` keeps inner singularities fixed in any case.
///
/// On a surface, each descent is repeated with the tangent planes at the new places (docs/method.md §22.8). Draft points
/// have triangles there; the normals of quads are set.
SmoothingReport SmoothQuads(QuadMesh& mesh, const QuadBlocks& blocks, const SmoothingDomain& domain,
  std::optional<double> sizePart, bool hold, const Progress& progress = {});
}
