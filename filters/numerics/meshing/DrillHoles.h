#pragma once

#include "PlanarDomain.h"
#include "Progress.h"
#include "Singularity.h"
#include "SizeField.h"
#include "TriangleMesh.h"

namespace crossfield
{
/// What a singularity becomes in the mesh (docs/method.md §3.7, variants 1, 4 and 5).
enum class DrillMode
{
  Perforate, ///< A hole.
  Imprint,   ///< A circle of edges whose inside is kept.
  Triangle   ///< The three edges of one triangle of the plain mesh, kept as well.
};

/// How a configuration is drilled into a domain (docs/method.md §3.7; paper, "Singularity placements via
/// perforation strategy").
struct DrillOptions
{
  /// Target edge length; 0: 1/40 of the diagonal of the bounding box.
  double meshSize = 0.0;
  /// Fewest edges of the polygon that stands for a hole. A hole of quarter index k gets at least
  /// 8 |k|, so that the phase turns by at most π/4 from one edge to the next.
  int minimumHoleEdges = 32;
  /// Largest growth of the edge length per unit of distance.
  double gradation = 0.25;
  DrillMode mode = DrillMode::Perforate;
  /// Further places that ask for small edges around them.
  std::vector<SizeSource> refinements;
  /// Points inside the domain that become vertices. Perforate and Imprint.
  std::vector<Point> vertices;
};

/// The mesh size that options ask for on a domain.
double ResolveMeshSize(const DrillOptions& options, const PlanarDomain& domain);

/// Triangulates the domain without the disks |x − b_i| < ρ_i; each hole is a regular polygon with
/// its vertices on the circle. A singularity without a radius gets one that fits (HoleRadii.h). One on
/// the boundary gets no hole but a vertex of the mesh (BoundarySingularities.h).
///
/// Imprint: the same polygons are edges of the mesh, and the disks are kept. Triangle: the mesh is
/// that of the domain alone, and the edges of the triangle that contains b_i are marked; radii mean
/// nothing. Either way the marked edges are in TriangleMesh::imprinted.
///
/// Throws Error when a radius is not positive, a coordinate is not finite, a hole is not wholly
/// inside the domain, two holes overlap, or the coordinates are too large to resolve the smallest edges.
/// Triangle: when a quarter index is not ±1, or a triangle
/// touches the boundary or shares an edge with that of another singularity.
TriangleMesh DrillHoles(const PlanarDomain& domain, const Configuration& configuration,
  const DrillOptions& options = {}, const Progress& progress = {});
}
