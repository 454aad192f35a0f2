#pragma once

#include "QuadRequest.h"
#include "SurfaceCones.h"
#include "SurfaceSizes.h"

#include <optional>
#include <vector>

namespace crossfield
{
/// Input of MakeQuadsOfSurface besides the surface.
struct SurfaceRequest
{
  /// None: they are chosen (ChooseSurfaceCones).
  std::optional<std::vector<SurfaceSingularity>> singularities;
  /// Side length of quads; with prescribed sizes, a factor of these. 0: derived from quadCount.
  double quadSize = 0.0;
  int quadCount = DefaultQuads; ///< 0: as many as sizes need.
  bool hold = false;            ///< SurfaceQuadOptions::hold.
  bool coarse = false;          ///< SurfaceQuadOptions::coarse.
  /// Edges whose triangles' normals differ by more, in radians, are lines of quads.
  double featureAngle = DefaultFeatureAngle;
  SurfaceSizes sizes = {};
  std::vector<SurfaceSideRequest> sides = {};
  SurfaceNames names = {}; ///< Of its regions and lines, which are lines of quads as well.

  /// Returns whether sizes besides one for all quads are requested.
  bool HasSizes() const;
};
}
