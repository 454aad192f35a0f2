#pragma once

#include "OptimizerStage.h"

#include <vector>

namespace crossfield
{
/// Returns the coefficient of log(1/ρ) of a corner with a quarter index: s²/(2α), where s is the
/// jump of the phase and α the angle (docs/method.md §6.4).
double CornerCoefficient(const Corner& corner, int quarters);

/// Returns the scaled Jacobian that quads can have at a boundary point of angle α with quarter index
/// k: sin(α / m) with m = 2 − k quads, 0 if there are none or α / m ≥ π.
double CornerQuality(double angle, int quarters);

/// Part of a quad within which the boundary counts for the angle that the quads have to fill.
constexpr double PartSeen = 0.35;

/// Returns the size of quads at a loop, which has at least eight along it.
double QuadSizeAt(double quadSize, double loopLength);

/// Boundary vertices of a stage as corners, with the quarter index of each.
struct BoundaryVertices
{
  std::vector<Corner> vertices;
  std::vector<int> quarters;
  std::vector<std::size_t> next; ///< The vertex after each one on its loop.
  std::vector<std::size_t> previous;
  double reach = 0.0; ///< Distance below which two points are considered equal.
  double quadSize = 0.0;
  std::vector<double> loopLengths; ///< By Corner::loop.

  explicit BoundaryVertices(const OptimizerStage& stage);
  /// Returns the vertex at a point, or the number of vertices if there is none.
  std::size_t At(const Point& position) const;
  /// Returns the length of the loop of a vertex.
  double LoopLength(std::size_t vertex) const;
  /// Returns the angle at a vertex that quads have to fill: the angle between the points of the
  /// boundary at 0.35 of the size of quads, which are smaller there than elsewhere. They are closer
  /// where quads must be even smaller: at most a quarter of the distance to another vertex with a
  /// quarter index away, and on short loops quads are at most an eighth of the length. Indices at
  /// `ignored` are not regarded.
  double AngleForQuads(std::size_t vertex, std::size_t ignored) const;
  /// Returns whether a vertex may have a quarter index: whether its CornerQuality is at least 0.5,
  /// or the best of all indices. A positive index must also be one quad away from others: between
  /// two of them, all quads across the domain would end. `ignored` is a vertex whose index will be
  /// removed.
  bool Allows(std::size_t vertex, int index, std::size_t ignored) const;
  bool Allows(std::size_t vertex, int index) const
  {
    return this->Allows(vertex, index, this->vertices.size());
  }
  /// Returns whether a point is a vertex where the boundary does not turn by a quarter: its
  /// smallest rotation has index 0.
  bool IsSmooth(const Point& position) const;

private:
  /// Returns the size of quads at the loop of a vertex.
  double QuadRange(std::size_t vertex) const;
  /// Returns the distance along the boundary to another vertex with an index, at most `range`.
  double DistanceToIndex(std::size_t vertex, std::size_t ignored, double range) const;
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
/// Returns the nearest boundary vertex within a distance whose index may be changed by `quarters`,
/// or the number of vertices if there is none.
std::size_t NearestAllowedVertex(
  const BoundaryVertices& boundary, const Point& position, double distance, int quarters);

/// Returns a multiple of the clearance or of CoreRadius, whichever is smaller, as a length: the range
/// in which W attracts a singularity does not grow with the clearance. The result is at least twice
/// the clearance, the range of the barrier.
double ClearanceRange(const OptimizerStage& stage, double clearances);
/// Returns the maximum move of a singularity along the boundary, a length.
double VertexReach(const OptimizerStage& stage);

struct VertexEnergy
{
  std::size_t vertex; ///< The number of vertices if no vertex is allowed.
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
