#pragma once

#include "Separatrices.h"

namespace crossfield
{
/// Returns the points at which a separatrix stopped at another one and both had arrived at the same
/// time, up to a difference of lengths (docs/method.md §13.1); but not where a third one arrived at
/// that time from the opposite side, or where the other one meets one head-on.
std::vector<SeparatrixTie> FindTies(const TraceGraph& graph, double reach);
}
