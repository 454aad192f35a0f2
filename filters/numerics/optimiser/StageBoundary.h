#pragma once

#include "OptimizerStage.h"

#include <vector>

namespace crossfield
{
/// Coefficient of log(1/ρ) of a corner with a quarter index: s²/(2α), s the jump of the phase
/// (docs/method.md §6.4).
double CornerCoefficient(const Corner& corner, int quarters);

/// The boundary vertices of a stage as corners, with the quarter index that each has.
struct BoundaryVertices
{
  std::vector<Corner> vertices;
  std::vector<int> quarters;
  double reach = 0.0; ///< Nearer than this is the same place.

  explicit BoundaryVertices(const OptimizerStage& stage);
  /// Whether a place is a vertex that takes no quarter index of its own.
  bool IsSmooth(const Point& position) const;
};

/// Row of a singularity at a place, or the number of rows.
std::size_t RowAt(const OptimizerStage& stage, const Point& position);

/// The configuration with the quarters of one row added to those of boundary vertex v.
TrackedConfiguration MovedToVertex(const OptimizerStage& stage, TrackedConfiguration tracked,
  std::size_t row, const BoundaryVertices& boundary, std::size_t v);
}
