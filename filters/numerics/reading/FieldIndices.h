#pragma once

#include "CrossField.h"

namespace crossfield
{
/// Indices of a Crouzeix-Raviart cross field, read from wrapped differences of arg u between the
/// midpoints of neighbouring edges (docs/method.md §8.1). Triangles of midpoints and polygons of midpoints
/// around vertices tile the domain, so that
///   Σ ofTriangle + Σ ofVertex + Σ hole degrees = 4 χ,
/// with χ that of the domain before the holes were drilled.
struct FieldIndices
{
  std::vector<int> ofTriangle;
  /// Interior vertex: turns of u around it. Boundary vertex: quarter index that the field takes
  /// there; for vertices of holes, turns between the hole's own steps and the field inside.
  std::vector<int> ofVertex;
};

/// `u` has one value per edge.
FieldIndices ReadIndices(const MeshTopology& topology, const ComplexVector& u);

/// Moves the indices of the triangles at marked vertices to these vertices. Where the cross turns
/// by more than π/4 within one triangle at a corner, a wrapped difference is taken for the shorter
/// way, and a turn of the corner shows in the triangle; together they are right.
void MergeAtVertices(
  const TriangleMesh& mesh, const std::vector<bool>& marked, FieldIndices& indices);

/// How a field behaves on one hole or imprinted circle.
struct HoleReading
{
  int degree = 0;
  double minimumNorm = 0.0;
  double maximumNorm = 0.0;
  double largestStep = 0.0; ///< Largest |difference of arg u| between consecutive edges, radians.
  /// The degree means something: no step exceeds π/2 and the norm stays away from zero.
  bool Reliable() const;
};

/// `loop`: a hole, or an imprinted circle.
HoleReading ReadHole(const BoundaryLoop& loop, const EdgeNumbering& edges, const ComplexVector& u);
}
