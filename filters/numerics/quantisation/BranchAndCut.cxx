#include "BranchAndCut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// An open node of the search: all counts within bounds.
struct Node
{
  double bound = 0.0; ///< Lower bound of the cost, that of the parent.
  std::vector<ColumnBounds> bounds;
  std::shared_ptr<const SimplexBasis> basis; ///< To start from; null: the present one.
  int arc = -1;                              ///< The arc branched on last.
  std::size_t up = 0; ///< 1 if that branch raised its count, 0 if it lowered it.
  double step = 0.0;  ///< Distance of the relaxed count from the new bound.
};

/// The observed increase of the bound per unit step, for one branching direction of an arc.
struct PseudoCost
{
  double sum = 0.0;
  int count = 0;
};

class Search
{
public:
  Search(const QuantisationProblem& problem, Relaxation& program, std::vector<SeparationRow>& rows,
    std::vector<double>& rootRelaxation, const BranchAndCut::Separate& separate,
    std::vector<int> start)
    : Problem(problem)
    , Program(program)
    , Rows(rows)
    , RootRelaxation(rootRelaxation)
    , SeparateCounts(separate)
  {
    this->PseudoCosts.fill(std::vector<PseudoCost>(problem.Count()));
    if (start.empty())
    {
      this->IsFirstWanted = true;
      this->Best.cost = std::numeric_limits<double>::max();
      return;
    }
    this->SetBest(std::move(start));
  }

  EdgeCounts Run(const BranchLimits& limits)
  {
    constexpr int MaximumRounds = 20; // later ones hardly raise the bound
    this->RoundsOfCuts = std::min(limits.nodes, MaximumRounds);
    this->MinimumRise = limits.minimumRise;
    bool isOpen = this->SolveRoot();
    while (isOpen && this->Best.nodes < limits.nodes && !this->IsFinished())
    {
      ++this->Best.nodes;
      const bool divided = this->Visit();
      // Rows present at the root raise the bound by their cuts, more than rows added at leaves. A
      // new root pays off once there are a few.
      constexpr std::size_t ManyRows = 10;
      isOpen = this->Rows.size() >= this->RootRows + ManyRows ? this->SolveRoot()
                                                              : divided || this->SelectNode();
    }
    this->Best.bound = std::min(this->Best.cost, isOpen ? this->LowerBound() : this->Best.cost);
    if (this->IsUnsolved)
    {
      this->Best.bound = this->RootBound;
    }
    return this->Best;
  }

private:
  /// Compares nodes for a heap with the lowest bound first.
  static bool HasHigherBound(const Node& a, const Node& b) { return a.bound > b.bound; }

  /// Returns whether counts were found where any suffice.
  bool IsFinished() const { return this->IsFirstWanted && !this->Best.counts.empty(); }

  void SetBest(std::vector<int> counts)
  {
    this->Best.cost = this->Problem.Cost(counts);
    this->Best.counts = std::move(counts);
    this->Program.SetCutoff(this->GetCutoff());
  }

  double GetCutoff() const { return this->Best.cost - CostRounding(this->Best.cost); }

  /// Returns the lower bound over all open nodes.
  double LowerBound() const
  {
    double lowest = this->Present.bound;
    for (const std::vector<Node>* const nodes : { &this->Open, &this->Recent })
    {
      for (const Node& node : *nodes)
      {
        lowest = std::min(lowest, node.bound);
      }
    }
    return std::max(lowest, this->RootBound);
  }

  /// Restarts the search at the root with all rows, and adds cuts. Returns whether the root must be
  /// divided.
  bool SolveRoot()
  {
    this->Open.clear();
    this->Recent.clear();
    this->Backtracks = 0;
    this->Present = {};
    this->Program.SetNodeBounds({});
    double before = 0.0;
    for (int round = 0; round <= this->RoundsOfCuts; ++round)
    {
      if (!this->SolveSeparated())
      {
        return false;
      }
      const double cost = this->Program.GetCost();
      this->RootBound = std::max(this->RootBound, cost);
      this->Program.TightenBounds();
      // Without a minimum, the rounds go on even where dropped cuts have lowered the bound.
      const bool isSmall =
        round > 0 && this->MinimumRise > 0.0 && cost - before < this->MinimumRise * cost;
      const bool isLast = isSmall || round == this->RoundsOfCuts;
      if (isLast || this->IsIntegral() || !this->Program.AddCuts())
      {
        break;
      }
      before = cost;
    }
    this->RootRows = this->Rows.size();
    this->RootRelaxation.clear();
    for (std::size_t a = 0; a < this->Problem.Count(); ++a)
    {
      this->RootRelaxation.push_back(this->Program.GetCount(static_cast<int>(a)));
    }
    this->Present.bound = this->RootBound;
    return true;
  }

  bool IsIntegral() const
  {
    return std::all_of(this->Program.GetFree().begin(), this->Program.GetFree().end(),
      [this](int arc) { return this->Program.IsIntegral(arc); });
  }

  /// Solves the relaxation and adds violated separation rows until its optimum is fractional or
  /// feasible. Returns false if the node is cut off.
  bool SolveSeparated()
  {
    SolveStatus status = this->Program.Solve();
    for (; status == SolveStatus::Optimal && this->IsIntegral(); status = this->Program.Solve())
    {
      std::vector<int> counts = this->Program.GetRoundedCounts();
      const std::vector<SeparationRow> violated = this->SeparateCounts(counts);
      if (violated.empty())
      {
        this->SetBest(std::move(counts));
        break;
      }
      for (const SeparationRow& row : violated)
      {
        this->Program.AddRow(row);
        this->Rows.push_back(row);
      }
    }
    this->IsUnsolved = this->IsUnsolved || status == SolveStatus::Unsolved;
    return status == SolveStatus::Optimal;
  }

  /// Solves the present node and divides it, if necessary, into two. Returns whether there is a new
  /// present node: the part whose bound is expected to increase less.
  bool Visit()
  {
    this->Program.SetNodeBounds(this->Present.bounds);
    if (this->Present.basis)
    {
      this->Program.SetBasis(*this->Present.basis);
    }
    if (!this->SolveSeparated())
    {
      return false;
    }
    const double cost = this->Program.GetCost();
    if (this->Present.arc >= 0)
    {
      PseudoCost& observed = this->PseudoCosts[this->Present.up][this->Present.arc];
      observed.sum += std::max(0.0, cost - this->Present.bound) / this->Present.step;
      ++observed.count;
    }
    const int arc = this->SelectArc();
    if (arc < 0)
    {
      return false;
    }
    this->Divide(arc, cost);
    return true;
  }

  void Divide(int arc, double cost)
  {
    const auto below = static_cast<int>(std::floor(this->Program.GetCount(arc)));
    std::array<Node, 2> parts = { this->Present, this->Present };
    const std::array<std::vector<ColumnBounds>, 2> narrower = { this->Program.AtMost(arc, below),
      this->Program.AtLeast(arc, below + 1) };
    for (std::size_t up = 0; up < 2; ++up)
    {
      Node& part = parts[up];
      part.bound = cost;
      part.bounds.insert(part.bounds.end(), narrower[up].begin(), narrower[up].end());
      part.basis = nullptr;
      part.arc = arc;
      part.up = up;
      part.step = this->StepTo(arc, up);
    }
    const std::size_t next =
      this->ExpectedIncrease(arc, 1) < this->ExpectedIncrease(arc, 0) ? 1 : 0;
    this->Present = std::move(parts[next]);
    parts[1 - next].basis = std::make_shared<const SimplexBasis>(this->Program.GetBasis());
    this->Recent.push_back(std::move(parts[1 - next]));
  }

  /// Selects the next node: the most recent one, as dives find integral solutions, and after some
  /// of these the one with the lowest bound. Returns false if none is left.
  bool SelectNode()
  {
    constexpr int MaximumBacktracks = 8;
    while (!this->Recent.empty() && this->Backtracks < MaximumBacktracks)
    {
      this->Present = std::move(this->Recent.back());
      this->Recent.pop_back();
      if (this->Present.bound < this->GetCutoff())
      {
        ++this->Backtracks;
        return true;
      }
    }
    this->Backtracks = 0;
    for (Node& node : this->Recent)
    {
      this->Open.push_back(std::move(node));
      std::push_heap(this->Open.begin(), this->Open.end(), HasHigherBound);
    }
    this->Recent.clear();
    if (this->Open.empty() || this->Open.front().bound >= this->GetCutoff())
    {
      return false;
    }
    std::pop_heap(this->Open.begin(), this->Open.end(), HasHigherBound);
    this->Present = std::move(this->Open.back());
    this->Open.pop_back();
    return true;
  }

  /// Returns the distance of a relaxed count from the next integer up or down.
  double StepTo(int arc, std::size_t up) const
  {
    const double value = this->Program.GetCount(arc);
    return up == 1 ? std::floor(value) + 1.0 - value : value - std::floor(value);
  }

  /// Returns the expected increase of the bound: by pseudo-cost, or by the weight of the arc before
  /// there is one.
  double ExpectedIncrease(int arc, std::size_t up) const
  {
    const PseudoCost& observed = this->PseudoCosts[up][arc];
    return this->StepTo(arc, up) *
      (observed.count > 0 ? observed.sum / observed.count : this->Problem.weight[arc]);
  }

  /// Returns the fractional arc with the largest product of both expected increases (Achterberg,
  /// Koch, Martin 2005), −1 if all are integral.
  int SelectArc() const
  {
    int best = -1;
    double largest = 0.0;
    for (const int arc : this->Program.GetFree())
    {
      if (this->Program.IsIntegral(arc))
      {
        continue;
      }
      // Keeps the influence of one direction if the other has no increase.
      constexpr double MinimumIncrease = 1e-6;
      const double product = std::max(MinimumIncrease, this->ExpectedIncrease(arc, 0)) *
        std::max(MinimumIncrease, this->ExpectedIncrease(arc, 1));
      if (product > largest)
      {
        best = arc;
        largest = product;
      }
    }
    return best;
  }

  const QuantisationProblem& Problem;
  Relaxation& Program;
  std::vector<SeparationRow>& Rows;
  std::vector<double>& RootRelaxation;
  const BranchAndCut::Separate& SeparateCounts;
  EdgeCounts Best;
  double RootBound = -std::numeric_limits<double>::infinity();
  std::size_t RootRows = 0;
  int RoundsOfCuts = 0;
  double MinimumRise = 0.0;
  bool IsUnsolved = false;
  bool IsFirstWanted = false;
  Node Present;
  std::vector<Node> Open;   ///< A heap, the lowest bound first.
  std::vector<Node> Recent; ///< Nodes created since a node with the lowest bound was selected.
  int Backtracks = 0;       ///< Number of returns to recent nodes since then.
  std::array<std::vector<PseudoCost>, 2> PseudoCosts; ///< Down and up, per arc.
};
}

BranchAndCut::BranchAndCut(
  const QuantisationProblem& problem, const std::vector<int>& free, const std::vector<int>& start)
  : Problem(problem)
  , Start(start)
  , Program(problem, free, start)
{
}

void BranchAndCut::AddRow(const SeparationRow& row)
{
  this->Program.AddRow(row);
  this->Rows.push_back(row);
}

EdgeCounts BranchAndCut::Solve(const BranchLimits& limits, const Separate& separate)
{
  this->RootRelaxation.clear();
  return Search(
    this->Problem, this->Program, this->Rows, this->RootRelaxation, separate, this->Start)
    .Run(limits);
}
}
