#pragma once

#include "ConeMetric.h"
#include "FlatteningReport.h"
#include "Progress.h"

namespace crossfield
{
/// Changes a metric until all angle sums, the directions of all inner loops and those around handles are as
/// prescribed (docs/method.md §12.4 to §12.6, §22.9), by Newton's method: conformal changes for the angle sums, and
/// for each inner loop or cycle of a handle a strain along a holomorphic quadratic differential. Each iteration takes one
/// factorisation of the Laplacian of the metric and one back-substitution per loop or cycle.
///
/// `quantile` is the part of the area on which the strain falls short of its largest value. Flips
/// and splits change the triangulation.
FlatteningReport FlattenMetric(ConeMetric& metric, double quantile, const Progress& progress = {});
}
