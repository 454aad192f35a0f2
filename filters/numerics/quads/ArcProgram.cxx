#include "ArcProgram.h"

#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

struct Delete
{
  void operator()(glp_prob* problem) const { glp_delete_prob(problem); }
};

/// What GLPK calls back with.
struct BranchAndCut
{
  int mostNodes = 0;
  int nodes = 0;
  std::vector<double> start; ///< A value per column, from 1 on.
  double bound = 0.0;

  static void Step(glp_tree* tree, void* info)
  {
    auto& search = *static_cast<BranchAndCut*>(info);
    if (glp_ios_reason(tree) == GLP_IHEUR && !search.start.empty())
    {
      glp_ios_heur_sol(tree, search.start.data());
      search.start.clear();
    }
    if (glp_ios_reason(tree) == GLP_ISELECT)
    {
      glp_ios_tree_size(tree, nullptr, nullptr, &search.nodes);
      const int best = glp_ios_best_node(tree);
      search.bound = best > 0 ? glp_ios_node_bound(tree, best) : search.bound;
      if (search.nodes > search.mostNodes)
      {
        glp_ios_terminate(tree);
      }
    }
  }
};
}

struct ArcProgram::Program
{
  explicit Program(const ArcProblem& wanted)
    : Problem(wanted)
    , Data(glp_create_prob())
  {
    glp_term_out(GLP_OFF); // of this thread: GLPK says some things whatever msg_lev is
    glp_set_obj_dir(this->Data.get(), GLP_MIN);
    this->AddColumns();
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
      if (!equation.empty())
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
      const int first = ColumnOf(Index(arc));
      columns.insert(columns.end(), { first, first + 1, first + 2 });
      const auto value = static_cast<double>(factor);
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

  ProgramCounts Search(const std::vector<int>& start, int mostNodes, double gap)
  {
    BranchAndCut search;
    search.mostNodes = mostNodes;
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
    options.mip_gap = gap;
    options.cb_func = &BranchAndCut::Step;
    options.cb_info = &search;
    const int status = glp_intopt(this->Data.get(), &options);
    const int found = glp_mip_status(this->Data.get());
    ProgramCounts result;
    result.nodes = search.nodes;
    result.bound = search.bound;
    if (found == GLP_OPT || found == GLP_FEAS)
    {
      for (std::size_t a = 0; a < this->Problem.Count(); ++a)
      {
        result.counts.push_back(this->CountOf(a));
      }
      result.cost = this->Problem.Cost(result.counts);
      result.bound = status == 0 ? result.cost : std::min(search.bound, result.cost);
    }
    return result;
  }

private:
  static int ColumnOf(std::size_t arc) { return 3 * static_cast<int>(arc) + 1; }

  void AddColumns()
  {
    glp_add_cols(this->Data.get(), 3 * static_cast<int>(this->Problem.Count()));
    double constant = 0.0;
    for (std::size_t a = 0; a < this->Problem.Count(); ++a)
    {
      const double weight = this->Problem.weight[a];
      const double below = std::floor(this->Problem.wanted[a]);
      const double fraction = this->Problem.wanted[a] - below;
      constant += weight * fraction;
      this->Floors.push_back(static_cast<int>(below));
      this->AddColumn(ColumnOf(a), weight, this->Floors.back() > 0 ? GLP_DB : GLP_FX, below);
      this->AddColumn(ColumnOf(a) + 1, weight * (1.0 - 2.0 * fraction), GLP_DB, 1.0);
      this->AddColumn(ColumnOf(a) + 2, weight, GLP_LO, 0.0);
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
    std::vector<double> values = { 0.0 };
    for (std::size_t a = 0; a < counts.size(); ++a)
    {
      const int more = counts[a] - this->Floors[a];
      values.insert(values.end(),
        { static_cast<double>(std::max(0, -more)), static_cast<double>(std::clamp(more, 0, 1)),
          static_cast<double>(std::max(0, more - 1)) });
    }
    return values;
  }

  int CountOf(std::size_t arc) const
  {
    const auto value = [&](int i)
    { return static_cast<int>(std::lround(glp_mip_col_val(this->Data.get(), ColumnOf(arc) + i))); };
    return this->Floors[arc] - value(0) + value(1) + value(2);
  }

  const ArcProblem& Problem;
  std::unique_ptr<glp_prob, Delete> Data;
  std::vector<int> Floors;
};

ArcProgram::ArcProgram(const ArcProblem& problem)
  : Data(std::make_unique<Program>(problem))
{
}

ArcProgram::~ArcProgram() = default;

void ArcProgram::Add(const ArcRow& row)
{
  this->Data->AddRow(row.terms, GLP_LO, row.least);
  this->Rows.push_back(row);
}

ProgramCounts ArcProgram::Solve(const std::vector<int>& start, int mostNodes, double gap)
{
  if (!this->Data->Relax())
  {
    return {}; // numerical trouble of the simplex method: nothing is known
  }
  const bool holds = std::all_of(this->Rows.begin(), this->Rows.end(),
    [&start](const ArcRow& row) { return !start.empty() && row.Holds(start); });
  return this->Data->Search(holds ? start : std::vector<int>(), mostNodes, gap);
}
}
