#include "ArcProgram.h"

#include "Index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// What is left to search: everything within bounds.
struct Branch
{
  double bound = 0.0; ///< Of the costs in it.
  std::vector<ColumnBounds> bounds;
  std::shared_ptr<const RelaxationBasis> basis; ///< Where to begin; none: with that at hand.
  int arc = -1;                                 ///< That was branched on last.
  std::size_t isMore = 0;                       ///< 1 where its number was raised.
  double step = 0.0;                            ///< By how much the number must change.
};

/// How much bounds have risen per step.
struct Rise
{
  double sum = 0.0;
  int count = 0;
};

class BranchAndCut
{
public:
  BranchAndCut(const ArcProblem& problem, ArcRelaxation& relaxation, std::vector<ArcRow>& rows,
    const ArcProgram::Separate& separate, std::vector<int> start)
    : Problem(problem)
    , Relaxation(relaxation)
    , Rows(rows)
    , SeparateCounts(separate)
  {
    this->Rises.fill(std::vector<Rise>(problem.Count()));
    this->Take(std::move(start));
  }

  ProgramCounts Search(int mostNodes)
  {
    bool isOpen = this->Begin();
    while (isOpen && this->Best.nodes < mostNodes)
    {
      ++this->Best.nodes;
      const bool divides = this->Visit();
      // Rows that the root knows raise its bound, by cuts of them, by more than rows of the leaves. Few are worth a new root.
      constexpr std::size_t ManyRows = 10;
      isOpen =
        this->Rows.size() >= this->RootRows + ManyRows ? this->Begin() : divides || this->Next();
    }
    this->Best.bound = std::min(this->Best.cost, isOpen ? this->LeastBound() : this->Best.cost);
    if (this->IsUnsolved)
    {
      this->Best.bound = this->RootBound;
    }
    return this->Best;
  }

private:
  static bool IsDearer(const Branch& a, const Branch& b) { return a.bound > b.bound; }

  void Take(std::vector<int> counts)
  {
    this->Best.cost = this->Problem.Cost(counts);
    this->Best.counts = std::move(counts);
    this->Relaxation.SetLimit(this->GetLimit());
  }

  double GetLimit() const { return this->Best.cost - CostRounding(this->Best.cost); }

  double LeastBound() const
  {
    double least = this->Present.bound;
    for (const std::vector<Branch>* const branches : { &this->Open, &this->Recent })
    {
      for (const Branch& branch : *branches)
      {
        least = std::min(least, branch.bound);
      }
    }
    return std::max(least, this->RootBound);
  }

  /// At the root, with all rows: whether there is something to search.
  bool Begin()
  {
    this->Open.clear();
    this->Recent.clear();
    this->Returns = 0;
    this->Present = {};
    this->Relaxation.Narrow({});
    // Most of what cuts can raise the bound by.
    constexpr int MostRounds = 20;
    for (int round = 0; round <= MostRounds; ++round)
    {
      if (!this->SolveApart())
      {
        return false;
      }
      this->RootBound = std::max(this->RootBound, this->Relaxation.GetCost());
      this->Relaxation.Tighten();
      if (this->IsIntegral() || !this->Relaxation.Cut())
      {
        break;
      }
    }
    this->RootRows = this->Rows.size();
    this->Best.relaxed.clear();
    for (std::size_t a = 0; a < this->Problem.Count(); ++a)
    {
      this->Best.relaxed.push_back(this->Relaxation.Relaxed(static_cast<int>(a)));
    }
    this->Present.bound = this->RootBound;
    return true;
  }

  bool IsIntegral() const
  {
    return std::all_of(this->Relaxation.GetFree().begin(), this->Relaxation.GetFree().end(),
      [this](int arc) { return this->Relaxation.IsIntegral(arc); });
  }

  /// Adds rows until the optimum is not whole, or joins nothing. Whether there is one.
  bool SolveApart()
  {
    RelaxationStatus status = this->Relaxation.Solve();
    for (; status == RelaxationStatus::Optimal && this->IsIntegral();
         status = this->Relaxation.Solve())
    {
      std::vector<int> counts = this->Relaxation.GetCounts();
      const std::vector<ArcRow> broken = this->SeparateCounts(counts);
      if (broken.empty())
      {
        this->Take(std::move(counts));
        break;
      }
      for (const ArcRow& row : broken)
      {
        this->Relaxation.Add(row);
        this->Rows.push_back(row);
      }
    }
    this->IsUnsolved = this->IsUnsolved || status == RelaxationStatus::Unsolved;
    return status == RelaxationStatus::Optimal;
  }

  /// Whether the present branch was divided into two: the one that rises less is the present one then.
  bool Visit()
  {
    this->Relaxation.Narrow(this->Present.bounds);
    if (this->Present.basis)
    {
      this->Relaxation.SetBasis(*this->Present.basis);
    }
    if (!this->SolveApart())
    {
      return false;
    }
    const double cost = this->Relaxation.GetCost();
    if (this->Present.arc >= 0)
    {
      Rise& rise = this->Rises[this->Present.isMore][Index(this->Present.arc)];
      rise.sum += std::max(0.0, cost - this->Present.bound) / this->Present.step;
      ++rise.count;
    }
    const int arc = this->ArcToBranchOn();
    if (arc < 0)
    {
      return false;
    }
    this->Divide(arc, cost);
    return true;
  }

  void Divide(int arc, double cost)
  {
    const auto below = static_cast<int>(std::floor(this->Relaxation.Relaxed(arc)));
    std::array<Branch, 2> parts = { this->Present, this->Present };
    const std::array<std::vector<ColumnBounds>, 2> narrower = { this->Relaxation.AtMost(arc, below),
      this->Relaxation.AtLeast(arc, below + 1) };
    for (std::size_t isMore = 0; isMore < 2; ++isMore)
    {
      Branch& part = parts[isMore];
      part.bound = cost;
      part.bounds.insert(part.bounds.end(), narrower[isMore].begin(), narrower[isMore].end());
      part.basis = nullptr;
      part.arc = arc;
      part.isMore = isMore;
      part.step = this->StepOf(arc, isMore);
    }
    const std::size_t next = this->RiseOf(arc, 1) < this->RiseOf(arc, 0) ? 1 : 0;
    this->Present = std::move(parts[next]);
    parts[1 - next].basis = std::make_shared<const RelaxationBasis>(this->Relaxation.GetBasis());
    this->Recent.push_back(std::move(parts[1 - next]));
  }

  /// The last branch that was left aside, so that whole numbers are met, and after some of these the cheapest of all. Whether
  /// there is one.
  bool Next()
  {
    constexpr int MostReturns = 8;
    while (!this->Recent.empty() && this->Returns < MostReturns)
    {
      this->Present = std::move(this->Recent.back());
      this->Recent.pop_back();
      if (this->Present.bound < this->GetLimit())
      {
        ++this->Returns;
        return true;
      }
    }
    this->Returns = 0;
    for (Branch& branch : this->Recent)
    {
      this->Open.push_back(std::move(branch));
      std::push_heap(this->Open.begin(), this->Open.end(), IsDearer);
    }
    this->Recent.clear();
    if (this->Open.empty() || this->Open.front().bound >= this->GetLimit())
    {
      return false;
    }
    std::pop_heap(this->Open.begin(), this->Open.end(), IsDearer);
    this->Present = std::move(this->Open.back());
    this->Open.pop_back();
    return true;
  }

  /// How far it is to the next whole number.
  double StepOf(int arc, std::size_t isMore) const
  {
    const double value = this->Relaxation.Relaxed(arc);
    return isMore == 1 ? std::floor(value) + 1.0 - value : value - std::floor(value);
  }

  /// What the bound is expected to rise by: as it did before, or the arc's cost where that has not been seen.
  double RiseOf(int arc, std::size_t isMore) const
  {
    const Rise& rise = this->Rises[isMore][Index(arc)];
    return this->StepOf(arc, isMore) *
      (rise.count > 0 ? rise.sum / rise.count : this->Problem.weight[Index(arc)]);
  }

  /// The one with the largest product of both rises (Achterberg, Koch, Martin 2005); −1 where all are whole.
  int ArcToBranchOn() const
  {
    int best = -1;
    double most = 0.0;
    for (const int arc : this->Relaxation.GetFree())
    {
      if (this->Relaxation.IsIntegral(arc))
      {
        continue;
      }
      // So that one side that does not rise leaves the other one some say.
      constexpr double LeastRise = 1e-6;
      const double product =
        std::max(LeastRise, this->RiseOf(arc, 0)) * std::max(LeastRise, this->RiseOf(arc, 1));
      if (product > most)
      {
        best = arc;
        most = product;
      }
    }
    return best;
  }

  const ArcProblem& Problem;
  ArcRelaxation& Relaxation;
  std::vector<ArcRow>& Rows;
  const ArcProgram::Separate& SeparateCounts;
  ProgramCounts Best;
  double RootBound = -std::numeric_limits<double>::infinity();
  std::size_t RootRows = 0;
  bool IsUnsolved = false;
  Branch Present;
  std::vector<Branch> Open;   ///< A heap, the cheapest first.
  std::vector<Branch> Recent; ///< Left aside since the cheapest was taken.
  int Returns = 0;            ///< To those.
  std::array<std::vector<Rise>, 2> Rises;
};
}

ArcProgram::ArcProgram(
  const ArcProblem& problem, const std::vector<int>& free, const std::vector<int>& counts)
  : Problem(problem)
  , Start(counts)
  , Relaxation(problem, free, counts)
{
}

void ArcProgram::Add(const ArcRow& row)
{
  this->Relaxation.Add(row);
  this->Rows.push_back(row);
}

ProgramCounts ArcProgram::Solve(int mostNodes, const Separate& separate)
{
  return BranchAndCut(this->Problem, this->Relaxation, this->Rows, separate, this->Start)
    .Search(mostNodes);
}
}
