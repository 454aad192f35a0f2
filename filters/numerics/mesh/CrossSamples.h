#pragma once

#include "CrouzeixRaviart.h"

namespace crossfield
{
/// A Crouzeix-Raviart field sampled where it is shown.
struct CrossSamples
{
  ComplexVector atTriangles; ///< u at each centroid.
  /// u at each vertex: the mean of the values that the adjacent triangles have there, weighted by
  /// area; second-order accurate up to the boundary. Zero at a vertex without triangles.
  ComplexVector atVertices;
};

/// `u` has one value per edge.
CrossSamples SampleField(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const ComplexVector& u);

/// Unit vector along a branch of the cross that u represents: (cos θ, sin θ) with θ = arg(u) / 4.
inline Point CrossBranch(const Complex& u)
{
  const double angle = 0.25 * std::arg(u);
  return { std::cos(angle), std::sin(angle) };
}
}
