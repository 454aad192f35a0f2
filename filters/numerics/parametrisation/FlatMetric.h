#pragma once

#include "ConeMetricSolve.h"
#include "MapTargets.h"
#include "TriangleFrames.h"

namespace crossfield
{
/// Targets that are isometric to a flat metric, and how it was found.
struct FlattenedTargets
{
  MapTargets targets;
  FlatteningReport report;
};

/// Flattens the metric e^{−2H} |dz|² of frames with a holonomy defect (docs/method.md §12.4 to
/// §12.7) and returns its layout, on another triangulation if flips and splits are needed. If the
/// strains do not converge with the quantile 0.3 it is tried again with 0.7. `report.converged` is
/// set if the targets can be used.
FlattenedTargets FlattenFrames(const MeshTopology& topology, const TriangleFrames& frames,
  const std::vector<Cone>& cones, const Progress& progress = {});
}
