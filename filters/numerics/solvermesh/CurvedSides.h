#pragma once

#include "DomainPlane.h"
#include "MeshFaces.h"

#include <complex>
#include <vector>

namespace crossfield
{
/// Offsets of the inner nodes of an edge from equal steps along it, relative to the edge as a complex
/// number: independent of position, direction and size.
using EdgeOffsets = std::vector<std::complex<double>>;

/// Returns a vector of the plane as a complex number.
inline std::complex<double> AsComplex(const Point& vector)
{
  return { vector.x(), vector.y() };
}

/// Returns the offsets of the same edge in the other direction.
EdgeOffsets Reversed(const EdgeOffsets& offsets);

/// A boundary side of a quad that is on a curve.
struct CurvedSide
{
  int side = 0; ///< Number of the face (MeshFaces.h).
  std::vector<Point>
    nodes;             ///< Inner nodes on the curve, in the plane and the direction of the side.
  EdgeOffsets offsets; ///< Of these nodes.
};

/// Returns the boundary sides of quads of order 1 that are on curves other than lines, with the order − 1 points
/// nearest to equal steps along each; first those that are not on the second of two periodic sides, then the images
/// of these. `sagittas` receives per curve the largest distance of a node from the straight edge. Throws Error as
/// MatchPair does.
std::vector<CurvedSide> FindCurvedSides(const SolverMesh& quads, const MeshFaces& faces,
  const DomainPlane& plane, int order, std::vector<double>& sagittas);
}
