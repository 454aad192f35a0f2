#pragma once

#include "AlignedSources.h"
#include "LogSource.h"
#include "Singularity.h"

namespace crossfield
{
/// Half of a boundary edge, with the domain on its left: the part of the boundary that one vertex
/// stands for.
struct BoundaryHalf
{
  int vertex = 0;
  Point from = Point::Zero();
  Point to = Point::Zero();
};

/// The potential of singularities that are points, on a mesh without holes (docs/method.md §5.3, §11.3):
///   Φ = R + Σ_j d_j log|x − b_j| + Σ_c s_c / (−α_c) log|x − p_c|,
/// b_j the singularities, p_c the corners of angle α_c at which the phase has to turn by s_c ≠ 0.
/// The regular part R is a P1 function with periods. Its sources at a boundary vertex v are those of
/// alignment minus the angles at which all b_j, p_c see the two halves of edges at v, times the
/// strengths: there are no deltas on the mesh, and the phase of R plus the exact arguments is that of
/// CurvePhase on every boundary edge. The mesh is factored once; a further configuration costs one back-substitution, or
/// none but small sums when only the boundary values are asked for.
class PointPotential
{
public:
  /// What one configuration leads to.
  struct Solution
  {
    std::vector<LogSource> logs;        ///< The singularities in their order, then the corners.
    Eigen::VectorXd sources;            ///< Of R; rows of PotentialSolver.
    Eigen::VectorXd regular;            ///< R, single-valued.
    Eigen::VectorXd aligned;            ///< R with the periods that align inner loops.
    std::vector<double> holonomyDefect; ///< See AlignedPotential.
    Eigen::VectorXd offsets;            ///< The same with the turns that were chosen.
    Eigen::VectorXd periods;            ///< Of R around inner loops, zero where the offsets are.
  };

  /// `alignment` with the sum of the quarter indices of every configuration to come. Throws Error when
  /// that violates Poincaré-Hopf, or when the mesh has holes.
  PointPotential(std::shared_ptr<const PotentialSolver> solver, Alignment alignment);

  /// Throws Error when a singularity is not inside the domain, or nearer to its boundary than 1e-6 of
  /// the diagonal or to another one, or the sum of the quarter indices is another one.
  Solution Solve(const Configuration& configuration) const;

  const PlanarDomain& GetDomain() const { return this->Domain; }
  const PotentialProblem& GetProblem() const { return this->Problem; }
  const std::vector<BoundaryHalf>& GetHalves() const { return this->Halves; }
  /// The corners' logarithms.
  const std::vector<LogSource>& GetCorners() const { return this->Corners; }
  /// Mesh vertex of each corner with a logarithm.
  const std::vector<int>& GetCornerVertices() const { return this->CornerVertices; }
  /// φ at the midpoints of boundary edges minus 4τ; see CurvePhase.
  const Eigen::VectorXd& GetMidpointShift() const { return this->Sources.midpointShift; }
  /// Sources of alignment without the corners that have a logarithm.
  const Eigen::VectorXd& GetSmoothSources() const { return this->Smooth; }
  /// Per inner loop the solution for a unit source at its period.
  const Eigen::MatrixXd& GetPeriodBasis() const { return this->PeriodBasis; }
  /// Midpoints of the boundary edges between which strip k carries the phase.
  std::array<Point, 2> StripEnds(Eigen::Index k) const;

private:
  /// Angle at which a log's position sees the way along strip k from its end to its start.
  double StripTurn(const LogSource& log, Eigen::Index k) const;

  PotentialProblem Problem;
  PlanarDomain Domain; ///< Polygons of the mesh.
  AlignedSources Sources;
  std::vector<BoundaryHalf> Halves;
  std::vector<LogSource> Corners;
  std::vector<int> CornerVertices;
  Eigen::VectorXd Smooth;
  Eigen::MatrixXd PeriodBasis;
  Eigen::MatrixXd PeriodInverse; ///< Of the Schur complement on the periods.
};
}
