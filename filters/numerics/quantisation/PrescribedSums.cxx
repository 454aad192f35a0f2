#include "PrescribedSums.h"

#include "BranchAndCut.h"
#include "Separation.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the row that excludes a violation: the one of the map's signs, which leads to good counts
/// but excludes other ones, or the weaker one that every separated solution satisfies.
SeparationRow RowFor(const Violation& violation, const TMesh& mesh, const std::vector<int>& counts,
  const std::vector<double>& target, bool strong)
{
  SeparationRow row = MakeSeparationRow(violation, mesh, counts, target);
  if (violation.path.empty() || (strong && !row.terms.empty() && !row.Holds(counts)))
  {
    return row;
  }
  row = {};
  for (const int arc : violation.arcs)
  {
    row.terms.emplace_back(arc, 1);
  }
  return row;
}

/// Finds out which prescribed sums contradict each other.
class ConflictSearch
{
public:
  ConflictSearch(const TMesh& mesh, const QuantisationProblem& problem)
    : Mesh(mesh)
    , Problem(problem)
    , All(problem.sums)
  {
    for (const CountSum& sum : problem.sums)
    {
      if (std::find(this->Names.begin(), this->Names.end(), sum.name) == this->Names.end())
      {
        this->Names.push_back(sum.name);
      }
    }
  }

  /// Returns the names of sums that contradict each other, without any that could be left out.
  std::vector<std::string> Find()
  {
    this->Reduce();
    return this->Names;
  }

  std::string Describe()
  {
    this->Reduce();
    if (this->Names.empty())
    {
      return "No edge counts fit the separatrices; use a finer mesh.";
    }
    std::string listed = this->Names.front();
    for (std::size_t i = 1; i < this->Names.size(); ++i)
    {
      listed += (i + 1 == this->Names.size() ? " and " : ", ") + this->Names[i];
    }
    if (this->Names.size() == 1)
    {
      return listed + " fits no mesh of these singularities; " + this->Nearest("leave it out");
    }
    const std::string out = this->IsFeasibleWithout(this->Names.back())
      ? "leave one out"
      : "prescribe fewer of the numbers";
    if (this->Names.size() == 2 && this->AreOneStrip())
    {
      return listed + " are sides of one strip of quads; give equal numbers or " + out + ".";
    }
    return listed + " contradict each other, because strips of quads lead from one to the other; " +
      this->Nearest(out);
  }

private:
  /// Returns whether there are counts for these sums.
  bool IsFeasible(std::vector<CountSum> sums)
  {
    this->Problem.sums = std::move(sums);
    return FindFeasibleCounts(this->Mesh, this->Problem).has_value();
  }

  std::vector<CountSum> SumsOf(const std::vector<std::string>& names) const
  {
    std::vector<CountSum> sums;
    std::copy_if(this->All.begin(), this->All.end(), std::back_inserter(sums),
      [&names](const CountSum& sum)
      { return std::find(names.begin(), names.end(), sum.name) != names.end(); });
    return sums;
  }

  /// Leaves out names without which the others still contradict each other.
  void Reduce()
  {
    for (std::size_t i = 0; i < this->Names.size();)
    {
      std::vector<std::string> others = this->Names;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      if (!others.empty() && !this->IsFeasible(this->SumsOf(others)))
      {
        this->Names = std::move(others);
      }
      else
      {
        ++i;
      }
    }
  }

  bool IsFeasibleWithout(const std::string& name)
  {
    std::vector<CountSum> sums = this->All;
    sums.erase(std::remove_if(sums.begin(), sums.end(),
                 [&name](const CountSum& sum) { return sum.name == name; }),
      sums.end());
    return this->IsFeasible(std::move(sums));
  }

  /// Returns the sum of a name that is a single positive number, or null.
  const CountSum* NumberOf(const std::string& name) const
  {
    const CountSum* found = nullptr;
    for (const CountSum& sum : this->All)
    {
      if (sum.name == name)
      {
        if (found != nullptr || sum.minimum != sum.maximum || sum.minimum <= 0)
        {
          return nullptr;
        }
        found = &sum;
      }
    }
    return found;
  }

  /// Returns whether a name is feasible with another number.
  bool IsFeasibleWith(std::vector<CountSum> sums, const std::string& name, int number)
  {
    for (CountSum& sum : sums)
    {
      if (sum.name == name)
      {
        sum.minimum = sum.maximum = number;
      }
    }
    return this->IsFeasible(std::move(sums));
  }

  /// Returns whether the two numbers can only be equal.
  bool AreOneStrip()
  {
    const CountSum* const first = this->NumberOf(this->Names[0]);
    if (first == nullptr || this->NumberOf(this->Names[1]) == nullptr)
    {
      return false;
    }
    const std::vector<CountSum> sums = this->SumsOf(this->Names);
    const int number = first->minimum;
    return this->IsFeasibleWith(sums, this->Names[1], number) &&
      !this->IsFeasibleWith(sums, this->Names[1], number + 1) &&
      !this->IsFeasibleWith(sums, this->Names[1], number - 1);
  }

  /// Returns the remedy: the nearest number of the last name with which everything fits, or another
  /// one.
  std::string Nearest(const std::string& otherwise)
  {
    constexpr int MaximumDistance = 12;
    const CountSum* const sum = this->NumberOf(this->Names.back());
    for (int distance = 1; sum != nullptr && distance <= MaximumDistance; ++distance)
    {
      for (const int number : { sum->minimum + distance, sum->minimum - distance })
      {
        if (number > 0 && this->IsFeasibleWith(this->All, this->Names.back(), number))
        {
          const std::string side = this->Names.back().substr(0, this->Names.back().rfind(':') + 1);
          return "give " + side + std::to_string(number) + " or " + otherwise + ".";
        }
      }
    }
    return otherwise + ".";
  }

  const TMesh& Mesh;
  QuantisationProblem Problem;
  const std::vector<CountSum> All;
  std::vector<std::string> Names;
};
}

std::optional<std::vector<int>> FindFeasibleCounts(
  const TMesh& mesh, const QuantisationProblem& problem)
{
  // The first dive finds counts in nearly all cases; infeasible problems are recognised at the root
  // unless numbers are only of the wrong parity.
  constexpr int MaximumNodes = 300;
  std::vector<int> all(problem.Count());
  std::iota(all.begin(), all.end(), 0);
  for (const bool strong : { true, false })
  {
    EdgeCounts found =
      BranchAndCut(problem, all, {})
        .Solve({ MaximumNodes },
          [&](const std::vector<int>& counts)
          {
            std::vector<SeparationRow> rows;
            for (const Violation& violation : FindViolations(mesh, counts))
            {
              rows.push_back(RowFor(violation, mesh, counts, problem.target, strong));
            }
            return rows;
          });
    if (!found.counts.empty())
    {
      return std::move(found.counts);
    }
  }
  return std::nullopt;
}

std::vector<std::string> FindConflict(const TMesh& mesh, const QuantisationProblem& problem)
{
  return ConflictSearch(mesh, problem).Find();
}

std::string DescribeConflict(const TMesh& mesh, const QuantisationProblem& problem)
{
  return ConflictSearch(mesh, problem).Describe();
}
}
