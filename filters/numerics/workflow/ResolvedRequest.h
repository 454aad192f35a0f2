#pragma once

#include "QuadRequest.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// A request whose sides have names, with what is prescribed for them in the form in which the
/// steps use it. Steps before the attempts add motions, curves and sizes.
struct ResolvedRequest : QuadRequest
{
  SidePrescriptions prescribed;          ///< Counts, progressions and sizes, one entry a side.
  std::vector<LayerPrescription> layers; ///< Boundary layers of sides.
  CurveRequest curveRequest; ///< Curves declared for sides, and whether arcs are recognised.
  std::vector<std::array<std::string, 2>> partners; ///< Sides whose nodes match.
  std::vector<PairedSides> periodic;  ///< The same with their motions (WithPeriodicSides).
  CurvedBoundary curves;              ///< Curves of the boundary (WithCurves).
  bool takesFewRows = false;          ///< As in AddLayers; set for the last attempt.
  std::optional<SizeTargets> targets; ///< Absent without prescribed sizes (WithSizeTargets).
};

/// Returns a request with the names of its sides, those of NameSides if it has none. Throws Error
/// if a side with a count, a progression or a size does not exist, or one of them is prescribed
/// twice.
ResolvedRequest Resolve(const PlanarDomain& domain, const QuadRequest& request);

/// Returns whether sizes may become uniform (SizingChoice.h): no sizing is requested, and neither
/// layers nor progressions of sides prescribe sizes. Layers need the shapes of conformal sizes:
/// each row is as far from a rectangle as the quads that it divides.
bool IsSizingFree(const ResolvedRequest& request);
}
