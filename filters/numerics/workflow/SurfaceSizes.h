#pragma once

#include "SurfaceQuads.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace crossfield
{
/// What a request says about the sizes of quads on a surface, besides one for all; 0 stands for nothing.
struct SurfaceSizes
{
  bool isUniform = false; ///< Equal sizes instead of those of the map.
  /// Largest distance of the centres of quads from the surface.
  double chordError = 0.0;
  std::vector<SurfaceSizeNear> near;
  std::function<double(const SpacePoint&)>
    length; ///< Prescribed sizes on the surface; empty: none.
  double minimum = 0.0;
  double maximum = 0.0;
  double growth = 1.25; ///< Maximum ratio of target sizes of neighbours, above 1.

  /// Returns whether it says nothing.
  bool IsEmpty() const;
};

/// Returns the target sizes that a request has on a surface (docs/method.md §22.13): the size elsewhere is `quadSize`, or
/// such that there are `quadCount` quads; if both are 0, it is that of DefaultQuads, and with prescribed sizes or a chord
/// error as these need. `twins` are the vertices at the same place on both sides of lines between faces, where
/// sizes are equal, and `sideNames` the names of entries of mesh.boundary, at which sizes of `sides` are. Throws Error if a size is not a positive number.
SurfaceTargets ResolveSizes(const MeshTopology& topology,
  const std::vector<std::array<int, 2>>& twins, const std::vector<std::string>& sideNames,
  const std::vector<SurfaceSideRequest>& sides, const SurfaceSizes& sizes, double quadSize,
  int quadCount);
}
