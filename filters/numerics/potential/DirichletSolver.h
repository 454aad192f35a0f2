#pragma once

#include "PotentialFactor.h"

#include <Eigen/Cholesky>

namespace crossfield
{
/// Harmonic potentials with prescribed values on outer and inner loops and prescribed periods, on a
/// mesh whose Laplacian is factored for the inner vertices.
///
/// Immutable: every member function may be called from several threads at once.
class DirichletSolver
{
public:
  /// Stores a reference to the operator, which must outlive this object.
  explicit DirichletSolver(const PotentialOperator& laplacian);

  const PotentialFactor& GetFactor() const { return this->Factor; }

  /// Returns the potential with the values of x at the vertices of outer and inner loops and at
  /// periods, and with no source elsewhere. x is zero at the vertices inside.
  /// Any number of columns.
  Eigen::MatrixXd Harmonic(const Eigen::MatrixXd& x) const;

  /// Returns the sources of Harmonic(x), which are at the vertices of outer and inner loops and at
  /// periods, and zero inside.
  Eigen::MatrixXd HarmonicSources(const Eigen::MatrixXd& x) const;

  /// The sources of the harmonic potentials that are 1 on one inner loop and 0 on all other loops:
  /// a column per inner loop.
  const Eigen::MatrixXd& IslandSources() const { return this->OfIslands; }

  /// Sums sources over the vertices of every inner loop.
  Eigen::MatrixXd SumAroundIslands(const Eigen::MatrixXd& sources) const;
  /// The sums of IslandSources: ∫ ∇φ_k · ∇φ_l of their potentials.
  const Eigen::MatrixXd& IslandCoupling() const { return this->Coupling; }
  /// Returns the factor of the coupling.
  const Eigen::LLT<Eigen::MatrixXd>& GetCouplingFactor() const { return this->CouplingFactor; }

private:
  PotentialFactor Factor;
  std::vector<int> Prescribed; ///< Rows of the vertices of outer and inner loops, and of periods.
  Eigen::SparseMatrix<double> Columns; ///< The columns of the operator for these rows.
  Eigen::MatrixXd OfIslands;           ///< See IslandSources.
  Eigen::MatrixXd Coupling;            ///< See IslandCoupling.
  Eigen::LLT<Eigen::MatrixXd> CouplingFactor;
};
}
