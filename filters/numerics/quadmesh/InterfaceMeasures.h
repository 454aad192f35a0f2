#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// Sizes on both sides of an interface. The ratio at an edge is that of the larger to the smaller area of
/// its two quads, which is that of their heights.
struct InterfaceMeasure
{
  std::string side;
  int edges = 0;
  double largestRatio = 1.0;
  double medianRatio = 1.0;
};

/// Measures the interfaces of a mesh of regions (WeldRegions.h), in the order of their sides.
std::vector<InterfaceMeasure> MeasureInterfaces(const QuadMesh& mesh);
}
