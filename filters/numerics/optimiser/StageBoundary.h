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
  std::vector<std::size_t> next; ///< The vertex after each one on its loop.
  std::vector<std::size_t> previous;
  double reach = 0.0; ///< Distance below which two points are considered equal.

  explicit BoundaryVertices(const OptimizerStage& stage);
  /// Returns the vertex at a point, or the number of vertices if there is none.
  std::size_t At(const Point& position) const;
  /// Returns the length of the loop of a vertex.
  double LoopLength(std::size_t vertex) const;
  /// Returns whether a point is a vertex where the boundary does not turn by a quarter: its
  /// smallest rotation has index 0.
  bool IsSmooth(const Point& position) const;
};

/// Returns the row of the singularity within a distance of a point, or the number of rows if there
/// is none.
std::size_t RowAt(const Configuration& configuration, const Point& position, double reach);

/// Returns the configuration in which the quarter index of one row is added to that of boundary
/// vertex v.
TrackedConfiguration MovedToVertex(
  TrackedConfiguration tracked, std::size_t row, const BoundaryVertices& boundary, std::size_t v);

/// Returns the nearest boundary vertex.
std::size_t NearestVertex(const BoundaryVertices& boundary, const Point& position);

/// Returns a multiple of the clearance or of CoreRadius, whichever is smaller, as a length: the range
/// in which W attracts a singularity does not grow with the clearance. The result is at least twice
/// the clearance, the range of the barrier.
double ClearanceRange(const OptimizerStage& stage, double clearances);
/// Returns the maximum move of a singularity along the boundary, a length.
double VertexReach(const OptimizerStage& stage);

struct VertexEnergy
{
  std::size_t vertex;
  double energy;
};

/// Walks from a vertex to its neighbours on the loop, in both directions, as long as the energy
/// decreases. Returns the lowest vertex.
template <class Energy>
VertexEnergy DescendAlongLoop(
  const BoundaryVertices& boundary, std::size_t start, const Energy& energyAt)
{
  VertexEnergy lowest{ start, energyAt(start) };
  for (const std::vector<std::size_t>* neighbours : { &boundary.next, &boundary.previous })
  {
    for (std::size_t v = (*neighbours)[lowest.vertex]; v != start; v = (*neighbours)[v])
    {
      const double energy = energyAt(v);
      if (!(energy < lowest.energy))
      {
        break;
      }
      lowest = { v, energy };
    }
  }
  return lowest;
}
}
