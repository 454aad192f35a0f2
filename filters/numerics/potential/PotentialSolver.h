#pragma once

#include "DirichletSolver.h"
#include "HoleResponse.h"
#include "Lazy.h"
#include "PeriodResponse.h"
#include "PlanarTopology.h"

#include <array>

namespace crossfield
{
/// The potentials of a mesh: its Laplacian, factored once with a natural boundary, and what follows
/// from the factor. It is the one linear solver behind the unit-norm field, the constrained field
/// and everything derived from a potential (docs/method.md §2.3).
///
/// It depends on the mesh alone. Corners, quarter indices and the alignment of the boundary come
/// with the right-hand sides, so any number of problems share one factor.
///
/// The responses of holes and of periods and the Dirichlet solver are made when they are first used.
/// Every member function may be called from several threads at once.
class PotentialSolver
{
public:
  using Periods = PotentialOperator::Periods;

  /// Throws Error when the mesh is not connected or has degenerate triangles.
  explicit PotentialSolver(SharedPlanarTopology topology, const Progress& progress = {});
  /// Not copyable, because its parts store references to each other.
  PotentialSolver(const PotentialSolver&) = delete;
  PotentialSolver& operator=(const PotentialSolver&) = delete;

  const PlanarTopology& GetTopology() const { return *this->Topology; }
  const SharedPlanarTopology& ShareTopology() const { return this->Topology; }
  const PotentialOperator& GetOperator() const { return this->Operator; }
  const PotentialFactor& GetFactor() const { return this->Factor; }
  /// Returns L⁻¹ ∇ᵀ for the edges of holes.
  const HoleElimination& GetHoles() const;
  const HoleResponse& GetHoleResponse(Periods periods) const;
  /// Returns the potentials for unit sources at the periods of inner loops.
  const PeriodResponse& GetPeriodResponse() const;
  /// Returns the solver with a Dirichlet boundary, which energies need and fields do not.
  const DirichletSolver& GetDirichlet() const;

  /// The following functions forward to those of the same name of the operator or the factor.
  Eigen::Index Rows() const { return this->Operator.Rows(); }
  Eigen::Index PeriodCount(Periods periods = Periods::IslandsAndHoles) const
  {
    return this->Operator.PeriodCount(periods);
  }
  Eigen::Index PeriodRow(Eigen::Index k) const { return this->Operator.PeriodRow(k); }
  Eigen::MatrixXd Gradient(const Eigen::MatrixXd& potentials) const
  {
    return this->Operator.Gradient(potentials);
  }
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& sources, Periods periods) const
  {
    return this->Factor.Solve(sources, periods);
  }
  /// Solves with sources at the periods that make them zero, for each column: the potentials are
  /// single-valued around inner loops. The map from sources at vertices to the result is symmetric.
  Eigen::MatrixXd SolveSingleValued(const Eigen::MatrixXd& sources) const;

private:
  SharedPlanarTopology Topology;
  PotentialOperator Operator;
  PotentialFactor Factor;
  Lazy<HoleElimination> Holes;
  std::array<Lazy<HoleResponse>, 2> Responses; ///< By Periods.
  Lazy<PeriodResponse> PeriodSources;
  Lazy<DirichletSolver> Dirichlet;
};
}
