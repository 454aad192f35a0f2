#pragma once

#include "OptimizerStage.h"

#include <vector>

namespace crossfield
{
/// Returns the coefficient of log(1/ρ) of a corner with a quarter index: s²/(2α), where s is the
/// jump of the phase and α the angle (docs/method.md §6.4).
double CornerCoefficient(const Corner& corner, int quarters);

/// Boundary vertices of a stage as corners, with the quarter index of each.
struct BoundaryVertices
{
  std::vector<Corner> vertices;
  std::vector<int> quarters;
  double reach = 0.0; ///< Distance below which two points are considered equal.

  explicit BoundaryVertices(const OptimizerStage& stage);
  /// Returns whether a point is a vertex where the boundary does not turn by a quarter: its
  /// smallest rotation has index 0.
  bool IsSmooth(const Point& position) const;
};

/// Returns the row of the singularity at a point, or the number of rows if there is none.
std::size_t RowAt(const OptimizerStage& stage, const Point& position);

/// Returns the configuration in which the quarter index of one row is added to that of boundary
/// vertex v.
TrackedConfiguration MovedToVertex(const OptimizerStage& stage, TrackedConfiguration tracked,
  std::size_t row, const BoundaryVertices& boundary, std::size_t v);
}
