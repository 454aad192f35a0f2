#include "PotentialSolver.h"

#include "DenseProduct.h"

#include <utility>

namespace crossfield
{
PotentialSolver::PotentialSolver(SharedPlanarTopology topology, const Progress& progress)
  : Topology(std::move(topology))
  , Operator(this->Topology)
  , Factor(this->Operator, PotentialFactor::Boundary::Natural, progress)
{
}

const HoleElimination& PotentialSolver::GetHoles() const
{
  return this->Holes.Get([this] { return std::make_unique<const HoleElimination>(this->Factor); });
}

const HoleResponse& PotentialSolver::GetHoleResponse(Periods periods) const
{
  return this->Responses[periods == Periods::Islands ? 0 : 1].Get(
    [&] { return std::make_unique<const HoleResponse>(this->GetHoles(), periods); });
}

const PeriodResponse& PotentialSolver::GetPeriodResponse() const
{
  return this->PeriodSources.Get(
    [this] { return std::make_unique<const PeriodResponse>(this->Factor); });
}

const DirichletSolver& PotentialSolver::GetDirichlet() const
{
  return this->Dirichlet.Get(
    [this] { return std::make_unique<const DirichletSolver>(this->Operator); });
}

Eigen::MatrixXd PotentialSolver::SolveSingleValued(const Eigen::MatrixXd& sources) const
{
  Eigen::MatrixXd solution = this->Solve(sources, Periods::Islands);
  const PeriodResponse& response = this->GetPeriodResponse();
  const Eigen::Index periods = response.basis.cols();
  if (periods > 0)
  {
    solution -=
      DenseProduct(response.basis, DenseProduct(response.schur, solution.bottomRows(periods)));
    solution.bottomRows(periods).setZero();
  }
  return solution;
}
}
