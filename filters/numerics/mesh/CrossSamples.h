#pragma once

#include "CrouzeixRaviart.h"

namespace crossfield
{
/// Samples of a Crouzeix-Raviart field for visualisation.
struct CrossSamples
{
  ComplexVector atTriangles; ///< u at each centroid.
  /// u at each vertex: the area-weighted mean of the values in the adjacent triangles. Second-order
  /// accurate up to the boundary; zero at a vertex without triangles.
  ComplexVector atVertices;
};

/// Samples a field `u`, given by one value per edge.
CrossSamples SampleField(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const ComplexVector& u);

/// Returns a unit vector along a branch of the cross that u represents: (cos θ, sin θ) with θ =
/// arg(u) / 4.
inline Point CrossBranch(const Complex& u)
{
  const double angle = 0.25 * std::arg(u);
  return { std::cos(angle), std::sin(angle) };
}
}
