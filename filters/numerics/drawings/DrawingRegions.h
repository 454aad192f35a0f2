#pragma once

#include "Drawing.h"

namespace crossfield
{
/// What closed curves bound that are inside of a region and meet no other one.
enum class ClosedCurves
{
  Holes,
  Regions ///< Regions, but those whose curves have names that begin with `hole`.
};

/// Finds the regions between curves that meet at points where more than two of them end, cross each other
/// or end on each other: the bounded faces of their arrangement (docs/method.md §21.1). Curves are sampled
/// as by TraceOutline.
///
/// Sets Drawing::faces, triangles of the materials `region1`, `region2`, ... by decreasing area, and
/// replaces the pieces by the segments of the lines. With ClosedCurves::Regions a region has the common name
/// of the curves around it, unless all regions have the same. Returns false, and changes nothing, if there is
/// only one region or a curve has an end that meets no other one within the tolerance.
bool TraceRegions(double tolerance, double turn, ClosedCurves closedCurves, Drawing& drawing);
}
