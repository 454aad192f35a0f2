#pragma once

#include "Drawing.h"

#include <vector>

namespace crossfield
{
/// A piece of a chain.
struct ChainedPiece
{
  std::size_t piece = 0;   ///< Index in Drawing::pieces.
  bool isReversed = false; ///< Whether the chain runs from its last to its first point.
};

/// Closed chains of pieces.
struct PieceChains
{
  std::vector<std::vector<ChainedPiece>> chains;
  double largestGap = 0.0;           ///< Maximum distance between two ends that were joined.
  std::vector<std::string> warnings; ///< About removed pieces and closed gaps.
};

/// Returns the default tolerance of joints: 1e-5 of the extent, which exceeds the rounding of
/// coordinates with five digits or more and is less than any edge of a mesh, and the rounding of
/// coordinates far from the origin.
double DefaultJoinTolerance(const std::vector<DrawingPiece>& pieces);

/// Returns the diagonal of the bounding box of the pieces' curves.
double ExtentOf(const std::vector<DrawingPiece>& pieces);

/// Chains loose pieces into closed curves.
///
/// Of pieces that are in the same place within the tolerance only the first one is used, and a
/// piece that is shorter than the tolerance and joins nothing is not used. At ends that are not joined
/// in pairs, lines and arcs that lie on longer ones are not used, nor ways there and back, if the others
/// are closed curves. Ends at exactly the same
/// point belong together. Every other end is joined to the nearest such end within the tolerance;
/// the pairs are made in order of their distance.
///
/// Throws Error, with the place, if an end is left over or if more than two curves meet at a point.
PieceChains ChainPieces(const std::vector<DrawingPiece>& pieces, double tolerance);
}
