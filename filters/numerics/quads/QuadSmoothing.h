#pragma once

#include "CoarseQuads.h"
#include "Progress.h"

namespace crossfield
{
struct SmoothingReport
{
  int iterations = 0;     ///< On the mesh itself, without those on coarser ones.
  bool keptStart = false; ///< The start was better.
  bool released = false;  ///< Singularities had to move to make all quads positive,
  double moved = 0.0;     ///< by this at most.
  int symmetries = 1;     ///< That the mesh shares with its domain, the identity included.
};

/// Moves the points of a mesh with its topology fixed (docs/method.md §14.5): the least of QuadEnergy by L-BFGS, with ε
/// going to zero where the start has corners that are not positive. A large mesh starts from what became of every second
/// line of its blocks, and takes a few steps: cost linear in quads. Singularities inside are fixed, unless with
/// them fixed a quad is not positive. Keeps the start where that has the larger least scaled Jacobian.
///
/// `even`: for wanted sizes that are not those of the map. Singularities are free, sizes count as much as shapes, and the
/// start is kept only where it is positive and the smoothed mesh is not.
SmoothingReport SmoothQuads(QuadMesh& mesh, const QuadBlocks& blocks, const BoundaryCurves& curves,
  bool even, const Progress& progress = {});
}
