#pragma once

#include "SolverMesh.h"

#include <string>

namespace crossfield
{
/// Returns the text of a PLOT3D grid of several blocks, formatted and whole, without IBLANK: the number
/// of blocks, their numbers of points, then for each block all x, all y and all z, the first index fastest. Without z,
/// as a two-dimensional grid, if z is constant; quads in space have one layer of points. Coordinates are exact.
///
/// `mesh` is oriented (OrientCells) and has valid blocks (RequireBlocks).
std::string WritePlot3d(const SolverMesh& mesh);

/// Returns the text of NASA's neutral map file of the same blocks: connections as ONE_TO_ONE, sides by name, and
/// COLLAPSED for sides on an axis. Faces are numbered 1 and 2 at the ends of K, 3 and 4 of I, 5 and 6 of J, also in
/// two dimensions, where K has one point. Names are plain. Throws Error as FindBlockFaces does.
std::string WriteNmf(const SolverMesh& mesh);
}
