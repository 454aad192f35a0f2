#pragma once

#include "BoundaryCorners.h"
#include "CrossField.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
struct FieldConfigurationOptions
{
  double cornerAngle = DefaultCornerAngle;
  /// Chosen quarter indices of corners; all others have that of the smallest rotation.
  std::vector<CornerChoice> corners;
};

/// Configuration read from a coarse Ginzburg-Landau field.
struct FieldConfiguration
{
  /// Interior singularities, consistent with the corners of the options, at some distance from the
  /// boundary.
  Configuration singularities;
  /// Corners that have another quarter index in the field, with that index.
  std::vector<CornerChoice> otherCorners;
};

/// Coarse Ginzburg-Landau field on about 5,000 triangles (docs/method.md §5.6). A boundary with
/// thousands of vertices is simplified to what that many triangles resolve (CoarseBoundary.h),
/// keeping corners and those of the options.
struct CoarseField
{
  CrossField field;
  double meshSize = 0.0;
};
CoarseField SolveCoarseField(const PlanarDomain& domain,
  const FieldConfigurationOptions& options = {}, const Progress& progress = {});

/// Reads a starting configuration from a coarse field. The singularities of the field are
/// consistent with its own corners. If a corner has another prescribed index than in the field, the
/// difference is placed inside next to it; singularities that the field has moved into the boundary
/// are placed inside in the same way. Singularities closer to the boundary than an edge are moved
/// away from it as far as space permits, those with |k| > 1 are split, and opposite ones less than
/// three edges apart, which the mesh cannot resolve, are cancelled.
FieldConfiguration ReadConfiguration(const PlanarDomain& domain, const CoarseField& coarse,
  const FieldConfigurationOptions& options = {});
}
