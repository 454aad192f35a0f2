#include "Relaxation.h"

#include "GlpkSolver.h"
#include "GomoryCuts.h"
#include "Index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
constexpr int NotFree = -1;
constexpr int NoBound = std::numeric_limits<int>::max();
}

Relaxation::Relaxation(
  const QuantisationProblem& problem, const std::vector<int>& free, const std::vector<int>& counts)
  : Problem(problem)
  , Free(free)
  , Counts(counts)
  , Solver(MakeGlpkSolver())
  , FirstColumn(problem.Count(), NotFree)
{
  this->AddColumns();
  this->AddEquations();
  this->AddSums();
}

bool Relaxation::IsFree(int arc) const
{
  return this->FirstColumn[arc] != NotFree;
}

void Relaxation::AddColumns()
{
  for (std::size_t i = 0; i < this->Free.size(); ++i)
  {
    this->FirstColumn[this->Free[i]] = 3 * static_cast<int>(i);
  }
  for (std::size_t a = 0; a < this->Problem.Count(); ++a)
  {
    this->Floors.push_back(
      std::max(this->Problem.lower[a], static_cast<int>(std::floor(this->Problem.target[a]))));
  }
  double constant = 0.0;
  for (std::size_t a = 0; a < this->Problem.Count(); ++a)
  {
    if (!this->IsFree(static_cast<int>(a)))
    {
      constant += this->Problem.Cost(a, this->Counts[a]);
    }
  }
  for (const int arc : this->Free)
  {
    const double weight = this->Problem.weight[arc];
    const int below = this->Floors[arc];
    const double fraction = this->Problem.target[arc] - below; // negative below the lower bound
    constant += weight * std::abs(fraction);
    this->AddColumn(weight, below - this->Problem.lower[arc]);
    this->AddColumn(weight * (1.0 - 2.0 * std::max(0.0, fraction)), 1);
    this->AddColumn(weight, NoBound);
  }
  this->Solver->SetConstantCost(constant);
}

void Relaxation::AddColumn(double cost, int upper)
{
  const auto column = static_cast<int>(this->RootBounds.size());
  this->RootBounds.push_back({ column, 0, upper });
  this->Solver->AddColumn(cost, { 0.0, upper == NoBound ? Unbounded : static_cast<double>(upper) });
}

void Relaxation::AddEquations()
{
  std::vector<Terms> equations(Index(this->Problem.equations));
  for (const int arc : this->Free)
  {
    for (const EquationTerm& term : this->Problem.terms[arc])
    {
      equations[term.equation].emplace_back(arc, term.sign);
    }
  }
  std::vector<int> fixedSums(equations.size(), 0);
  for (std::size_t a = 0; a < this->Problem.Count(); ++a)
  {
    if (!this->IsFree(static_cast<int>(a)))
    {
      for (const EquationTerm& term : this->Problem.terms[a])
      {
        fixedSums[term.equation] += term.sign * this->Counts[a];
      }
    }
  }
  for (std::size_t i = 0; i < equations.size(); ++i)
  {
    if (!equations[i].empty())
    {
      this->AddRow(equations[i], RowKind::Equal, -fixedSums[i]);
    }
  }
}

void Relaxation::AddSums()
{
  for (const CountSum& sum : this->Problem.sums)
  {
    Terms negative;
    bool isFree = false;
    for (const auto& [arc, factor] : sum.terms)
    {
      negative.emplace_back(arc, -factor);
      isFree = isFree || this->IsFree(arc);
    }
    if (!isFree)
    {
      continue;
    }
    if (sum.minimum == sum.maximum)
    {
      this->AddRow(sum.terms, RowKind::Equal, sum.minimum);
      continue;
    }
    this->AddRow(sum.terms, RowKind::AtLeast, sum.minimum);
    this->AddRow(negative, RowKind::AtLeast, -sum.maximum);
  }
}

void Relaxation::AddRow(const Terms& terms, RowKind kind, int rhs)
{
  LinearRow row;
  row.rhs = rhs;
  for (const auto& [arc, factor] : terms)
  {
    if (!this->IsFree(arc))
    {
      row.rhs -= factor * this->Counts[arc];
      continue;
    }
    const int first = this->FirstColumn[arc];
    const auto value = static_cast<double>(factor);
    for (const auto& [column, sign] :
      { std::pair(first, -1.0), std::pair(first + 1, 1.0), std::pair(first + 2, 1.0) })
    {
      row.columns.push_back(column);
      row.values.push_back(sign * value);
    }
    row.rhs -= value * this->Floors[arc];
  }
  this->Solver->AddRow(row, kind);
  this->IsCut.push_back(0);
}

void Relaxation::AddRow(const SeparationRow& row)
{
  this->AddRow(row.terms, RowKind::AtLeast, row.minimum);
}

double Relaxation::GetCount(int arc) const
{
  if (!this->IsFree(arc))
  {
    return this->Counts[arc];
  }
  const int first = this->FirstColumn[arc];
  return this->Floors[arc] - this->Solver->GetValue(first) + this->Solver->GetValue(first + 1) +
    this->Solver->GetValue(first + 2);
}

bool Relaxation::IsIntegral(int arc) const
{
  // Far above the accuracy of the simplex method.
  constexpr double NearlyIntegral = 1e-6;
  const double value = this->GetCount(arc);
  return std::abs(value - std::round(value)) < NearlyIntegral;
}

std::vector<int> Relaxation::GetRoundedCounts() const
{
  std::vector<int> counts = this->Counts;
  counts.resize(this->Problem.Count());
  for (const int arc : this->Free)
  {
    counts[arc] = static_cast<int>(std::lround(this->GetCount(arc)));
  }
  return counts;
}

void Relaxation::RemoveLooseCuts()
{
  std::vector<int> loose;
  std::vector<char> kept;
  for (int row = 0; row < this->Solver->CountRows(); ++row)
  {
    const char isCut = this->IsCut[row];
    if (isCut != 0 && this->Solver->GetRowStatus(row) == BasisStatus::Basic)
    {
      loose.push_back(row);
    }
    else
    {
      kept.push_back(isCut);
    }
  }
  this->Solver->RemoveRows(loose);
  this->IsCut = std::move(kept);
}

bool Relaxation::AddCuts()
{
  this->RemoveLooseCuts();
  if (!this->Solver->Factorise())
  {
    return false;
  }
  const std::vector<LinearRow> cuts = GomoryCuts(*this->Solver, this->IsCut);
  for (const LinearRow& cut : cuts)
  {
    this->Solver->AddRow(cut, RowKind::AtLeast);
    this->IsCut.push_back(1);
  }
  return !cuts.empty();
}

void Relaxation::TightenBounds()
{
  // An optimum that has just become the best solution is above the cutoff by rounding.
  const double slack = std::max(0.0, this->Solver->GetCutoff() - this->GetCost());
  for (ColumnBounds& bounds : this->RootBounds)
  {
    const double reduced = std::abs(this->Solver->GetReducedCost(bounds.column));
    // The tolerance of the simplex method for costs; optima are accurate to far less than
    // `Rounding`.
    constexpr double NoCost = 1e-7;
    constexpr double Rounding = 1e-6;
    const double steps = std::floor(slack / std::max(reduced, NoCost) + Rounding);
    if (reduced < NoCost || steps >= bounds.upper - bounds.lower)
    {
      continue;
    }
    const BasisStatus status = this->Solver->GetColumnStatus(bounds.column);
    if (status == BasisStatus::AtLower)
    {
      bounds.upper = bounds.lower + static_cast<int>(steps);
    }
    else if (status == BasisStatus::AtUpper)
    {
      bounds.lower = bounds.upper - static_cast<int>(steps);
    }
    this->SetBounds(bounds);
  }
}

std::vector<ColumnBounds> Relaxation::AtMost(int arc, int maximum) const
{
  const int first = this->FirstColumn[arc];
  const int more = maximum - this->Floors[arc];
  if (more <= 0)
  {
    return { { first, -more, NoBound }, { first + 1, 0, 0 }, { first + 2, 0, 0 } };
  }
  return { { first + 2, 0, more - 1 } };
}

std::vector<ColumnBounds> Relaxation::AtLeast(int arc, int minimum) const
{
  const int first = this->FirstColumn[arc];
  const int more = minimum - this->Floors[arc];
  if (more <= 0)
  {
    return { { first, 0, -more } };
  }
  return { { first, 0, 0 }, { first + 1, 1, 1 }, { first + 2, more - 1, NoBound } };
}

void Relaxation::SetBounds(const ColumnBounds& bounds)
{
  this->Solver->SetBounds(bounds.column,
    { static_cast<double>(bounds.lower),
      bounds.upper == NoBound ? Unbounded : static_cast<double>(bounds.upper) });
}

void Relaxation::SetNodeBounds(const std::vector<ColumnBounds>& bounds)
{
  for (const int column : this->Narrowed)
  {
    this->SetBounds(this->RootBounds[column]);
  }
  this->Narrowed.clear();
  for (const ColumnBounds& narrower : bounds)
  {
    const VariableBounds present = this->Solver->GetBounds(narrower.column);
    ColumnBounds both = { narrower.column, static_cast<int>(present.lower),
      present.upper == Unbounded ? NoBound : static_cast<int>(present.upper) };
    both.lower = std::max(both.lower, narrower.lower);
    both.upper = std::max(both.lower, std::min(both.upper, narrower.upper));
    this->SetBounds(both);
    this->Narrowed.push_back(narrower.column);
  }
}

SimplexBasis Relaxation::GetBasis() const
{
  SimplexBasis basis;
  for (int column = 0; column < this->Solver->CountColumns(); ++column)
  {
    basis.columns.push_back(this->Solver->GetColumnStatus(column));
  }
  for (int row = 0; row < this->Solver->CountRows(); ++row)
  {
    basis.rows.push_back(this->Solver->GetRowStatus(row));
  }
  return basis;
}

void Relaxation::SetBasis(const SimplexBasis& basis)
{
  for (int column = 0; column < this->Solver->CountColumns(); ++column)
  {
    this->Solver->SetColumnStatus(column, basis.columns[column]);
  }
  for (int row = 0; row < this->Solver->CountRows(); ++row)
  {
    this->Solver->SetRowStatus(
      row, Index(row) < basis.rows.size() ? basis.rows[row] : BasisStatus::Basic);
  }
}
}
