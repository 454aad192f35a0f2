#include "PotentialSolver.h"

#include <utility>

namespace crossfield
{
PotentialSolver::PotentialSolver(SharedTopology topology, const Progress& progress)
  : Operator(std::move(topology))
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
}
