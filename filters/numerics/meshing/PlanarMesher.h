#pragma once

#include "CanonicalFrame.h"
#include "PlanarDomain.h"
#include "Progress.h"
#include "SizeField.h"
#include "TriangleMesh.h"

#include <memory>

namespace crossfield
{
/// Checks with exact predicates that no two segments of the loops cross, overlap or touch, and
/// returns for each loop the number of other loops that enclose it. Throws Error that names the
/// point.
std::vector<int> NestingDepths(const std::vector<Loop>& loops);

/// Triangulates a domain. Each segment of its loops becomes one or several edges, the edge length
/// follows `size`, and no angle is below 20.7° except at sharper corners of the input. The interior
/// is a graded lattice, most of whose triangles are known beforehand; Delaunay refinement meshes
/// the remaining part near the boundary (docs/method.md §10.1).
///
/// `loopMarks[l]` describes loop l; its kind, id and quarter index are copied to the edges of that
/// loop. Loops marked as imprinted circles must be convex; they become interior edges, stored once,
/// in the direction of their loop. Each of `vertices`, points inside the domain, becomes a vertex.
///
/// Triangles are ordered along a Hilbert curve, and points are numbered in the order in which the
/// triangles use them. The same input always gives the same mesh, and with the frame of the domain
/// as `frame`, a domain that is turned and shifted gives the same mesh, turned and shifted. `size`
/// is a function of the coordinates of that frame. Throws Error if loops touch, or if they are so
/// close that the gap between them takes many more triangles than the size field requires.
TriangleMesh TriangulateDomain(const PlanarDomain& domain,
  const std::vector<BoundaryEdge>& loopMarks, const SizeField& size, const Progress& progress = {},
  const std::vector<Point>& vertices = {}, const CanonicalFrame& frame = {});

/// Constrained Delaunay triangulation of the loops of a domain and of points inside it, without any
/// additional points. It is the base of meshes that differ from it in a few points.
class BaseTriangulation
{
public:
  BaseTriangulation(
    PlanarDomain domain, std::vector<BoundaryEdge> loopMarks, const std::vector<Point>& points);
  ~BaseTriangulation();

  /// Returns a mesh in the form of TriangulateDomain that has additional points inside the domain,
  /// in place of the interior points closer than `clear` to one of them.
  TriangleMesh With(const std::vector<Point>& points, double clear) const;

private:
  struct State;
  std::unique_ptr<const State> Current;
};
}
