#pragma once

#include "RegionSet.h"

#include <string>
#include <vector>

namespace crossfield
{
/// A segment between two materials, indices in MaterialCells::names; −1 outside of the domain.
struct MaterialEdge
{
  Point from = Point::Zero();
  Point to = Point::Zero();
  int left = 0;
  int right = -1;
};

/// A segment of a line.
struct SegmentOnLine
{
  Point from = Point::Zero();
  Point to = Point::Zero();
  int name = 0; ///< Index in MaterialCells::lineNames.
};

/// Returns the boundary of a domain of one material, number 0.
std::vector<MaterialEdge> EdgesOf(const PlanarDomain& domain);

/// Returns the edges of cells between different materials and on the outer boundary.
std::vector<MaterialEdge> EdgesOf(const MaterialCells& cells);

/// Triangulates materials so that lines are along edges (docs/method.md §21.6). Points of lines that are within
/// SampledDistance of the edges of materials are on them; lines may cross. Ends of lines that meet nothing get a
/// point nearby. Throws Error if a line is not inside of the domain.
MaterialCells CellsAlongLines(const std::vector<MaterialEdge>& edges,
  std::vector<std::string> materials, const std::vector<SegmentOnLine>& lines,
  std::vector<std::string> lineNames);
}
