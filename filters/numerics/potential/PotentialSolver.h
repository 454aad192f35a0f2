#pragma once

#include "DissectedCholesky.h"
#include "LoopStrip.h"
#include "MeshTopology.h"
#include "Progress.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <memory>
#include <mutex>

namespace crossfield
{
/// The P1 Laplacian of a mesh, factored once: the one linear solver behind the unit-norm field, the
/// constrained field and everything derived from a potential (docs/method.md §2.3).
///
/// It depends on the mesh alone: what is asked of it (corners, quarter indices, where the boundary is
/// aligned) comes with the right-hand sides, so any number of questions share one factor.
///
/// Unknowns are the values of a potential Ψ at the vertices, and one period q_k per inner loop and
/// hole: the amount by which Ψ grows along a closed way around it with the domain on the left. Ψ with periods is Ψ + Σ q_k η_k with the
/// cut functions η_k of LoopStrip, which have a gradient on their strips only. The matrix is
///   [ K  r ; rᵀ R ],  r_k = Σ_T K_T η_k|T,  R_kl = Σ_T η_k|Tᵀ K_T η_l|T,
/// that of the energy ½ ∫ |∇Ψ + Σ q_k ∇η_k|², positive semidefinite with the constants as kernel.
/// One vertex of the outer loop, the ground, is left out to remove it.
///
/// What the right-hand sides mean, when φ is the conjugate of Ψ: ∇φ = rot ∇Ψ, rot = +90°, φ at the
/// midpoints of edges (Crouzeix-Raviart):
/// - at a boundary vertex: φ on the boundary edge after it minus φ on the one before, walking with
///   the domain on the left; at an interior vertex: −2π times the turns of φ around it;
/// - at a period: φ on the strip's first edge minus φ on its last edge.
///
/// Holes lie in the dissection like everything else. What their edges feel of each other follows from the ways of the
/// elimination tree that their vertices take (HoleResponse); no matrix over all of them is made. The periods, those of inner loops
/// before those of holes, come last in the factorisation: a question without periods around holes takes the leading part of it.
///
/// Where the boundary is given (Boundary::Given), the values at the vertices of outer and inner loops
/// and the periods are no unknowns but zero in every solution; with inhomogeneous values x, solve for
/// the sources minus Apply(x) and add x.
class PotentialSolver
{
public:
  /// Which loops have a period in a question; those of the others are zero. A hole needs one only where
  /// its edges are not free to shift by a common constant.
  enum class Periods
  {
    Islands,
    IslandsAndHoles
  };

  /// What holds on outer and inner loops.
  enum class Boundary
  {
    Natural, ///< ∂Ψ/∂ν is a source.
    Given    ///< Ψ and the periods are given.
  };

  /// Throws Error when the mesh is not connected or has degenerate triangles.
  explicit PotentialSolver(
    SharedTopology topology, Boundary boundary = Boundary::Natural, const Progress& progress = {});

  const MeshTopology& GetTopology() const { return *this->Topology; }
  const SharedTopology& ShareTopology() const { return this->Topology; }

  /// Vertices of the mesh plus periods, those of inner loops before those of holes: rows of every
  /// right-hand side and solution.
  Eigen::Index Rows() const { return this->VertexCount + this->PeriodCount(); }
  Eigen::Index PeriodCount(Periods periods = Periods::IslandsAndHoles) const
  {
    return periods == Periods::Islands ? this->IslandCount
                                       : static_cast<Eigen::Index>(this->Strips.size());
  }
  /// Row of the k-th period.
  Eigen::Index PeriodRow(Eigen::Index k) const { return this->VertexCount + k; }
  /// One per period.
  const std::vector<LoopStrip>& GetStrips() const { return this->Strips; }

  /// Lower triangular L with L Lᵀ the Schur complement on the periods of a question; empty where the boundary is given.
  Eigen::Ref<const Eigen::MatrixXd> PeriodFactor(Periods periods) const
  {
    const Eigen::Index count = this->TrailingCount(periods);
    return this->Factor->GetTrailingFactor().topLeftCorner(count, count);
  }

  /// ∇ᵀ: the sources of a potential from values x on the edges of holes, hole by hole and counter-clockwise. Vertex j joins
  /// edges j and j + 1 of the hole's BoundaryLoop and has the source x_j − x_{j+1}; a hole's period has −x at the last edge of its
  /// strip (docs/method.md §3.3).
  const Eigen::SparseMatrix<double>& HoleSources() const { return this->Differences; }

  /// What edges of holes do to each other through the potential.
  struct HoleResponse
  {
    GramMatrix elastic; ///< S = ∇ K⁻¹ ∇ᵀ, a block per hole.
    Eigen::MatrixXd
      periods; ///< ∇ K⁻¹ E: what a unit source at each period of the question does to every edge.
  };
  /// Made when it is first asked for, so not in two threads at once. Where constants on holes do nothing, without periods around them, S is completed by
  /// γ/m times the matrix of ones on every hole, γ the mean of the diagonal.
  const HoleResponse& GetHoleResponse(Periods periods) const;

  /// Solves for any number of columns; the ground, or what is given, is 0 in the result. With a
  /// natural boundary the entries of a column at vertices must add up to zero, or there is no
  /// solution: throws Error with their sum.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides, Periods periods) const
  {
    return this->Substitute(this->Eliminate(rightHandSides, periods));
  }

  /// The two halves of Solve. In between it is known what the sources do on holes and at periods, without the second half, and
  /// sources there can be added, without the first.
  using Eliminated = DissectedCholesky::Eliminated;
  Eliminated Eliminate(const Eigen::MatrixXd& rightHandSides, Periods periods) const;
  Eigen::MatrixXd Substitute(const Eliminated& sources) const
  {
    return this->Factor->Substitute(sources);
  }
  /// ∇Ψ on all edges of holes.
  Eigen::MatrixXd OnHoles(const Eliminated& sources) const;
  /// Ψ's periods, those of the question.
  Eigen::MatrixXd AtPeriods(const Eliminated& sources, Periods periods) const;
  /// Adds ∇ᵀx.
  void AddOnHoles(Eliminated& sources, const Eigen::MatrixXd& x, Periods periods) const;
  /// Adds sources at the periods of the question.
  void AddAtPeriods(Eliminated& sources, const Eigen::MatrixXd& atPeriods, Periods periods) const;

  /// Gradient ∇Ψ + Σ q_k ∇η_k on every triangle: a column per triangle, two rows per column of the
  /// solution.
  Eigen::MatrixXd Gradient(const Eigen::MatrixXd& solutions) const;

  /// The whole matrix, ground and given boundary included, times (Ψ, q): the sources of a potential.
  Eigen::VectorXd Apply(const Eigen::VectorXd& solution) const;

  /// The same Laplacian with the boundary given, factored when it is first asked for: energies take it, fields do not.
  const PotentialSolver& OfGivenBoundary() const;

  /// Where the boundary is given: the sources of the potential with values x at its vertices and periods, zero at the vertices inside,
  /// where it is harmonic.
  Eigen::VectorXd HarmonicSources(const Eigen::VectorXd& x) const
  {
    return this->Apply(x + this->Solve(-this->Apply(x), Periods::Islands));
  }
  /// Those of the potentials that are 1 on one inner loop and 0 on all other loops, a column each. Made when it is first asked for.
  const Eigen::MatrixXd& IslandSources() const;

private:
  /// How many unknowns that come last, periods, a question has.
  Eigen::Index TrailingCount(Periods periods) const
  {
    return this->OnLoops == Boundary::Natural ? this->PeriodCount(periods) : 0;
  }

  /// L⁻¹ ∇ᵀ. Made when it is first asked for.
  const DissectedCholesky::SparseEliminated& EliminatedHoles() const;
  /// Zero here is zero after back substitution: periods that the question does not have.
  void LeaveOutPeriods(Eliminated& sources, Periods periods) const;

  SharedTopology Topology;
  Eigen::Index VertexCount;
  Eigen::Index IslandCount;
  std::vector<LoopStrip> Strips;
  Boundary OnLoops;
  Eigen::SparseMatrix<double> Differences;
  std::unique_ptr<DissectedCholesky> Factor;
  mutable std::once_flag HasOther;
  mutable std::unique_ptr<const PotentialSolver> Other; ///< Of OfGivenBoundary.
  mutable std::once_flag HasIslands;
  mutable Eigen::MatrixXd OfIslands; ///< IslandSources.
  mutable std::unique_ptr<const DissectedCholesky::SparseEliminated> Holes;
  mutable std::array<std::unique_ptr<const HoleResponse>, 2> Responses; ///< By Periods.
};
}
