#include "ArcProgram.h"

#include "Index.h"

#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// As GLPK's own for whole numbers.
constexpr double NearlyWhole = 1e-5;

struct Delete
{
  void operator()(glp_prob* problem) const { glp_delete_prob(problem); }
};

}

struct ArcProgram::Program
{
  Program(const ArcProblem& wanted, const std::vector<int>& free, std::vector<int> counts)
    : Problem(wanted)
    , Data(glp_create_prob())
    , Counts(std::move(counts))
    , FirstColumn(wanted.Count(), Fixed)
  {
    glp_term_out(GLP_OFF); // of this thread: GLPK says some things whatever msg_lev is
    glp_set_obj_dir(this->Data.get(), GLP_MIN);
    this->AddColumns(free);
    std::vector<std::vector<std::pair<int, int>>> equations(Index(wanted.rows));
    for (std::size_t a = 0; a < wanted.Count(); ++a)
    {
      for (const ArcTerm& term : wanted.terms[a])
      {
        equations[Index(term.row)].emplace_back(static_cast<int>(a), term.sign);
      }
    }
    for (const auto& equation : equations)
    {
      if (std::any_of(equation.begin(), equation.end(),
            [this](const auto& term) { return this->IsFree(Index(term.first)); }))
      {
        this->AddRow(equation, GLP_FX, 0);
      }
    }
  }

  void AddRow(const std::vector<std::pair<int, int>>& terms, int kind, int least)
  {
    std::vector<int> columns = { 0 }; // GLPK counts from 1
    std::vector<double> values = { 0.0 };
    double right = least;
    for (const auto& [arc, factor] : terms)
    {
      const auto value = static_cast<double>(factor);
      if (!this->IsFree(Index(arc)))
      {
        right -= value * this->Counts[Index(arc)];
        continue;
      }
      const int first = this->FirstColumn[Index(arc)];
      columns.insert(columns.end(), { first, first + 1, first + 2 });
      values.insert(values.end(), { -value, value, value });
      right -= value * this->Floors[Index(arc)];
    }
    const int row = glp_add_rows(this->Data.get(), 1);
    glp_set_row_bnds(this->Data.get(), row, kind, right, right);
    glp_set_mat_row(
      this->Data.get(), row, static_cast<int>(columns.size()) - 1, columns.data(), values.data());
  }

  /// From the beginning: from where the last one ended, by the dual method, Gomory's cuts were worse.
  bool Relax()
  {
    glp_std_basis(this->Data.get());
    glp_smcp options;
    glp_init_smcp(&options);
    options.msg_lev = GLP_MSG_OFF;
    return glp_simplex(this->Data.get(), &options) == 0 &&
      glp_get_status(this->Data.get()) == GLP_OPT;
  }

  ProgramCounts Search(const std::vector<int>& start, int mostNodes, const Separate& separate,
    std::vector<ArcRow>& rows)
  {
    BranchAndCut search{ *this, separate, rows, mostNodes, 0, {}, 0.0 };
    search.bound = glp_get_obj_val(this->Data.get());
    if (!start.empty())
    {
      search.start = this->ValuesOf(start);
    }
    glp_iocp options;
    glp_init_iocp(&options);
    options.msg_lev = GLP_MSG_OFF;
    // Gomory's cuts solve most problems without branching; without them, or with the default rule of branching,
    // ten times as many nodes were seen.
    options.gmi_cuts = GLP_ON;
    options.mir_cuts = GLP_ON;
    options.br_tech = GLP_BR_PCH;
    // Rounding would take numbers that nobody has separated.
    options.sr_heur = GLP_OFF;
    options.cb_func = &BranchAndCut::Step;
    options.cb_info = &search;
    const int status = glp_intopt(this->Data.get(), &options);
    const int found = glp_mip_status(this->Data.get());
    ProgramCounts result;
    result.nodes = search.nodes;
    result.bound = search.bound;
    if (found == GLP_OPT || found == GLP_FEAS)
    {
      result.counts =
        this->CountsOf([this](int column) { return glp_mip_col_val(this->Data.get(), column); });
      result.cost = this->Problem.Cost(result.counts);
      result.bound = status == 0 ? result.cost : std::min(search.bound, result.cost);
    }
    return result;
  }

private:
  static constexpr int Fixed = 0; // columns begin with 1

  /// What GLPK calls back with.
  struct BranchAndCut
  {
    Program& program;
    const Separate& separate;
    std::vector<ArcRow>& rows;
    int mostNodes;
    int nodes = 0;
    std::vector<double> start; ///< A value per column, from 1 on.
    double bound = 0.0;

    static void Step(glp_tree* tree, void* info)
    {
      auto& search = *static_cast<BranchAndCut*>(info);
      switch (glp_ios_reason(tree))
      {
      case GLP_IROWGEN:
        search.AddRows();
        break;
      case GLP_IHEUR:
        if (!search.start.empty())
        {
          glp_ios_heur_sol(tree, search.start.data());
          search.start.clear();
        }
        break;
      case GLP_ISELECT:
      {
        glp_ios_tree_size(tree, nullptr, nullptr, &search.nodes);
        const int best = glp_ios_best_node(tree);
        search.bound = best > 0 ? glp_ios_node_bound(tree, best) : search.bound;
        if (search.nodes > search.mostNodes)
        {
          glp_ios_terminate(tree);
        }
        break;
      }
      default:
        break;
      }
    }

    /// To the relaxation at hand: rows are those of a node and of what is below it, so others may need them again.
    void AddRows()
    {
      bool isNew = false;
      for (const ArcRow& row : this->rows)
      {
        if (this->program.Breaks(row))
        {
          this->program.AddRow(row.terms, GLP_LO, row.least);
          isNew = true;
        }
      }
      if (isNew || !this->program.IsWhole())
      {
        return;
      }
      const std::vector<int> counts = this->program.CountsOf(
        [this](int column) { return glp_get_col_prim(this->program.Data.get(), column); });
      for (ArcRow& row : this->separate(counts))
      {
        this->program.AddRow(row.terms, GLP_LO, row.least);
        this->rows.push_back(std::move(row));
      }
    }
  };

  double Relaxed(std::size_t arc) const
  {
    if (!this->IsFree(arc))
    {
      return this->Counts[arc];
    }
    const int first = this->FirstColumn[arc];
    const auto value = [this](int column) { return glp_get_col_prim(this->Data.get(), column); };
    return this->Floors[arc] - value(first) + value(first + 1) + value(first + 2);
  }

  bool Breaks(const ArcRow& row) const
  {
    double sum = 0.0;
    for (const auto& [arc, factor] : row.terms)
    {
      sum += factor * this->Relaxed(Index(arc));
    }
    return sum < row.least - NearlyWhole;
  }

  bool IsWhole() const
  {
    for (int column = 1; column <= glp_get_num_cols(this->Data.get()); ++column)
    {
      const double value = glp_get_col_prim(this->Data.get(), column);
      if (std::abs(value - std::round(value)) > NearlyWhole)
      {
        return false;
      }
    }
    return true;
  }

  bool IsFree(std::size_t arc) const { return this->FirstColumn[arc] != Fixed; }

  void AddColumns(const std::vector<int>& free)
  {
    for (std::size_t i = 0; i < free.size(); ++i)
    {
      this->FirstColumn[Index(free[i])] = 3 * static_cast<int>(i) + 1;
    }
    glp_add_cols(this->Data.get(), 3 * static_cast<int>(free.size()));
    double constant = 0.0;
    for (std::size_t a = 0; a < this->Problem.Count(); ++a)
    {
      this->Floors.push_back(static_cast<int>(std::floor(this->Problem.wanted[a])));
      if (!this->IsFree(a))
      {
        constant += this->Problem.Cost(a, this->Counts[a]);
        continue;
      }
      const int first = this->FirstColumn[a];
      const double weight = this->Problem.weight[a];
      const double below = this->Floors[a];
      const double fraction = this->Problem.wanted[a] - below;
      constant += weight * fraction;
      this->AddColumn(first, weight, this->Floors[a] > 0 ? GLP_DB : GLP_FX, below);
      this->AddColumn(first + 1, weight * (1.0 - 2.0 * fraction), GLP_DB, 1.0);
      this->AddColumn(first + 2, weight, GLP_LO, 0.0);
    }
    glp_set_obj_coef(this->Data.get(), 0, constant);
  }

  void AddColumn(int column, double cost, int kind, double most)
  {
    glp_set_col_kind(this->Data.get(), column, GLP_IV);
    glp_set_col_bnds(this->Data.get(), column, kind, 0.0, most);
    glp_set_obj_coef(this->Data.get(), column, cost);
  }

  std::vector<double> ValuesOf(const std::vector<int>& counts) const
  {
    std::vector<double> values(Index(glp_get_num_cols(this->Data.get())) + 1, 0.0);
    for (std::size_t a = 0; a < counts.size(); ++a)
    {
      if (this->IsFree(a))
      {
        const std::size_t first = Index(this->FirstColumn[a]);
        const int more = counts[a] - this->Floors[a];
        values[first] = std::max(0, -more);
        values[first + 1] = std::clamp(more, 0, 1);
        values[first + 2] = std::max(0, more - 1);
      }
    }
    return values;
  }

  template <typename Value>
  std::vector<int> CountsOf(Value value) const
  {
    std::vector<int> counts = this->Counts;
    counts.resize(this->Problem.Count());
    for (std::size_t a = 0; a < counts.size(); ++a)
    {
      if (this->IsFree(a))
      {
        const int first = this->FirstColumn[a];
        counts[a] = this->Floors[a] +
          static_cast<int>(std::lround(value(first + 1) + value(first + 2) - value(first)));
      }
    }
    return counts;
  }

  const ArcProblem& Problem;
  std::unique_ptr<glp_prob, Delete> Data;
  const std::vector<int> Counts; ///< Of arcs that are not free.
  std::vector<int> FirstColumn;  ///< Per arc.
  std::vector<int> Floors;
};

ArcProgram::ArcProgram(
  const ArcProblem& problem, const std::vector<int>& free, const std::vector<int>& counts)
  : Data(std::make_unique<Program>(problem, free, counts))
{
}

ArcProgram::~ArcProgram() = default;

void ArcProgram::Add(const ArcRow& row)
{
  this->Data->AddRow(row.terms, GLP_LO, row.least);
  this->Rows.push_back(row);
}

ProgramCounts ArcProgram::Solve(
  const std::vector<int>& start, int mostNodes, const Separate& separate)
{
  if (!this->Data->Relax())
  {
    return {}; // numerical trouble of the simplex method: nothing is known
  }
  const bool holds = std::all_of(this->Rows.begin(), this->Rows.end(),
    [&start](const ArcRow& row) { return !start.empty() && row.Holds(start); });
  return this->Data->Search(holds ? start : std::vector<int>(), mostNodes, separate, this->Rows);
}
}
