#pragma once

#include "SeamlessMap.h"
#include "TMesh.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// A size of quads near a place of a surface: up to a distance from it, and growing beyond.
struct SurfaceSizeNear
{
  SpacePoint place = SpacePoint::Zero();
  double size = 0.0;
  double radius = 0.0;
};

/// The same with a distance beyond which sizes at vertices show it.
struct NearTarget
{
  SurfaceSizeNear near;
  double reach = 0.0;

  /// Returns the size at a distance, infinite beyond its reach.
  double At(double distance, double growth) const;
};

/// Target sizes of quads on a surface: linear in its triangles, and at most those near places, which may be smaller
/// than triangles.
struct SurfaceTargets
{
  Eigen::VectorXd sizes; ///< At vertices. Empty: those of the map.
  std::vector<NearTarget> near;
  double growth = 0.0; ///< Of sizes, per unit of length.

  bool IsEmpty() const { return this->sizes.size() == 0; }
  /// Returns the size at a place in a triangle.
  double At(const MeshTopology& topology, int triangle, const SpacePoint& place) const;
  /// Returns the number of quads of these sizes: ∫ dA / h².
  double CountOn(const MeshTopology& topology) const;
};

/// Returns the length of every arc of a map in units of the target size: ∫ ds / h.
std::vector<double> TargetLengths(
  const SeamlessMap& map, const TMesh& mesh, const SurfaceTargets& targets);
}
