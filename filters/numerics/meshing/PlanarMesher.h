#pragma once

#include "PlanarDomain.h"
#include "Progress.h"
#include "SizeField.h"
#include "TriangleMesh.h"

#include <memory>

namespace crossfield
{
/// Checks with exact predicates that no two segments of the loops cross, overlap or touch, and
/// returns for every loop how many other loops enclose it. Throws Error that names the place.
std::vector<int> NestingDepths(const std::vector<Loop>& loops);

/// Triangulates a domain: every segment of its loops becomes one edge or several, edges are about
/// as long as `size` asks, and no angle is below 20.7° except where the input has sharper corners.
/// The bulk is a graded lattice, most of it with triangles that are known beforehand; Delaunay refinement mends what is
/// left near the boundary (docs/method.md §10.1).
///
/// Loops marked as imprinted circles, convex ones, become edges inside the domain, which are given
/// once, in the direction of their loop. `loopMarks[l]` says what loop l is part of; its kind, id and quarter index are copied to the
/// edges that loop becomes. Throws Error where loops touch, or come so close that the gap between
/// them takes many more triangles than the size asks for. Two runs on the same input give the same mesh.
/// Triangles are along Hilbert's curve, points numbered as these use them first. Each of `vertices`, points inside the domain, becomes a vertex.
TriangleMesh TriangulateDomain(const PlanarDomain& domain,
  const std::vector<BoundaryEdge>& loopMarks, const SizeField& size, const Progress& progress = {},
  const std::vector<Point>& vertices = {});

/// The constrained Delaunay triangulation of the loops of a domain and of points inside it, without any others, for meshes that differ
/// from it in a few points. Throws as TriangulateDomain.
class KeptTriangulation
{
public:
  KeptTriangulation(
    PlanarDomain domain, std::vector<BoundaryEdge> loopMarks, const std::vector<Point>& points);
  ~KeptTriangulation();

  /// The mesh of TriangulateDomain's form with these points inside the domain instead of those of its own inside that are nearer than
  /// `clear` to one of them.
  TriangleMesh With(const std::vector<Point>& points, double clear) const;

private:
  struct Kept;
  std::unique_ptr<const Kept> What;
};
}
