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
  /// Chosen quarter indices of corners; the others count by the smallest rotation.
  std::vector<CornerChoice> corners;
};

/// What a coarse Ginzburg-Landau field shows on a domain.
struct FieldConfiguration
{
  /// Consistent with the corners of the options: all singularities are inside, well off the boundary.
  Configuration singularities;
  /// The corners whose quarter index the field takes otherwise, with that index.
  std::vector<CornerChoice> otherCorners;
};

/// A coarse Ginzburg-Landau field, on about 5,000 triangles (docs/method.md §5.6). Of a boundary of
/// thousands of vertices it has only what that many triangles can tell (CoarseBoundary.h), corners and those
/// of the options among it.
struct CoarseField
{
  CrossField field;
  double meshSize = 0.0;
};
CoarseField SolveCoarseField(const PlanarDomain& domain,
  const FieldConfigurationOptions& options = {}, const Progress& progress = {});

/// Reads a starting configuration from it. Its singularities add up with its own corners; where a corner
/// has another quarter index in the count than in the field, the difference goes inside next to it, and
/// so do the singularities that the field has moved into the boundary. Those nearer to the boundary than
/// an edge are pushed off it as far as there is room, those of |k| > 1 are split, and opposite ones less
/// than three edges apart, which such a mesh cannot tell from none, are cancelled.
FieldConfiguration ReadConfiguration(const PlanarDomain& domain, const CoarseField& coarse,
  const FieldConfigurationOptions& options = {});
}
