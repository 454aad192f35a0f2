#include "ArcRelaxation.h"

#include "GomoryCut.h"
#include "Index.h"

#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
struct Delete
{
  void operator()(glp_prob* problem) const { glp_delete_prob(problem); }
};

/// Instead of the first column of an arc; columns begin with 1.
constexpr int Fixed = 0;
}

struct ArcRelaxation::Program
{
  Program(const ArcProblem& wanted, const std::vector<int>& free, const std::vector<int>& counts)
    : Problem(wanted)
    , Free(free)
    , Counts(counts)
    , Data(glp_create_prob())
    , FirstColumn(wanted.Count(), Fixed)
  {
    glp_term_out(GLP_OFF); // of this thread: GLPK says some things whatever msg_lev is
    glp_set_obj_dir(this->Data.get(), GLP_MIN);
    glp_init_smcp(&this->Options);
    this->Options.msg_lev = GLP_MSG_OFF;
    this->Options.meth = GLP_DUALP;
    this->Options.r_test = GLP_RT_FLIP; // many columns have two bounds
    this->AddColumns();
    this->AddEquations();
    glp_std_basis(this->Data.get());
  }

  bool IsFree(int arc) const { return this->FirstColumn[Index(arc)] != Fixed; }
  double Value(int column) const { return glp_get_col_prim(this->Data.get(), column); }

  void AddRow(const std::vector<std::pair<int, int>>& terms, int kind, int least)
  {
    CutRow row;
    row.least = least;
    for (const auto& [arc, factor] : terms)
    {
      if (!this->IsFree(arc))
      {
        row.least -= factor * this->Counts[Index(arc)];
        continue;
      }
      const int first = this->FirstColumn[Index(arc)];
      const auto value = static_cast<double>(factor);
      for (const auto& [column, sign] :
        { std::pair(first, -1.0), std::pair(first + 1, 1.0), std::pair(first + 2, 1.0) })
      {
        row.columns.push_back(column);
        row.values.push_back(sign * value);
      }
      row.least -= value * this->Floors[Index(arc)];
    }
    this->AddRow(row, kind);
    this->IsCut.push_back(0);
  }

  void AddRow(const CutRow& row, int kind)
  {
    // GLPK counts from 1.
    std::vector<int> columns = { 0 };
    columns.insert(columns.end(), row.columns.begin(), row.columns.end());
    std::vector<double> values = { 0.0 };
    values.insert(values.end(), row.values.begin(), row.values.end());
    const int index = glp_add_rows(this->Data.get(), 1);
    glp_set_row_bnds(this->Data.get(), index, kind, row.least, row.least);
    glp_set_mat_row(
      this->Data.get(), index, static_cast<int>(row.columns.size()), columns.data(), values.data());
  }

  double Relaxed(int arc) const
  {
    if (!this->IsFree(arc))
    {
      return this->Counts[Index(arc)];
    }
    const int first = this->FirstColumn[Index(arc)];
    return this->Floors[Index(arc)] - this->Value(first) + this->Value(first + 1) +
      this->Value(first + 2);
  }

  void SetBounds(const ColumnBounds& bounds)
  {
    const int bounded = bounds.least < bounds.most ? GLP_DB : GLP_FX;
    glp_set_col_bnds(this->Data.get(), bounds.column, bounds.most == NoBound ? GLP_LO : bounded,
      bounds.least, bounds.most);
  }

  /// At present.
  ColumnBounds GetBounds(int column) const
  {
    const bool isOpen = glp_get_col_type(this->Data.get(), column) == GLP_LO;
    return { column, static_cast<int>(glp_get_col_lb(this->Data.get(), column)),
      isOpen ? NoBound : static_cast<int>(glp_get_col_ub(this->Data.get(), column)) };
  }

  ColumnBounds& BoundsOf(int column) { return this->Bounds[Index(column) - 1]; }

  void RemoveLooseCuts()
  {
    std::vector<int> loose = { 0 };
    std::vector<char> kept;
    for (int row = 1; row <= glp_get_num_rows(this->Data.get()); ++row)
    {
      if (this->IsCut[Index(row) - 1] != 0 && glp_get_row_stat(this->Data.get(), row) == GLP_BS)
      {
        loose.push_back(row);
      }
      else
      {
        kept.push_back(this->IsCut[Index(row) - 1]);
      }
    }
    if (loose.size() > 1)
    {
      glp_del_rows(this->Data.get(), static_cast<int>(loose.size()) - 1, loose.data());
      this->IsCut = std::move(kept);
    }
  }

  static constexpr int NoBound = std::numeric_limits<int>::max();

  const ArcProblem& Problem;
  const std::vector<int> Free;
  const std::vector<int> Counts; ///< Of arcs that are not free.
  std::unique_ptr<glp_prob, Delete> Data;
  glp_smcp Options{};
  std::vector<int> FirstColumn; ///< Per arc, or Fixed.
  std::vector<int> Floors;
  std::vector<ColumnBounds> Bounds; ///< Per column, those that hold for all.
  std::vector<int> Narrowed;        ///< Columns with others at present.
  std::vector<char> IsCut;          ///< Per row.

private:
  void AddColumns()
  {
    for (std::size_t i = 0; i < this->Free.size(); ++i)
    {
      this->FirstColumn[Index(this->Free[i])] = 3 * static_cast<int>(i) + 1;
    }
    glp_add_cols(this->Data.get(), 3 * static_cast<int>(this->Free.size()));
    for (const double wanted : this->Problem.wanted)
    {
      this->Floors.push_back(static_cast<int>(std::floor(wanted)));
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
      const double weight = this->Problem.weight[Index(arc)];
      const int below = this->Floors[Index(arc)];
      const double fraction = this->Problem.wanted[Index(arc)] - below;
      constant += weight * fraction;
      this->AddColumn(weight, below);
      this->AddColumn(weight * (1.0 - 2.0 * fraction), 1);
      this->AddColumn(weight, NoBound);
    }
    glp_set_obj_coef(this->Data.get(), 0, constant);
  }

  void AddColumn(double cost, int most)
  {
    const int column = static_cast<int>(this->Bounds.size()) + 1;
    this->Bounds.push_back({ column, 0, most });
    this->SetBounds(this->Bounds.back());
    glp_set_obj_coef(this->Data.get(), column, cost);
  }

  void AddEquations()
  {
    std::vector<std::vector<std::pair<int, int>>> equations(Index(this->Problem.rows));
    for (const int arc : this->Free)
    {
      for (const ArcTerm& term : this->Problem.terms[Index(arc)])
      {
        equations[Index(term.row)].emplace_back(arc, term.sign);
      }
    }
    // What the others add to an equation.
    std::vector<int> rest(equations.size(), 0);
    for (std::size_t a = 0; a < this->Problem.Count(); ++a)
    {
      if (!this->IsFree(static_cast<int>(a)))
      {
        for (const ArcTerm& term : this->Problem.terms[a])
        {
          rest[Index(term.row)] += term.sign * this->Counts[a];
        }
      }
    }
    for (std::size_t i = 0; i < equations.size(); ++i)
    {
      if (!equations[i].empty())
      {
        this->AddRow(equations[i], GLP_FX, -rest[i]);
      }
    }
  }
};

ArcRelaxation::ArcRelaxation(
  const ArcProblem& problem, const std::vector<int>& free, const std::vector<int>& counts)
  : Data(std::make_unique<Program>(problem, free, counts))
{
}

ArcRelaxation::~ArcRelaxation() = default;

void ArcRelaxation::Add(const ArcRow& row)
{
  this->Data->AddRow(row.terms, GLP_LO, row.least);
}

void ArcRelaxation::SetLimit(double cost)
{
  this->Data->Options.obj_ul = cost;
}

RelaxationStatus ArcRelaxation::Solve()
{
  glp_prob* const data = this->Data->Data.get();
  const glp_smcp& options = this->Data->Options;
  int failure = glp_simplex(data, &options);
  if (failure != 0 && failure != GLP_EOBJUL)
  {
    glp_std_basis(data); // one that is singular, or nearly so
    failure = glp_simplex(data, &options);
  }
  const int status = glp_get_status(data);
  if (failure == GLP_EOBJUL || (failure == 0 && status == GLP_NOFEAS))
  {
    return RelaxationStatus::Dear;
  }
  if (failure != 0 || status != GLP_OPT)
  {
    return RelaxationStatus::Unsolved;
  }
  return this->GetCost() < options.obj_ul ? RelaxationStatus::Optimal : RelaxationStatus::Dear;
}

double ArcRelaxation::GetCost() const
{
  return glp_get_obj_val(this->Data->Data.get());
}

const std::vector<int>& ArcRelaxation::GetFree() const
{
  return this->Data->Free;
}

double ArcRelaxation::Relaxed(int arc) const
{
  return this->Data->Relaxed(arc);
}

bool ArcRelaxation::IsIntegral(int arc) const
{
  // Far above what the simplex method is exact to.
  constexpr double NearlyIntegral = 1e-6;
  const double value = this->Relaxed(arc);
  return std::abs(value - std::round(value)) < NearlyIntegral;
}

std::vector<int> ArcRelaxation::GetCounts() const
{
  std::vector<int> counts = this->Data->Counts;
  counts.resize(this->Data->Problem.Count());
  for (const int arc : this->Data->Free)
  {
    counts[Index(arc)] = static_cast<int>(std::lround(this->Data->Relaxed(arc)));
  }
  return counts;
}

bool ArcRelaxation::Cut()
{
  Program& program = *this->Data;
  program.RemoveLooseCuts();
  glp_prob* const data = program.Data.get();
  if (glp_bf_exists(data) == 0 && glp_factorize(data) != 0)
  {
    return false;
  }
  const std::vector<CutRow> cuts = GomoryCuts(*data, program.IsCut);
  for (const CutRow& cut : cuts)
  {
    program.AddRow(cut, GLP_LO);
    program.IsCut.push_back(1);
  }
  return !cuts.empty();
}

void ArcRelaxation::Tighten()
{
  Program& program = *this->Data;
  glp_prob* const data = program.Data.get();
  const double left = program.Options.obj_ul - this->GetCost();
  for (ColumnBounds& bounds : program.Bounds)
  {
    const double reduced = std::abs(glp_get_col_dual(data, bounds.column));
    // GLPK's own for costs. Its optima are exact to far less than the second.
    constexpr double NoCost = 1e-7;
    constexpr double Rounding = 1e-6;
    const double steps = std::floor(left / std::max(reduced, NoCost) + Rounding);
    if (reduced < NoCost || steps >= bounds.most - bounds.least)
    {
      continue;
    }
    const int state = glp_get_col_stat(data, bounds.column);
    if (state == GLP_NL)
    {
      bounds.most = bounds.least + static_cast<int>(steps);
    }
    else if (state == GLP_NU)
    {
      bounds.least = bounds.most - static_cast<int>(steps);
    }
    program.SetBounds(bounds);
  }
}

std::vector<ColumnBounds> ArcRelaxation::AtMost(int arc, int most) const
{
  const int first = this->Data->FirstColumn[Index(arc)];
  const int more = most - this->Data->Floors[Index(arc)];
  if (more <= 0)
  {
    return { { first, -more, Program::NoBound }, { first + 1, 0, 0 }, { first + 2, 0, 0 } };
  }
  return { { first + 2, 0, more - 1 } };
}

std::vector<ColumnBounds> ArcRelaxation::AtLeast(int arc, int least) const
{
  const int first = this->Data->FirstColumn[Index(arc)];
  const int more = least - this->Data->Floors[Index(arc)];
  if (more <= 0)
  {
    return { { first, 0, -more } };
  }
  return { { first, 0, 0 }, { first + 1, 1, 1 }, { first + 2, more - 1, Program::NoBound } };
}

void ArcRelaxation::Narrow(const std::vector<ColumnBounds>& bounds)
{
  Program& program = *this->Data;
  std::vector<int> columns;
  std::swap(columns, program.Narrowed);
  for (const int column : columns)
  {
    program.SetBounds(program.BoundsOf(column));
  }
  for (const ColumnBounds& narrower : bounds)
  {
    ColumnBounds both = program.GetBounds(narrower.column);
    both.least = std::max(both.least, narrower.least);
    both.most = std::max(both.least, std::min(both.most, narrower.most));
    program.SetBounds(both);
    program.Narrowed.push_back(narrower.column);
  }
}

RelaxationBasis ArcRelaxation::GetBasis() const
{
  glp_prob* const data = this->Data->Data.get();
  RelaxationBasis basis;
  for (int column = 1; column <= glp_get_num_cols(data); ++column)
  {
    basis.columns.push_back(static_cast<char>(glp_get_col_stat(data, column)));
  }
  for (int row = 1; row <= glp_get_num_rows(data); ++row)
  {
    basis.rows.push_back(static_cast<char>(glp_get_row_stat(data, row)));
  }
  return basis;
}

void ArcRelaxation::SetBasis(const RelaxationBasis& basis)
{
  glp_prob* const data = this->Data->Data.get();
  for (int column = 1; column <= glp_get_num_cols(data); ++column)
  {
    glp_set_col_stat(data, column, basis.columns[Index(column) - 1]);
  }
  for (int row = 1; row <= glp_get_num_rows(data); ++row)
  {
    const std::size_t index = Index(row) - 1;
    glp_set_row_stat(data, row, index < basis.rows.size() ? basis.rows[index] : GLP_BS);
  }
}
}
