#pragma once

#include "BoundarySides.h"
#include "QuadBlock.h"
#include "QuadMesh.h"

namespace crossfield
{
/// Sorts the boundary edges along their loops and sets the side and the curve of each, those of its
/// midpoint. Without names, the order stays and there are no sides.
void NameBoundary(const BoundarySides& sides, const BoundaryCurves& curves, QuadMesh& mesh);

/// Returns the points along the pieces of a side, each in order with the domain on the left. The
/// first and last point of a piece that is a whole loop are the same.
std::vector<std::vector<int>> PiecesOf(const QuadMesh& mesh, int side);

/// Size of a side in a mesh.
struct SideMeasure
{
  int edges = 0;
  double length = 0.0; ///< Sum of the lengths of the edges.
};

/// Returns the sizes of all sides.
std::vector<SideMeasure> MeasureSides(const QuadMesh& mesh);

/// Returns for every block and each of its sides J = 0, I largest, J largest, I = 0 the sides of the
/// boundary that its edges belong to, in order by increasing I or J; none if the side is inside.
std::vector<std::array<std::vector<int>, 4>> SidesOfBlocks(
  const QuadMesh& mesh, const std::vector<QuadBlock>& blocks);
}
