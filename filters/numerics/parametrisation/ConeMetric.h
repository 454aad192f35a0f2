#pragma once

#include "MeshTopology.h"
#include "SeamlessMap.h"

#include <array>
#include <vector>

namespace crossfield
{
/// The three angles of a triangle and their cotangents, at the vertices in its order.
struct MetricAngles
{
  std::array<double, 3> angle{}; ///< Radians.
  std::array<double, 3> cotangent{};
};

/// Returns the side of a triangle after another, counter-clockwise.
inline int NextSide(int side)
{
  return (side + 1) % 3;
}

/// Returns the angles of a triangle from the logarithms of its sides; side i + 1 is opposite to
/// vertex i. Those of a triangle that violates the triangle inequality are 0 and π.
MetricAngles AnglesFromLogLengths(const std::array<double, 3>& logs);

/// A piecewise flat metric on a triangulation of a domain or surface (docs/method.md §12.4, §22.9): a length
/// per edge, and the integers of the crosses, which are parallel to the axes of a chart on every
/// triangle.
///
/// Side i of a triangle runs from its vertex i to the next one. With ψ the direction of a directed
/// side in the chart of its triangle, the same side in the neighbour's chart has direction
/// ψ + π + jump · π/2; on the boundary the direction should be jump · π/2.
///
/// Flips and splits change neither the metric nor the domain.
class ConeMetric
{
public:
  struct Triangle
  {
    std::array<int, 3> vertices{};
    std::array<int, 3> edges{};
    /// Triangle across each side; −1 − i at entry i of Boundary().
    std::array<int, 3> neighbours{};
    std::array<int, 3> jumps{};
  };
  /// A side of a triangle.
  struct Side
  {
    int triangle = -1;
    int side = -1;
  };

  /// Constructs the metric of a mesh. `jumps` are those of TriangleFrames with continuous
  /// branches or not, `cones` the vertices with angles other than 2π, or π on the boundary. The
  /// directions of a boundary loop follow from that of its first edge.
  ConeMetric(const MeshTopology& topology, const std::vector<std::array<int, 3>>& jumps,
    const std::vector<Cone>& cones);

  const std::vector<SpacePoint>& Points() const { return this->Positions; }
  bool IsInPlane() const { return this->InPlane; }
  const std::vector<Triangle>& Triangles() const { return this->AllTriangles; }
  const std::vector<BoundaryEdge>& Boundary() const { return this->BoundaryEdges; }
  /// Returns the triangulation with x and y of its points, which say nothing on a surface.
  TriangleMesh Triangulation() const;
  /// Returns the side of a triangle at an entry of Boundary().
  Side AtBoundary(int entry) const { return this->BoundarySides[entry]; }
  /// Returns the logarithms of the lengths of all edges.
  const std::vector<double>& LogLengths() const { return this->Logs; }
  void SetLogLengths(std::vector<double> logs);
  /// Returns the angle that a vertex should have, in quarter turns.
  int QuartersAt(int vertex) const { return this->Quarters[vertex]; }
  /// Returns entries of Boundary() on the outer loop and on every inner loop; none if there is no boundary.
  const std::vector<int>& LoopStarts() const { return this->Starts; }

  double Length(int edge) const;
  const MetricAngles& AnglesOf(int triangle) const { return this->Angles[triangle]; }
  /// Returns whether all triangles satisfy the triangle inequality.
  bool IsValid() const;
  /// Returns the area of a triangle in the metric.
  double AreaOf(int triangle) const;
  /// Returns the angle of a corner of a triangle on the surface.
  double AngleOnSurface(int triangle, int corner) const;
  /// Returns the side of the neighbour across a side.
  Side Across(Side side) const;

  /// Turns the directions of the boundary loop of an entry of LoopStarts() by quarter turns.
  void TurnLoop(std::size_t loop, int quarters);

  /// Returns the logarithm of the length of the other diagonal of the quadrilateral of two triangles.
  double LogOtherDiagonal(Side side) const;
  /// Replaces the edge between two triangles by the other diagonal of their quadrilateral, which
  /// must be convex in the metric and on the surface, where it must be flat.
  void Flip(Side side);
  /// Divides an edge, and the triangles at it, at a fraction of its length from the first vertex of
  /// the side.
  void Split(Side side, double fraction);

private:
  /// Sets the angles of a triangle from its lengths.
  void Measure(int triangle);
  /// Sets the neighbours' references to a triangle.
  void Attach(int triangle);
  /// Turns the chart of a triangle so that the jump across a side is 0.
  void AlignCharts(Side side);
  /// Sets the directions of the loop of a boundary entry from its own.
  void PropagateDirections(int entry);
  /// Returns the boundary entry that follows on its loop, and the jumps between their triangles.
  std::pair<int, int> NextOnLoop(int entry) const;

  const bool InPlane;
  std::vector<SpacePoint> Positions;
  std::vector<Triangle> AllTriangles;
  std::vector<BoundaryEdge> BoundaryEdges;
  std::vector<Side> BoundarySides;
  std::vector<double> Logs;
  std::vector<MetricAngles> Angles; ///< Of every triangle, as they take most of the time.
  std::vector<int> Quarters;
  std::vector<int> Starts;
};
}
