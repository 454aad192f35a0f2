#pragma once

#include "PlanarDomain.h"
#include "PlanarTopology.h"
#include "SizeReport.h"
#include "TargetSize.h"

namespace crossfield
{
/// Side lengths of quads that the data of a domain prescribe, for Sizing::Field.
struct PrescribedSizes
{
  /// Length at a point; only called for points of the boundary where `isOnBoundaryOnly` is set.
  SizeFunction length;
  /// Whether lengths are known on the boundary only. Inside, log h is then harmonic (ExtendSizes).
  bool isOnBoundaryOnly = false;
  std::vector<Point> places; ///< Where the data have lengths, between which they are interpolated.
};

/// Prescribed sizes as a relative size field and a unit.
struct RelativeSizes
{
  SizeFunction field; ///< Size relative to `mean`, P1 on the mesh that it was computed on.
  double mean = 0.0;  ///< Side length of equal quads that would be as many (EquivalentSize).
};

/// Samples prescribed sizes at the vertices of a mesh, and continues them inside if they are known on
/// the boundary only (docs/method.md §14.8).
Eigen::VectorXd SampleSizes(const PrescribedSizes& sizes, const PlanarTopology& topology);

/// Divides the samples by their mean.
RelativeSizes ComputeRelativeSizes(const PrescribedSizes& sizes, const PlanarTopology& topology);

/// Returns target sizes relative to their mean.
RelativeSizes RelativeTo(const SizeTargets& targets);

/// Does the same on a mesh of the domain without singularities. `meshSize` is the edge length of
/// its triangles, 0 for the default.
RelativeSizes ComputeRelativeSizes(
  const PrescribedSizes& sizes, const PlanarDomain& domain, double meshSize);
}
