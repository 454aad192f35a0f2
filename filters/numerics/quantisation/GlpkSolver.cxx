#include "GlpkSolver.h"

#include "Index.h"

#include <glpk.h>

namespace crossfield
{
namespace
{
struct DeleteProblem
{
  void operator()(glp_prob* problem) const { glp_delete_prob(problem); }
};

BasisStatus FromGlpk(int status)
{
  switch (status)
  {
  case GLP_BS:
    return BasisStatus::Basic;
  case GLP_NL:
    return BasisStatus::AtLower;
  case GLP_NU:
    return BasisStatus::AtUpper;
  default:
    return BasisStatus::Fixed;
  }
}

int ToGlpk(BasisStatus status)
{
  switch (status)
  {
  case BasisStatus::Basic:
    return GLP_BS;
  case BasisStatus::AtLower:
    return GLP_NL;
  case BasisStatus::AtUpper:
    return GLP_NU;
  default:
    return GLP_NS;
  }
}

/// Frees what GLPK keeps for a thread when the thread ends.
struct ThreadEnvironment
{
  ThreadEnvironment() = default;
  ThreadEnvironment(const ThreadEnvironment&) = delete;
  ThreadEnvironment& operator=(const ThreadEnvironment&) = delete;
  ~ThreadEnvironment() { glp_free_env(); }
};

/// GLPK numbers rows and columns from 1, and the variables of a tableau with the rows first.
class GlpkSolver : public LinearSolver
{
public:
  GlpkSolver()
    : Program(glp_create_prob())
  {
    static thread_local const ThreadEnvironment environment;
    glp_term_out(GLP_OFF); // for this thread: some messages ignore msg_lev
    glp_set_obj_dir(this->Program.get(), GLP_MIN);
    glp_init_smcp(&this->Options);
    this->Options.msg_lev = GLP_MSG_OFF;
    this->Options.meth = GLP_DUALP;
    this->Options.r_test = GLP_RT_FLIP; // many columns have two bounds
  }

  void SetConstantCost(double cost) override { glp_set_obj_coef(this->Program.get(), 0, cost); }

  void AddColumn(double cost, const VariableBounds& bounds) override
  {
    const int column = glp_add_cols(this->Program.get(), 1);
    this->SetBounds(column - 1, bounds);
    glp_set_obj_coef(this->Program.get(), column, cost);
  }

  void AddRow(const LinearRow& row, RowKind kind) override
  {
    this->Indices.assign(1, 0);
    for (const int column : row.columns)
    {
      this->Indices.push_back(column + 1);
    }
    this->Values.assign(1, 0.0);
    this->Values.insert(this->Values.end(), row.values.begin(), row.values.end());
    const int index = glp_add_rows(this->Program.get(), 1);
    glp_set_row_bnds(
      this->Program.get(), index, kind == RowKind::Equal ? GLP_FX : GLP_LO, row.rhs, row.rhs);
    glp_set_mat_row(this->Program.get(), index, static_cast<int>(row.columns.size()),
      this->Indices.data(), this->Values.data());
  }

  void RemoveRows(const std::vector<int>& rows) override
  {
    std::vector<int> indices = { 0 };
    for (const int row : rows)
    {
      indices.push_back(row + 1);
    }
    if (!rows.empty())
    {
      glp_del_rows(this->Program.get(), static_cast<int>(rows.size()), indices.data());
    }
  }

  void SetBounds(int column, const VariableBounds& bounds) override
  {
    const int bounded = bounds.lower < bounds.upper ? GLP_DB : GLP_FX;
    const bool isOpen = bounds.upper == Unbounded;
    glp_set_col_bnds(this->Program.get(), column + 1, isOpen ? GLP_LO : bounded, bounds.lower,
      isOpen ? 0.0 : bounds.upper);
  }

  VariableBounds GetBounds(int column) const override
  {
    glp_prob* const program = this->Program.get();
    const bool isOpen = glp_get_col_type(program, column + 1) == GLP_LO;
    return { glp_get_col_lb(program, column + 1),
      isOpen ? Unbounded : glp_get_col_ub(program, column + 1) };
  }

  void SetCutoff(double cost) override { this->Options.obj_ul = cost; }
  double GetCutoff() const override { return this->Options.obj_ul; }

  SolveStatus Solve() override
  {
    glp_prob* const program = this->Program.get();
    int failure = glp_simplex(program, &this->Options);
    if (failure != 0 && failure != GLP_EOBJUL)
    {
      glp_std_basis(program); // the present one is singular, or nearly so
      failure = glp_simplex(program, &this->Options);
    }
    const int status = glp_get_status(program);
    if (failure == GLP_EOBJUL || (failure == 0 && status == GLP_NOFEAS))
    {
      return SolveStatus::CutOff;
    }
    if (failure != 0 || status != GLP_OPT)
    {
      return SolveStatus::Unsolved;
    }
    return this->GetObjective() < this->Options.obj_ul ? SolveStatus::Optimal : SolveStatus::CutOff;
  }

  double GetObjective() const override { return glp_get_obj_val(this->Program.get()); }
  double GetValue(int column) const override
  {
    return glp_get_col_prim(this->Program.get(), column + 1);
  }
  double GetReducedCost(int column) const override
  {
    return glp_get_col_dual(this->Program.get(), column + 1);
  }

  int CountColumns() const override { return glp_get_num_cols(this->Program.get()); }
  int CountRows() const override { return glp_get_num_rows(this->Program.get()); }

  BasisStatus GetColumnStatus(int column) const override
  {
    return FromGlpk(glp_get_col_stat(this->Program.get(), column + 1));
  }
  BasisStatus GetRowStatus(int row) const override
  {
    return FromGlpk(glp_get_row_stat(this->Program.get(), row + 1));
  }
  void SetColumnStatus(int column, BasisStatus status) override
  {
    glp_set_col_stat(this->Program.get(), column + 1, ToGlpk(status));
  }
  void SetRowStatus(int row, BasisStatus status) override
  {
    glp_set_row_stat(this->Program.get(), row + 1, ToGlpk(status));
  }

  void GetRow(int row, LinearRow& entries) const override
  {
    this->Reserve(this->CountColumns());
    const int length =
      glp_get_mat_row(this->Program.get(), row + 1, this->Indices.data(), this->Values.data());
    entries.columns.clear();
    entries.values.clear();
    for (int i = 1; i <= length; ++i)
    {
      entries.columns.push_back(this->Indices[i] - 1);
      entries.values.push_back(this->Values[i]);
    }
    entries.rhs = glp_get_row_lb(this->Program.get(), row + 1);
  }

  bool Factorise() override
  {
    return glp_bf_exists(this->Program.get()) != 0 || glp_factorize(this->Program.get()) == 0;
  }

  void GetTableauRow(int column, std::vector<TableauEntry>& entries) const override
  {
    const int rows = this->CountRows();
    this->Reserve(rows + this->CountColumns());
    const int length = glp_eval_tab_row(
      this->Program.get(), rows + column + 1, this->Indices.data(), this->Values.data());
    entries.clear();
    for (int i = 1; i <= length; ++i)
    {
      const int k = this->Indices[i];
      const bool isRow = k <= rows;
      entries.push_back({ isRow, (isRow ? k : k - rows) - 1, this->Values[i] });
    }
  }

private:
  /// Makes the buffers large enough for `count` entries.
  void Reserve(int count) const
  {
    this->Indices.resize(Index(count) + 1);
    this->Values.resize(Index(count) + 1);
  }

  std::unique_ptr<glp_prob, DeleteProblem> Program;
  glp_smcp Options{};
  mutable std::vector<int> Indices; ///< Buffers for entries, from 1 on.
  mutable std::vector<double> Values;
};
}

std::unique_ptr<LinearSolver> MakeGlpkSolver()
{
  return std::make_unique<GlpkSolver>();
}
}
