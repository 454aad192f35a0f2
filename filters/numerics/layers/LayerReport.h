#pragma once

#include "LayeredMesh.h"

#include <array>
#include <string>

namespace crossfield
{
/// Measures of the boundary layer of one side (docs/method.md §16.3).
struct LayerReport
{
  std::string name;           ///< Of the side.
  int rowsReplaced = 0;       ///< K: rows of quads that were replaced.
  int rows = 0;               ///< N: rows of the layer.
  double first = 0.0;         ///< Prescribed height of the first row, 0: none.
  double minimumHeight = 0.0; ///< Of the first row, normal to the wall.
  double maximumHeight = 0.0; ///< Of the first row, normal to the wall.
  double meanThickness = 0.0; ///< Length across all rows.
  /// Part of the length of the side whose first row deviates at most 5 % from the prescribed
  /// height.
  double partInBounds = 0.0;
  double largestGrowth = 1.0; ///< Maximum ratio of the heights of neighbouring rows of the layer.
  /// Maximum ratio of the heights above their common side of a quad in the rows of the layer, also
  /// beyond the ends of the side, and a neighbour.
  double largestRatio = 1.0;
  double ratio99 = 1.0; ///< That ratio, exceeded by one of a hundred pairs of neighbours.
  std::string lack;     ///< Why fewer rows were replaced than the growth needs; empty otherwise.
};

/// Measures the layers of a mesh. rows[e] is the number of rows beside edge e of mesh.boundary.
/// Heights are distances from the line through the edge at the wall. Requires that every side of
/// the prescriptions has an edge.
std::vector<LayerReport> MeasureLayers(const LayeredMesh& layered, const std::vector<int>& rows);
}
