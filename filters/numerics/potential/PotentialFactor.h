#pragma once

#include "DissectedCholesky.h"
#include "PotentialOperator.h"
#include "Progress.h"

namespace crossfield
{
/// A factorisation of a PotentialOperator under one boundary condition; it solves for any number of
/// right-hand sides.
///
/// With a natural boundary, one vertex, the ground, on the outer loop if there is one, is left out to
/// remove the constants from the kernel. The periods come last in the elimination order, those of holes
/// after the others, so a problem without periods around holes uses the leading part of L.
///
/// With a Dirichlet boundary, the values at the vertices of outer and inner loops and all periods
/// are zero in every solution. For prescribed values x there, solve for the sources minus Apply(x)
/// and add x.
///
/// Immutable: every member function may be called from several threads at once.
class PotentialFactor
{
public:
  using Periods = PotentialOperator::Periods;

  enum class Boundary
  {
    Natural,  ///< ∂Ψ/∂ν on outer and inner loops is a source.
    Dirichlet ///< Ψ on outer and inner loops and all periods are prescribed.
  };

  /// Stores a reference to the operator, which must outlive this object. Throws Error when the mesh
  /// has degenerate triangles, and NotPositiveDefinite when it is not connected.
  PotentialFactor(
    const PotentialOperator& laplacian, Boundary boundary, const Progress& progress = {});

  const PotentialOperator& GetOperator() const { return this->Operator; }

  /// Solves for any number of columns; the ground, or the prescribed rows, are 0 in the result.
  /// With a natural boundary the entries of a column at vertices must add up to zero, or there is
  /// no solution: throws Error with their sum.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& sources, Periods periods) const
  {
    return this->Substitute(this->Eliminate(sources, periods));
  }

  /// The two halves of Solve: L⁻¹ b and L⁻ᵀ of that. From L⁻¹ b, the solution at the periods and
  /// its differences on holes (HoleElimination) follow without the second half, and sources there
  /// can be added without repeating the first.
  using Eliminated = DissectedCholesky::Eliminated;
  Eliminated Eliminate(const Eigen::MatrixXd& sources, Periods periods) const;
  Eigen::MatrixXd Substitute(const Eliminated& eliminated) const
  {
    return this->Factor.Substitute(eliminated);
  }
  /// Returns L⁻¹ B for every B of `blocks`, sparse matrices with Rows() rows.
  DissectedCholesky::SparseEliminated EliminateSparse(
    const std::vector<Eigen::SparseMatrix<double>>& blocks) const
  {
    return this->Factor.EliminateSparse(blocks);
  }

  /// Returns the number of periods that are unknowns: none with a Dirichlet boundary.
  Eigen::Index UnknownPeriodCount(Periods periods) const
  {
    return this->OnLoops == Boundary::Natural ? this->Operator.PeriodCount(periods) : 0;
  }
  /// Returns the lower triangular L with L Lᵀ the Schur complement on the unknown periods.
  Eigen::Ref<const Eigen::MatrixXd> PeriodFactor(Periods periods) const
  {
    const Eigen::Index count = this->UnknownPeriodCount(periods);
    return this->Factor.GetTrailingFactor().topLeftCorner(count, count);
  }
  /// Returns the solution at the unknown periods.
  Eigen::MatrixXd PeriodValues(const Eliminated& eliminated, Periods periods) const;
  /// Adds sources at the unknown periods.
  void AddPeriodSources(
    Eliminated& eliminated, const Eigen::MatrixXd& sources, Periods periods) const;
  /// Sets to zero the rows of the periods that the problem does not have, which makes them zero in
  /// the solution.
  void LeaveOutPeriods(Eliminated& eliminated, Periods periods) const;

private:
  const PotentialOperator& Operator;
  Boundary OnLoops;
  DissectedCholesky Factor;
};
}
