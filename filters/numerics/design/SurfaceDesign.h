#pragma once

#include "LayoutDesign.h"
#include "SurfaceCones.h"
#include "SurfaceQuads.h"

#include <optional>
#include <vector>

namespace crossfield
{
/// A connected surface in space on which layouts are designed (docs/method.md §22.14).
class DesignSurface
{
public:
  /// Edges sharper than an angle, in radians, are followed, and those between regions and of named lines. Throws Error
  /// as FindFeaturedParts does, and if the surface has several parts.
  DesignSurface(SurfaceMesh surface, SurfaceNames names, double featureAngle);

  double Area() const { return this->SurfaceArea; }

  /// Returns the surface of about 4,000 triangles on which layouts are computed while a handle is dragged.
  const SurfaceMesh& Coarse() const { return this->CoarsePart.surface; }

  /// Returns the sum that the quarter indices of singularities must have on all faces together. Throws Error as
  /// PlaceCones does.
  int RequiredSum() const;

  /// Chooses singularities for all faces; `quadSize` is the edge length of quads. Throws Error as ChooseSurfaceCones
  /// does.
  std::vector<SurfaceSingularity> Choose(double quadSize, const Progress& progress = {}) const;

  /// Moves singularities within their faces (MovedCones), on the coarse surface if the other has more than 20,000
  /// triangles. Throws Error as PlaceCones does.
  std::vector<SurfaceSingularity> Move(
    std::vector<SurfaceSingularity> singularities, const Progress& progress = {}) const;

  /// Computes the layout of singularities on the coarse surface, without quads. Patches keep the colours of an earlier
  /// design. Throws Error as PlaceCones, SolveSurfaceMap, TraceSeparatrices and MakeTMesh do.
  LayoutDesign DesignCoarse(const std::vector<SurfaceSingularity>& singularities,
    const std::vector<PatchColour>& earlier = {}, const Progress& progress = {}) const;

  /// Computes the layout on the surface itself, whose triangles are divided where that is necessary
  /// (TriangleDivision), and quads if options are given. Throws Error as DesignCoarse and MakeSurfaceQuads do.
  LayoutDesign Design(const std::vector<SurfaceSingularity>& singularities, double quadSize,
    const std::optional<SurfaceQuadOptions>& quads, const std::vector<PatchColour>& earlier = {},
    const Progress& progress = {}) const;

private:
  FeaturedPart Part;
  FeaturedPart CoarsePart;
  SurfaceNames Names;
  double FeatureAngle;
  double SurfaceArea;
};
}
