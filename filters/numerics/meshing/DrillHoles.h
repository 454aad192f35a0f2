#pragma once

#include "BoundarySymmetry.h"
#include "PlanarDomain.h"
#include "Progress.h"
#include "Singularity.h"
#include "SizeField.h"
#include "TriangleMesh.h"

namespace crossfield
{
/// Representation of a singularity in the mesh (docs/method.md §3.7, variants 1, 4 and 5).
enum class DrillMode
{
  Perforate, ///< A hole.
  Imprint,   ///< A circle of edges; its inside is meshed as well.
  Triangle   ///< The three edges of one triangle of the undrilled mesh; the triangle is retained.
};

/// Options for drilling a configuration into a domain (docs/method.md §3.7; paper, "Singularity
/// placements via perforation strategy").
struct DrillOptions
{
  /// Target edge length; 0 means 1/40 of the diagonal of the bounding box.
  double meshSize = 0.0;
  /// Minimum number of edges of the polygon that represents a hole. A hole of quarter index k has
  /// at least 8 |k|, so that the phase turns by at most π/4 from one edge to the next.
  int minimumHoleEdges = 32;
  /// Maximum growth of the edge length per unit of distance.
  double gradation = 0.25;
  /// Minimum number of edges across narrow parts of the domain (NarrowParts.h); 0: no minimum.
  double edgesAcross = 0.0;
  /// Factor by which all target edge lengths are divided.
  double refinement = 1.0;
  DrillMode mode = DrillMode::Perforate;
  /// Further points around which edges are short.
  std::vector<SizeSource> refinements;
  /// Points inside the domain that become vertices; used by Perforate and Imprint.
  std::vector<Point> vertices;
  /// Symmetries that domain, refinements and vertices have. If there are reflections among them,
  /// and no holes are drilled, the mesh has them exactly, up to rounding.
  SymmetryGroup symmetries;
};

/// Returns the mesh size that options define on a domain. Throws Error if it is negative or not
/// finite.
double ResolveMeshSize(const DrillOptions& options, const PlanarDomain& domain);

/// Triangulates the domain without the disks |x − b_i| < ρ_i. Each hole is a regular polygon with
/// its vertices on the circle. A singularity without a radius gets one that fits (HoleRadii.h); a
/// singularity on the boundary becomes a vertex of the mesh rather than a hole
/// (BoundarySingularities.h).
///
/// Imprint: the same polygons are edges of the mesh, and the disks are meshed. Triangle: the mesh
/// is that of the domain alone, and the edges of the triangle that contains b_i are marked; radii
/// are ignored. In both modes the marked edges are in TriangleMesh::imprinted.
///
/// Throws Error if a radius is not positive, a coordinate is not finite, a hole is not entirely
/// inside the domain, two holes overlap, or the coordinates are too large to resolve the shortest
/// edges. Triangle: throws Error if a quarter index is not ±1, or if a triangle touches the
/// boundary or shares an edge with that of another singularity.
TriangleMesh DrillHoles(const PlanarDomain& domain, const Configuration& configuration,
  const DrillOptions& options = {}, const Progress& progress = {});
}
