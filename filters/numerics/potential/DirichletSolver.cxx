#include "DirichletSolver.h"

namespace crossfield
{
DirichletSolver::DirichletSolver(const PotentialOperator& laplacian)
  : Factor(laplacian, PotentialFactor::Boundary::Dirichlet)
  , OfIslands(laplacian.Rows(), laplacian.PeriodCount(PotentialOperator::Periods::Islands))
{
  const MeshTopology& topology = laplacian.GetTopology();
  Eigen::Index k = 0;
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind == BoundaryKind::Inner)
    {
      Eigen::VectorXd one = Eigen::VectorXd::Zero(laplacian.Rows());
      for (const int edge : loop.edges)
      {
        one[topology.BoundaryAt(edge).vertices[0]] = 1.0;
      }
      this->OfIslands.col(k) = this->HarmonicSources(one);
      ++k;
    }
  }
  this->Coupling = this->SumAroundIslands(this->OfIslands);
  if (this->Coupling.size() > 0)
  {
    this->CouplingFactor.compute(this->Coupling);
  }
}

Eigen::MatrixXd DirichletSolver::SumAroundIslands(const Eigen::MatrixXd& sources) const
{
  const MeshTopology& topology = this->Factor.GetOperator().GetTopology();
  Eigen::MatrixXd sums =
    Eigen::MatrixXd::Zero(topology.LoopCount(BoundaryKind::Inner), sources.cols());
  Eigen::Index k = 0;
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind == BoundaryKind::Inner)
    {
      for (const int edge : loop.edges)
      {
        sums.row(k) += sources.row(topology.BoundaryAt(edge).vertices[0]);
      }
      ++k;
    }
  }
  return sums;
}

Eigen::MatrixXd DirichletSolver::Harmonic(const Eigen::MatrixXd& x) const
{
  // No period is unknown, so which of them the problem has makes no difference.
  return x +
    this->Factor.Solve(
      -this->Factor.GetOperator().Apply(x), PotentialOperator::Periods::IslandsAndHoles);
}
}
