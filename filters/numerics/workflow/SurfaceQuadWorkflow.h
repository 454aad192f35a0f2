#pragma once

#include "QuadRequest.h"
#include "SurfaceCones.h"
#include "SurfaceSizes.h"

#include <optional>

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

/// Makes quads of a surface in space with the given singularities, each in the nearest face, or with chosen ones
/// (docs/method.md §22.6, §22.11, §22.12). Parts share the number of quads by their areas. Of the result, what
/// concerns positions in a plane is empty; singularities are the irregular nodes. With names of regions, `regions`
/// has one entry for each face.
/// Chosen singularities of a part of one face are also moved (MovedCones); the better mesh of the two is returned.
///
/// If that needs smaller triangles, those of the surface are divided into four, twice at most and to 200,000 at most.
///
/// Throws Error as PlaceCones, ChooseSurfaceCones, SolveSurfaceMap and MakeSurfaceQuads do, and if the quarter
/// indices of a part do not add up to 4χ.
QuadWorkflowResult MakeQuadsOfSurface(
  const SurfaceMesh& surface, const SurfaceRequest& request, const Progress& progress = {});
}
