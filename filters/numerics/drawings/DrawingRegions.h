#pragma once

#include "Drawing.h"

namespace crossfield
{
/// Finds the regions between curves that meet at points where more than two of them end, cross each other
/// or end on each other: the bounded faces of their arrangement (docs/method.md §21.1), except what a
/// closed curve encloses that meets no other, which is a hole. Curves are sampled as by TraceOutline.
///
/// Sets Drawing::faces, triangles of the materials `region1`, `region2`, ... by decreasing area, and
/// replaces the pieces by the segments of the lines. Returns false, and changes nothing, if there is only
/// one region or a curve has an end that meets no other one within the tolerance.
bool TraceRegions(double tolerance, double turn, Drawing& drawing);
}
