#pragma once

#include "Drawing.h"

namespace crossfield
{
/// A polyline between two nodes; its ends are exactly at these.
struct DrawnLine
{
  Loop points;
  std::string name;
};

/// Returns the curves of a drawing as lines that meet at their ends only: sampled as by TraceOutline, with ends
/// joined within a tolerance, and divided where others end on them or cross them. Lines that are drawn twice
/// count once.
std::vector<DrawnLine> MakeLineNetwork(const Drawing& drawing, double tolerance, double turn);

/// Removes the curves of some names from a drawing and returns them as such lines; tolerance 0: as for
/// TraceOutline.
std::vector<DrawnLine> TakeLines(
  const std::vector<std::string>& names, double tolerance, double turn, Drawing& drawing);
}
