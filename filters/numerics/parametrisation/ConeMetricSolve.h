#pragma once

#include "ConeMetric.h"
#include "FlatteningReport.h"
#include "Progress.h"

namespace crossfield
{
/// Changes a metric until all angle sums and the directions of all inner loops are as prescribed
/// (docs/method.md §12.4 to §12.6), by Newton's method: conformal changes for the angle sums, and
/// for each inner loop a strain along a holomorphic quadratic differential. Each iteration takes one
/// factorisation of the Laplacian of the metric and one back-substitution per inner loop.
///
/// `quantile` is the part of the area on which the strain falls short of its largest value. Flips
/// and splits change the triangulation.
FlatteningReport FlattenMetric(ConeMetric& metric, double quantile, const Progress& progress = {});
}
