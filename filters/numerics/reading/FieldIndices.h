#pragma once

#include "CrossField.h"

namespace crossfield
{
/// Indices of a Crouzeix-Raviart cross field, read from wrapped differences of arg u between the
/// midpoints of neighbouring edges (docs/method.md §8.1). Triangles of midpoints and polygons of
/// midpoints around vertices tile the domain, so that
///   Σ ofTriangle + Σ ofVertex + Σ hole degrees = 4 χ,
/// where χ is that of the domain before the holes were drilled.
struct FieldIndices
{
  std::vector<int> ofTriangle;
  /// For an interior vertex, the number of turns of u around it. For a boundary vertex, the quarter
  /// index that the field has there; for vertices of holes, the turns between the hole's own steps
  /// and the field inside.
  std::vector<int> ofVertex;
};

/// Reads the indices. `u` has one value per edge.
FieldIndices ReadIndices(const PlanarTopology& topology, const ComplexVector& u);

/// Moves the indices of the triangles at marked vertices to these vertices. Where the cross turns
/// by more than π/4 within one triangle at a corner, a wrapped difference takes the shorter
/// direction, and a turn of the corner appears in the triangle; the sum of both is correct.
void MergeAtVertices(
  const TriangleMesh& mesh, const std::vector<bool>& marked, FieldIndices& indices);

/// Behaviour of a field on one hole or imprinted circle.
struct HoleReading
{
  int degree = 0;
  double minimumNorm = 0.0;
  double maximumNorm = 0.0;
  double largestStep = 0.0; ///< Largest |difference of arg u| between consecutive edges, radians.
  /// Returns whether the degree is meaningful: no step exceeds π/2 and the norm stays away from
  /// zero.
  bool Reliable() const;
};

/// Reads the field on `loop`, a hole or an imprinted circle.
HoleReading ReadHole(const BoundaryLoop& loop, const EdgeNumbering& edges, const ComplexVector& u);
}
