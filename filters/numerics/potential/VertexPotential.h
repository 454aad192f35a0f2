#pragma once

#include "PeriodResponse.h"

namespace crossfield
{
/// The potential Φ = 4H of singularities at vertices, on any mesh without holes (docs/method.md §22.2).
/// With the curvature K_v = 2π minus the sum of angles inside, the turning τ_v of the boundary, and the
/// quarter index k_v of each vertex, it solves
///   (K Φ)_v = 4 K_v − 2π k_v inside,   (K Φ)_v = 4 τ_v − 2π k_v on the boundary
/// by P1 elements without logarithms. A singularity takes part by its vertex alone, so the method needs
/// no common frame of the triangles.
///
/// Immutable: Solve may be called from several threads at once.
class VertexPotential
{
public:
  /// Throws Error as PotentialFactor does, and if the mesh has holes.
  explicit VertexPotential(SharedTopology topology, const Progress& progress = {});
  /// Not copyable, because its parts store references to each other.
  VertexPotential(const VertexPotential&) = delete;
  VertexPotential& operator=(const VertexPotential&) = delete;

  struct Solution
  {
    Eigen::VectorXd potential; ///< Φ, single-valued, up to a constant; rows of PotentialOperator.
    /// Per cycle of the mesh, by how much the phase 4θ fails to return to itself, or at both ends of a
    /// strip between loops to the direction of the boundary, in radians, in (−π, π].
    std::vector<double> holonomyDefect;
    /// The harmonic function of least energy that closes the phase around handles if it is added to it; rows of
    /// PotentialOperator. Its periods are steps across the strips; it has none around inner loops.
    Eigen::VectorXd phaseShift;
  };

  /// Solves for the quarter indices of all vertices. Throws Error unless they add up to 4χ.
  Solution Solve(const std::vector<int>& quarters) const;

  const MeshTopology& GetTopology() const { return this->Operator.GetTopology(); }
  const PotentialOperator& GetOperator() const { return this->Operator; }

private:
  Eigen::VectorXd ShiftFor(const std::vector<double>& holonomyDefect) const;

  PotentialOperator Operator;
  PotentialFactor Factor;
  PeriodResponse Response;
  Eigen::VectorXd Curvatures; ///< 4 K_v or 4 τ_v, per row.
  Eigen::VectorXd Wanted;     ///< Phase that fits each cycle, modulo 2π.
  /// Per cycle a row, per column of the response a column: its growth along a closed strip, its period at
  /// a strip between loops.
  Eigen::MatrixXd Growth;
};
}
