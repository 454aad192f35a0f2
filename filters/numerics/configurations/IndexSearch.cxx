#include "IndexSearch.h"

#include "OptimizerSymmetry.h"
#include "Parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>

namespace crossfield
{
namespace
{
/// Elements of the group that are regarded, by their numbers.
using Subgroup = std::vector<std::size_t>;

/// Returns one subgroup of each class of conjugate subgroups, the trivial one last.
std::vector<Subgroup> ClassesOfSubgroups(const SymmetryGroup& group)
{
  std::vector<Subgroup> classes;
  const auto order = static_cast<std::size_t>(group.order);
  for (std::size_t rotations = order; rotations >= 1; --rotations)
  {
    if (order % rotations != 0)
    {
      continue;
    }
    const std::size_t step = order / rotations;
    Subgroup turns;
    for (std::size_t i = 0; i < order; i += step)
    {
      turns.push_back(i);
    }
    // A rotation by one step of the group moves an axis by two.
    const std::size_t axes = !group.reflects ? 0 : step % 2 == 0 ? 2 : 1;
    for (std::size_t axis = 0; axis < axes; ++axis)
    {
      Subgroup reflected = turns;
      for (std::size_t i = axis; i < order; i += step)
      {
        reflected.push_back(order + i);
      }
      classes.push_back(reflected);
    }
    classes.push_back(turns);
  }
  return classes;
}

/// The quadratic form in indices that are equal on each orbit of a subgroup.
struct OrbitForm
{
  std::vector<std::vector<std::size_t>> members; ///< Sites of each orbit.
  Eigen::VectorXd linear;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd defects;
  Eigen::MatrixXd defectChanges;
  Eigen::MatrixXd defectEnergy;
  Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic> isNear; ///< Not used together.
  std::vector<int> sizes;
  std::vector<int> limits; ///< Of the absolute value of an index.
  int total = 0;
};

OrbitForm MakeOrbitForm(const CandidateSites& sites, const IndexForm& given,
  const Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic>& isNear,
  const Subgroup& subgroup)
{
  OrbitForm form;
  const std::size_t count = sites.positions.size();
  std::vector<bool> isDone(count, false);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isDone[i])
    {
      continue;
    }
    std::vector<std::size_t> orbit;
    for (const std::size_t g : subgroup)
    {
      const std::size_t image = sites.images[g][i];
      if (!isDone[image])
      {
        isDone[image] = true;
        orbit.push_back(image);
      }
    }
    bool isCrowded = false;
    for (const std::size_t a : orbit)
    {
      for (const std::size_t b : orbit)
      {
        isCrowded = isCrowded || (a != b && isNear(a, b) != 0);
      }
    }
    if (!isCrowded)
    {
      form.members.push_back(std::move(orbit));
    }
  }
  const auto orbits = static_cast<Eigen::Index>(form.members.size());
  const StrengthChanges::Form& sum = given.form;
  const Eigen::Index islands = sum.defects.size();
  form.linear = Eigen::VectorXd::Zero(orbits);
  form.defectChanges = Eigen::MatrixXd::Zero(islands, orbits);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(sum.matrix.rows(), orbits);
  for (Eigen::Index o = 0; o < orbits; ++o)
  {
    for (const std::size_t i : form.members[o])
    {
      form.linear[o] += sum.linear[i];
      form.defectChanges.col(o) += sum.defectChanges.col(i);
      columns.col(o) += sum.matrix.col(i);
    }
  }
  form.matrix = Eigen::MatrixXd::Zero(orbits, orbits);
  form.isNear = decltype(form.isNear)::Zero(orbits, orbits);
  for (Eigen::Index o = 0; o < orbits; ++o)
  {
    for (const std::size_t i : form.members[o])
    {
      form.matrix.row(o) += columns.row(i);
    }
    const std::size_t first = form.members[o].front();
    for (Eigen::Index p = 0; p < orbits; ++p)
    {
      // all members are images of the first
      form.isNear(o, p) = p != o &&
          std::any_of(form.members[p].begin(), form.members[p].end(),
            [&](std::size_t i) { return isNear(first, i) != 0; })
        ? 1
        : 0;
    }
    form.sizes.push_back(static_cast<int>(form.members[o].size()));
    form.limits.push_back(form.sizes.back() == 1 && subgroup.size() > 1 ? 4 : 1);
  }
  form.defects = sum.defects;
  form.defectEnergy = sum.defectEnergy;
  // Islands on an axis have defects 0 or π, which no symmetric change of positions removes.
  form.defectEnergy *= subgroup.size() > 2 ? 1.0 : 0.1;
  form.total = given.total;
  return form;
}

/// A change of the indices of up to three orbits.
struct Move
{
  std::array<Eigen::Index, 3> orbits = {};
  std::array<int, 3> changes = {};
  int count = 0;
  double energy = 0.0; ///< Change of the form.
};

/// Indices of orbits while they change.
class OrbitState
{
public:
  OrbitState(const OrbitForm& form, double nodeCost)
    : Form(form)
    , Indices(Eigen::VectorXi::Zero(form.linear.size()))
    , Gradient(form.linear)
    , Blocked(Eigen::VectorXi::Zero(form.linear.size()))
    , Defects(form.defects)
    , NodeCost(nodeCost)
    , Holonomy(this->HolonomyOf(form.defects))
  {
  }

  int Sum() const { return this->Total; }
  const Eigen::VectorXi& GetIndices() const { return this->Indices; }
  double Energy() const { return this->Value + this->Holonomy; }

  bool Allows(Eigen::Index orbit, int change) const
  {
    return std::abs(this->Indices[orbit] + change) <= this->Form.limits[orbit];
  }

  /// Returns the change of the form by a single change, without that of the defects.
  double Single(Eigen::Index orbit, int change) const
  {
    const int index = this->Indices[orbit];
    return change * this->Gradient[orbit] +
      0.5 * change * change * this->Form.matrix(orbit, orbit) +
      this->NodeCost * this->Form.sizes[orbit] * (std::abs(index + change) - std::abs(index));
  }

  bool Allows(const Move& move) const
  {
    for (int a = 0; a < move.count; ++a)
    {
      if (!this->Allows(move.orbits[a], move.changes[a]))
      {
        return false;
      }
    }
    return true;
  }

  /// Returns the change of the form by a move.
  double ChangeBy(const Move& move) const
  {
    double change = 0.0;
    for (int a = 0; a < move.count; ++a)
    {
      change += this->Single(move.orbits[a], move.changes[a]);
      for (int b = 0; b < a; ++b)
      {
        change +=
          move.changes[a] * move.changes[b] * this->Form.matrix(move.orbits[a], move.orbits[b]);
      }
    }
    return change;
  }

  /// Returns whether the sites that a move occupies are free.
  bool IsFree(const Move& move) const
  {
    for (int a = 0; a < move.count; ++a)
    {
      const Eigen::Index orbit = move.orbits[a];
      if (this->Indices[orbit] != 0 || move.changes[a] == 0)
      {
        continue;
      }
      int blocked = this->Blocked[orbit];
      for (int b = 0; b < move.count; ++b)
      {
        const Eigen::Index other = move.orbits[b];
        if (b == a || this->Form.isNear(orbit, other) == 0)
        {
          continue;
        }
        const bool was = this->Indices[other] != 0;
        const bool is = this->Indices[other] + move.changes[b] != 0;
        blocked += is ? (was ? 0 : 1) : (was ? -1 : 0);
      }
      if (blocked > 0)
      {
        return false;
      }
    }
    return true;
  }

  /// Returns the change of the energy of the defects.
  double HolonomyChange(const Move& move) const
  {
    if (this->Defects.size() == 0)
    {
      return 0.0;
    }
    Eigen::VectorXd defects = this->Defects;
    for (int a = 0; a < move.count; ++a)
    {
      defects += move.changes[a] * this->Form.defectChanges.col(move.orbits[a]);
    }
    return this->HolonomyOf(defects) - this->Holonomy;
  }

  void Make(const Move& move)
  {
    this->Value += move.energy;
    for (int a = 0; a < move.count; ++a)
    {
      const Eigen::Index orbit = move.orbits[a];
      const int change = move.changes[a];
      this->Gradient += change * this->Form.matrix.col(orbit);
      this->Defects += change * this->Form.defectChanges.col(orbit);
      this->Total += change * this->Form.sizes[orbit];
      const bool was = this->Indices[orbit] != 0;
      this->Indices[orbit] += change;
      const bool is = this->Indices[orbit] != 0;
      if (was != is)
      {
        this->Blocked += (is ? 1 : -1) * this->Form.isNear.col(orbit).cast<int>();
      }
    }
    this->Holonomy = this->HolonomyOf(this->Defects);
  }

private:
  double HolonomyOf(const Eigen::VectorXd& defects) const
  {
    if (defects.size() == 0)
    {
      return 0.0;
    }
    const Eigen::VectorXd wrapped =
      defects.unaryExpr([](double defect) { return WrapAngle(defect); });
    return 0.5 * wrapped.dot(this->Form.defectEnergy * wrapped);
  }

  const OrbitForm& Form;
  Eigen::VectorXi Indices;
  Eigen::VectorXd Gradient;
  Eigen::VectorXi Blocked;
  Eigen::VectorXd Defects;
  double NodeCost;
  double Holonomy;
  double Value = 0.0;
  int Total = 0;
};

/// Keeps the moves that change the form least.
class LowestMoves
{
public:
  void Add(const OrbitState& state, Move move)
  {
    if (this->Moves.size() == Capacity && !(move.energy < this->Moves.front().energy))
    {
      return;
    }
    if (!state.IsFree(move))
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
  static constexpr std::size_t Capacity = 400;
  std::vector<Move> Moves; ///< A heap.
};

/// Searches on the orbits of one subgroup.
class OrbitSearch
{
public:
  explicit OrbitSearch(const OrbitForm& form)
    : Form(form)
  {
    for (std::size_t o = 0; o < form.sizes.size(); ++o)
    {
      this->BySize[form.sizes[o]].push_back(static_cast<Eigen::Index>(o));
    }
  }

  /// Returns a minimum that no move lowers, or nothing if the sum cannot be reached.
  std::optional<OrbitState> Run(double nodeCost) const
  {
    OrbitState state(this->Form, nodeCost);
    while (state.Sum() != this->Form.total)
    {
      if (!this->AddUnit(state))
      {
        return std::nullopt;
      }
    }
    constexpr int MaximumMoves = 2000;
    for (int move = 0; move < MaximumMoves && this->Exchange(state); ++move)
    {
    }
    return state;
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

  /// Makes the moves that lower the energy most: first those of present singularities, and if there
  /// are none, those that create some. Returns whether there are any.
  bool Exchange(OrbitState& state) const
  {
    LowestMoves present;
    this->AddPairs(state, true, present);
    if (this->MakeLowest(present.Release(), state))
    {
      return true;
    }
    LowestMoves all;
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
  std::map<int, std::vector<Eigen::Index>> BySize;
};

/// Returns the number of elements that map indices to themselves.
std::size_t CountSymmetries(const CandidateSites& sites, const Eigen::VectorXi& indices)
{
  std::size_t count = 0;
  for (const std::vector<std::size_t>& images : sites.images)
  {
    bool isKept = true;
    for (std::size_t i = 0; i < images.size() && isKept; ++i)
    {
      isKept =
        indices[static_cast<Eigen::Index>(images[i])] == indices[static_cast<Eigen::Index>(i)];
    }
    count += isKept ? 1U : 0U;
  }
  return count;
}
}

std::vector<SiteIndices> SearchIndices(
  const CandidateSites& sites, const IndexForm& form, double apart)
{
  const auto count = static_cast<Eigen::Index>(sites.positions.size());
  // Unbalanced indices, which the search passes, have an energy that depends on where the rest of
  // their flux ends: it is spread over all sites.
  IndexForm balanced = form;
  Eigen::VectorXd means = form.form.matrix.rowwise().mean();
  means.array() -= 0.5 * means.mean();
  balanced.form.matrix.colwise() -= means;
  balanced.form.matrix.rowwise() -= means.transpose();
  balanced.form.linear += form.total * means;
  Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic> isNear(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j < count; ++j)
    {
      isNear(i, j) =
        i != j && (sites.positions[i] - sites.positions[j]).squaredNorm() < apart * apart ? 1 : 0;
    }
  }
  // Different numbers of nodes are minima at different costs.
  constexpr std::array<double, 3> NodeCosts = { 0.0, -4.0, 2.0 };
  // With many sites the numbers hardly differ, and a search takes long.
  constexpr Eigen::Index ManySites = 800;
  const std::size_t costs = count > ManySites ? 1 : NodeCosts.size();
  std::vector<SiteIndices> found;
  for (const Subgroup& subgroup : ClassesOfSubgroups(sites.group))
  {
    const OrbitForm orbits = MakeOrbitForm(sites, balanced, isNear, subgroup);
    const OrbitSearch search(orbits);
    std::array<std::optional<SiteIndices>, NodeCosts.size()> results;
    ForParts(costs,
      [&](std::size_t part)
      {
        const std::optional<OrbitState> state = search.Run(NodeCosts[part]);
        if (!state)
        {
          return;
        }
        SiteIndices result;
        result.indices = Eigen::VectorXi::Zero(count);
        int nodes = 0;
        for (std::size_t o = 0; o < orbits.members.size(); ++o)
        {
          for (const std::size_t i : orbits.members[o])
          {
            result.indices[static_cast<Eigen::Index>(i)] =
              state->GetIndices()[static_cast<Eigen::Index>(o)];
            nodes += std::abs(result.indices[static_cast<Eigen::Index>(i)]);
          }
        }
        result.energy = state->Energy() - NodeCosts[part] * nodes;
        result.symmetries = CountSymmetries(sites, result.indices);
        results[part] = std::move(result);
      });
    for (std::optional<SiteIndices>& result : results)
    {
      const bool isNew = result &&
        std::none_of(found.begin(), found.end(),
          [&](const SiteIndices& other) { return other.indices == result->indices; });
      if (isNew)
      {
        found.push_back(std::move(*result));
      }
    }
  }
  const auto objective = [](const SiteIndices& one)
  { return one.energy - WorthOfSymmetries(one.symmetries); };
  std::stable_sort(found.begin(), found.end(),
    [&](const SiteIndices& a, const SiteIndices& b) { return objective(a) < objective(b); });
  return found;
}
}
