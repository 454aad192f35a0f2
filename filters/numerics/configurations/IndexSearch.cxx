#include "IndexSearch.h"

#include "OptimizerSymmetry.h"
#include "OrbitState.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

namespace crossfield
{
namespace
{
/// Which moves are regarded.
enum class NodeChanges
{
  Any,
  None, ///< Those that keep the number of nodes.
  More  ///< Those that add nodes.
};

/// Keeps the moves that change the form least.
class LowestMoves
{
public:
  explicit LowestMoves(NodeChanges changes)
    : Changes(changes)
  {
  }

  void Add(const OrbitState& state, Move move)
  {
    if (this->Moves.size() == Capacity && !(move.energy < this->Moves.front().energy))
    {
      return;
    }
    if (!this->Accepts(state.NodeChange(move)) || !state.IsFree(move))
    {
      return;
    }
    const auto less = [](const Move& a, const Move& b) { return a.energy < b.energy; };
    if (this->Moves.size() == Capacity)
    {
      std::pop_heap(this->Moves.begin(), this->Moves.end(), less);
      this->Moves.back() = move;
    }
    else
    {
      this->Moves.push_back(move);
    }
    std::push_heap(this->Moves.begin(), this->Moves.end(), less);
  }

  std::vector<Move> Release() { return std::move(this->Moves); }

private:
  bool Accepts(int change) const
  {
    return this->Changes == NodeChanges::Any ||
      (this->Changes == NodeChanges::None ? change == 0 : change > 0);
  }

  static constexpr std::size_t Capacity = 400;
  NodeChanges Changes;
  std::vector<Move> Moves; ///< A heap.
};

/// Searches on the orbits of one subgroup.
class OrbitSearch
{
public:
  OrbitSearch(const OrbitForm& form, const Progress& progress)
    : Form(form)
    , Reported(progress)
  {
    for (std::size_t o = 0; o < form.sizes.size(); ++o)
    {
      this->BySize[form.sizes[o]].push_back(static_cast<Eigen::Index>(o));
    }
  }

  /// Returns indices with the sum, or nothing if it cannot be reached.
  std::optional<OrbitState> Start() const
  {
    OrbitState state(this->Form);
    while (state.Sum() != this->Form.total)
    {
      if (!this->AddUnit(state))
      {
        return std::nullopt;
      }
    }
    return state;
  }

  void Descend(OrbitState& state) const { this->Descend(NodeChanges::Any, state); }
  void Shift(OrbitState& state) const { this->Descend(NodeChanges::None, state); }

  /// Returns the lowest of several states that follow from a minimum when one of the moves that add
  /// nodes at the lowest cost is made, and then those that keep their number.
  std::optional<OrbitState> Kick(const OrbitState& minimum) const
  {
    constexpr std::size_t MostKicks = 8;
    LowestMoves lowest(NodeChanges::More);
    this->AddPairs(minimum, false, lowest);
    this->AddHalves(minimum, lowest);
    std::vector<Move> moves = lowest.Release();
    for (Move& move : moves)
    {
      move.energy += minimum.HolonomyChange(move);
    }
    std::sort(moves.begin(), moves.end(),
      [](const Move& a, const Move& b)
      { return std::tie(a.energy, a.orbits) < std::tie(b.energy, b.orbits); });
    std::optional<OrbitState> best;
    // Neighbouring sites have nearly the same energies: each kick is at sites of its own.
    std::set<Eigen::Index> used;
    std::size_t kicks = 0;
    for (std::size_t i = 0; i < moves.size() && kicks < MostKicks; ++i)
    {
      Move move = moves[i];
      bool isNew = true;
      for (int a = 0; a < move.count; ++a)
      {
        isNew = used.insert(move.orbits[a]).second && isNew;
      }
      if (!isNew)
      {
        continue;
      }
      ++kicks;
      OrbitState state = minimum;
      move.energy = state.ChangeBy(move);
      state.Make(move);
      this->Descend(NodeChanges::None, state);
      if (!best || state.Energy() < best->Energy())
      {
        best.emplace(std::move(state));
      }
    }
    return best;
  }

private:
  /// Adds the unit that lowers the energy most for its size.
  bool AddUnit(OrbitState& state) const
  {
    const int missing = this->Form.total - state.Sum();
    const int sign = missing > 0 ? 1 : -1;
    std::optional<Move> best;
    double lowest = std::numeric_limits<double>::infinity();
    for (Eigen::Index o = 0; o < this->Form.linear.size(); ++o)
    {
      const int size = this->Form.sizes[o];
      if (size > std::abs(missing) || !state.Allows(o, sign))
      {
        continue;
      }
      Move move{ { o }, { sign }, 1, state.Single(o, sign) };
      if (move.energy / size < lowest && state.IsFree(move))
      {
        lowest = move.energy / size;
        best = move;
      }
    }
    if (best)
    {
      state.Make(*best);
    }
    return best.has_value();
  }

  void Descend(NodeChanges changes, OrbitState& state) const
  {
    constexpr int MaximumMoves = 2000;
    for (int move = 0; move < MaximumMoves && this->Exchange(changes, state); ++move)
    {
      this->Reported.Report(0.0); // a run may be aborted here
    }
  }

  /// Makes the moves that lower the energy most: first those of present singularities, and if there
  /// are none, those that create some. Returns whether there are any.
  bool Exchange(NodeChanges changes, OrbitState& state) const
  {
    LowestMoves present(changes);
    this->AddPairs(state, true, present);
    if (this->MakeLowest(present.Release(), state))
    {
      return true;
    }
    if (changes == NodeChanges::None)
    {
      return false;
    }
    LowestMoves all(changes);
    this->AddPairs(state, false, all);
    this->AddHalves(state, all);
    return this->MakeLowest(all.Release(), state);
  }

  /// Makes the best of some moves, and after it those that are still nearly as good.
  static bool MakeLowest(std::vector<Move> moves, OrbitState& state)
  {
    constexpr double Noticeable = 1e-6;
    constexpr double NearlyAsGood = 0.8;
    std::vector<double> totals;
    std::vector<std::size_t> order;
    for (const Move& move : moves)
    {
      totals.push_back(move.energy + state.HolonomyChange(move));
      order.push_back(order.size());
    }
    std::sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b)
      { return std::tie(totals[a], a) < std::tie(totals[b], b); });
    bool isMade = false;
    for (const std::size_t i : order)
    {
      if (!(totals[i] < -Noticeable))
      {
        break;
      }
      Move& move = moves[i];
      if (isMade)
      {
        if (!state.Allows(move) || !state.IsFree(move))
        {
          continue;
        }
        move.energy = state.ChangeBy(move);
        if (move.energy + state.HolonomyChange(move) > NearlyAsGood * totals[i])
        {
          continue;
        }
      }
      state.Make(move);
      isMade = true;
    }
    return isMade;
  }

  /// Adds moves of one unit from one orbit to another of the same size, and changes of an orbit that
  /// a fixed point makes up for. `ofPresent`: only those that take a unit from where one is.
  void AddPairs(const OrbitState& state, bool ofPresent, LowestMoves& lowest) const
  {
    const Eigen::VectorXi& indices = state.GetIndices();
    for (const auto& [size, orbits] : this->BySize)
    {
      for (const Eigen::Index i : orbits)
      {
        if (!state.Allows(i, 1))
        {
          continue;
        }
        const double single = state.Single(i, 1);
        const bool isPresent = !ofPresent || indices[i] < 0;
        for (const Eigen::Index j : orbits)
        {
          if ((isPresent || indices[j] > 0) && i != j && state.Allows(j, -1))
          {
            lowest.Add(state,
              { { i, j }, { 1, -1 }, 2, single + state.Single(j, -1) - this->Form.matrix(i, j) });
          }
        }
      }
      if (size == 1 || this->BySize.count(1) == 0)
      {
        continue;
      }
      for (const Eigen::Index fixed : this->BySize.at(1))
      {
        for (const int sign : { 1, -1 })
        {
          const int change = -sign * size;
          if (!state.Allows(fixed, change))
          {
            continue;
          }
          const double single = state.Single(fixed, change);
          for (const Eigen::Index i : orbits)
          {
            if (state.Allows(i, sign))
            {
              lowest.Add(state,
                { { fixed, i }, { change, sign }, 2,
                  single + state.Single(i, sign) + change * sign * this->Form.matrix(fixed, i) });
            }
          }
        }
      }
    }
  }

  /// Adds changes of an orbit that two of half its size make up for.
  void AddHalves(const OrbitState& state, LowestMoves& lowest) const
  {
    for (const auto& [size, orbits] : this->BySize)
    {
      const auto halves = size % 2 == 0 ? this->BySize.find(size / 2) : this->BySize.end();
      if (halves == this->BySize.end() || size == 2)
      {
        continue;
      }
      const std::vector<Eigen::Index>& parts = halves->second;
      for (const int sign : { 1, -1 })
      {
        for (std::size_t a = 0; a < parts.size(); ++a)
        {
          if (!state.Allows(parts[a], -sign))
          {
            continue;
          }
          for (std::size_t b = 0; b < a; ++b)
          {
            if (!state.Allows(parts[b], -sign))
            {
              continue;
            }
            const double both = state.Single(parts[a], -sign) + state.Single(parts[b], -sign) +
              this->Form.matrix(parts[a], parts[b]);
            for (const Eigen::Index i : orbits)
            {
              if (state.Allows(i, sign))
              {
                lowest.Add(state,
                  { { i, parts[a], parts[b] }, { sign, -sign, -sign }, 3,
                    both + state.Single(i, sign) - this->Form.matrix(i, parts[a]) -
                      this->Form.matrix(i, parts[b]) });
              }
            }
          }
        }
      }
    }
  }

  const OrbitForm& Form;
  const Progress Reported;
  std::map<int, std::vector<Eigen::Index>> BySize;
};

/// Returns the elements that map indices to themselves.
Subgroup KeptSymmetries(const CandidateSites& sites, const Eigen::VectorXi& indices)
{
  Subgroup kept;
  for (std::size_t g = 0; g < sites.elements.size(); ++g)
  {
    const std::vector<std::size_t>& images = sites.images[g];
    bool isKept = true;
    for (std::size_t i = 0; i < images.size() && isKept; ++i)
    {
      isKept =
        indices[static_cast<Eigen::Index>(images[i])] == indices[static_cast<Eigen::Index>(i)];
    }
    if (isKept)
    {
      kept.push_back(g);
    }
  }
  return kept;
}

/// Returns the indices of sites from those of orbits.
SiteIndices IndicesOf(const CandidateSites& sites, const OrbitForm& orbits, const OrbitState& state)
{
  SiteIndices result;
  result.indices = Eigen::VectorXi::Zero(static_cast<Eigen::Index>(sites.positions.size()));
  for (std::size_t o = 0; o < orbits.members.size(); ++o)
  {
    for (const std::size_t i : orbits.members[o])
    {
      result.indices[static_cast<Eigen::Index>(i)] =
        state.GetIndices()[static_cast<Eigen::Index>(o)];
    }
  }
  result.kept = KeptSymmetries(sites, result.indices);
  result.objective = state.Energy();
  return result;
}

/// Returns a form with the same values of indices with the right sum. Others, which the search passes,
/// have an energy that depends on where the rest of their flux ends: it is spread over all sites.
IndexForm Balanced(const IndexForm& form)
{
  IndexForm balanced = form;
  Eigen::VectorXd means = form.form.matrix.rowwise().mean();
  means.array() -= 0.5 * means.mean();
  balanced.form.matrix.colwise() -= means;
  balanced.form.matrix.rowwise() -= means.transpose();
  balanced.form.linear += form.total * means;
  return balanced;
}

/// Adds a result that is not among others.
void AddNew(SiteIndices result, std::vector<SiteIndices>& found)
{
  if (std::none_of(found.begin(), found.end(),
        [&](const SiteIndices& other) { return other.indices == result.indices; }))
  {
    found.push_back(std::move(result));
  }
}
}

std::vector<SiteIndices> SearchIndices(
  const CandidateSites& sites, const IndexForm& form, double apart, const Progress& progress)
{
  const auto count = static_cast<Eigen::Index>(sites.positions.size());
  const IndexForm balanced = Balanced(form);
  SitePairs isNear(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j < count; ++j)
    {
      isNear(i, j) =
        i != j && (sites.positions[i] - sites.positions[j]).squaredNorm() < apart * apart ? 1 : 0;
    }
  }
  // With many sites the numbers of nodes hardly differ, and a search takes long.
  constexpr Eigen::Index ManySites = 800;
  const std::vector<Subgroup> subgroups = ClassesOfSubgroups(sites.group);
  std::vector<SiteIndices> found;
  const auto add = [&](SiteIndices result)
  {
    std::vector<Isometry> kept;
    for (const std::size_t g : result.kept)
    {
      kept.push_back(sites.elements[g]);
    }
    result.objective -= WorthOfSymmetries(kept, sites.group);
    AddNew(std::move(result), found);
  };
  for (std::size_t i = 0; i < subgroups.size(); ++i)
  {
    const auto done = [&](std::size_t number)
    { return static_cast<double>(number) / static_cast<double>(subgroups.size()); };
    const OrbitForm orbits = MakeOrbitForm(sites, balanced, isNear, subgroups[i]);
    const OrbitSearch search(orbits, progress.Part(done(i), done(i + 1)));
    std::optional<OrbitState> minimum = search.Start();
    if (!minimum)
    {
      continue;
    }
    search.Descend(*minimum);
    add(IndicesOf(sites, orbits, *minimum));
    if (count <= ManySites)
    {
      if (const std::optional<OrbitState> kicked = search.Kick(*minimum))
      {
        add(IndicesOf(sites, orbits, *kicked));
      }
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [](const SiteIndices& a, const SiteIndices& b) { return a.objective < b.objective; });
  return found;
}

std::vector<SiteIndices> SearchIndicesAtCosts(const CandidateSites& sites, const IndexForm& form,
  const SitePairs& isNear, const std::vector<double>& costs,
  const std::function<bool(const Eigen::VectorXi&)>& isEnough, const Progress& progress)
{
  const IndexForm balanced = Balanced(form);
  const std::vector<Subgroup> subgroups = ClassesOfSubgroups(sites.group);
  std::vector<SiteIndices> found;
  for (std::size_t i = 0; i < subgroups.size(); ++i)
  {
    const auto done = [&](std::size_t number)
    { return static_cast<double>(number) / static_cast<double>(subgroups.size()); };
    OrbitForm orbits = MakeOrbitForm(sites, balanced, isNear, subgroups[i]);
    const OrbitSearch search(orbits, progress.Part(done(i), done(i + 1)));
    orbits.nodeCost = costs.front();
    std::optional<OrbitState> state = search.Start();
    for (std::size_t c = 0; state && c < costs.size(); ++c)
    {
      orbits.nodeCost = costs[c];
      search.Descend(*state);
      while (std::optional<OrbitState> kicked = search.Kick(*state))
      {
        search.Descend(*kicked);
        if (!(kicked->Energy() < state->Energy() - 1e-6 * (1.0 + std::abs(state->Energy()))))
        {
          break;
        }
        state.emplace(std::move(*kicked));
      }
      SiteIndices result = IndicesOf(sites, orbits, *state);
      const bool isLast = isEnough(result.indices);
      AddNew(std::move(result), found);
      if (isLast)
      {
        break;
      }
    }
  }
  return found;
}

SiteIndices ShiftIndices(const CandidateSites& sites, const IndexForm& form,
  const SitePairs& isNear, const Eigen::VectorXi& start, const Subgroup& symmetries)
{
  const OrbitForm orbits = MakeOrbitForm(sites, form, isNear, symmetries);
  OrbitState state(orbits);
  for (std::size_t o = 0; o < orbits.members.size(); ++o)
  {
    const auto orbit = static_cast<Eigen::Index>(o);
    const int index = start[static_cast<Eigen::Index>(orbits.members[o].front())];
    if (index != 0)
    {
      state.Make({ { orbit }, { index }, 1, state.Single(orbit, index) });
    }
  }
  OrbitSearch(orbits, {}).Shift(state);
  return IndicesOf(sites, orbits, state);
}
}
