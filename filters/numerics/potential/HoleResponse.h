#pragma once

#include "PotentialFactor.h"

namespace crossfield
{
/// Returns ∇ᵀ: the sources of a potential for values x on the edges of holes, hole by hole and
/// counter-clockwise. Vertex j joins edges j and j + 1 of the hole's BoundaryLoop and has the
/// source x_j − x_{j+1}; a hole's period has −x at the last edge of its strip (docs/method.md
/// §3.3).
Eigen::SparseMatrix<double> HoleSources(const PotentialOperator& laplacian);

/// V = L⁻¹ ∇ᵀ, which couples the edges of holes to a potential during its solution: between the two
/// halves of PotentialFactor::Solve it yields the differences of the solution on holes, and adds
/// sources there.
///
/// The vertices of holes are ordered by the dissection like all others. V has entries only on the
/// paths of the elimination tree that start at them; no dense matrix over all edges is made.
///
/// Immutable: every member function may be called from several threads at once.
class HoleElimination
{
public:
  using Periods = PotentialOperator::Periods;

  /// Stores a reference to the factor, which must outlive this object.
  explicit HoleElimination(const PotentialFactor& factor);

  /// Returns ∇Ψ on all edges of holes, Ψ the solution.
  Eigen::MatrixXd Differences(const PotentialFactor::Eliminated& eliminated) const
  {
    return this->Columns.TransposeTimes(eliminated);
  }
  /// Adds the sources ∇ᵀx.
  void AddSources(
    PotentialFactor::Eliminated& eliminated, const Eigen::MatrixXd& x, Periods periods) const;

  const PotentialFactor& GetFactor() const { return this->Factor; }
  const DissectedCholesky::SparseEliminated& GetColumns() const { return this->Columns; }

private:
  const PotentialFactor& Factor;
  DissectedCholesky::SparseEliminated Columns; ///< V, a block of columns per hole.
};

/// Response of the edges of holes to sources on them and at periods.
struct HoleResponse
{
  /// S = ∇ K⁻¹ ∇ᵀ, a block per hole. Without periods around holes, constants on holes are in its
  /// kernel; then γ/m times the matrix of ones is added on every hole of m edges, γ the mean of the
  /// diagonal.
  GramMatrix elastic;
  /// ∇ K⁻¹ E: the differences on all edges for a unit source at each unknown period.
  Eigen::MatrixXd periods;

  HoleResponse(const HoleElimination& holes, PotentialOperator::Periods problemPeriods);
};
}
