#include "ConfigurationChange.h"

#include "CandidateEnergies.h"
#include "DomainQueries.h"
#include "OptimizerReport.h"
#include "PoincareHopf.h"
#include "StageBoundary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// A singularity closer to the boundary than this multiple of the clearance is stopped by the
/// barrier, whose slope begins at 2.
constexpr double StoppedFactor = 1.25;
/// Two singularities of opposite sign closer than this multiple of the clearance have met. The
/// barrier keeps them at 1.22 clearances, and slightly farther apart if others pull at them
/// (docs/method.md §5.5).
constexpr double MeetingFactor = 1.5;

/// Returns whether the inner loops can be aligned without singularities i and j, whose sum is `sum`:
/// if enough coordinates are left for the holonomy conditions, or if the others satisfy them where
/// they are.
bool CanAlignWithout(
  const OptimizerStage& stage, const OptimizerState& current, std::size_t i, std::size_t j, int sum)
{
  const std::size_t remaining = stage.placed.interior.size() - (sum == 0 ? 2 : 1);
  if (2 * remaining >= static_cast<std::size_t>(current.defects.size()))
  {
    return true;
  }
  if (sum != 0)
  {
    return false;
  }
  Configuration others = stage.objective->At(current.positions);
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(std::min(i, j)));
  stage.objective->Budget().Spend(stage.objective->EvaluationCost());
  const std::vector<double> defects = stage.potential->Solve(others).holonomyDefect;
  return std::all_of(defects.begin(), defects.end(),
    [](double defect) { return std::abs(defect) < NoticeableDefect; });
}
}

std::vector<std::size_t> StoppedSingularities(
  const OptimizerStage& stage, const OptimizerState& current)
{
  std::vector<std::size_t> stopped;
  for (std::size_t i = 0; i < stage.objective->Count(); ++i)
  {
    if (stage.objective->BoundaryDistance(current.positions, i) <
      StoppedFactor * stage.objective->Clearance())
    {
      stopped.push_back(i);
    }
  }
  return stopped;
}

std::size_t HeldSingularities(const OptimizerState& state)
{
  // The derivative of W by a position is 2π over a distance that is at most 1 here.
  constexpr double Negligible = 0.01;
  std::size_t held = 0;
  for (Eigen::Index i = 0; i < state.barrier.gradient.size(); i += 2)
  {
    held += state.barrier.gradient.segment<2>(i).norm() > Negligible ? 1U : 0U;
  }
  return held;
}

std::optional<ConfigurationChange> FindAnnihilation(
  const OptimizerStage& stage, const OptimizerState& current)
{
  const Configuration& interior = stage.placed.interior;
  for (std::size_t i = 0; i < interior.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const int sum = interior[i].quarterIndex + interior[j].quarterIndex;
      if (interior[i].quarterIndex * interior[j].quarterIndex >= 0 ||
        (current.PositionOf(i) - current.PositionOf(j)).norm() >
          MeetingFactor * stage.objective->Clearance() ||
        !CanAlignWithout(stage, current, i, j, sum))
      {
        continue;
      }
      ConfigurationChange change;
      change.annihilates = true;
      change.tracked = stage.At(current.positions);
      const std::size_t first = std::min(stage.placed.rows[i], stage.placed.rows[j]);
      const std::size_t second = std::max(stage.placed.rows[i], stage.placed.rows[j]);
      const Point middle =
        0.5 * stage.objective->LengthUnit() * (current.PositionOf(i) + current.PositionOf(j));
      change.pair = { change.tracked.origins[first], change.tracked.origins[second] };
      change.events = { Capitalised(change.tracked.Name(first)) + " and " +
        change.tracked.Name(second) + ", which have opposite signs, met at " + Describe(middle) +
        (sum == 0 ? " and were removed."
                  : " and were merged into one with quarter index " + std::to_string(sum) + ".") };
      change.tracked.singularities[first].position = middle;
      change.tracked.singularities[first].quarterIndex = sum;
      change.tracked.Erase(second);
      if (sum == 0)
      {
        change.tracked.Erase(first);
      }
      return change;
    }
  }
  return std::nullopt;
}

std::optional<ConfigurationChange> FindRelease(
  const OptimizerStage& stage, const OptimizerState& current, std::set<std::string>& rejected)
{
  if (stage.placed.rows.size() == stage.tracked.singularities.size())
  {
    return std::nullopt;
  }
  const double clearance = stage.objective->Clearance() * stage.objective->LengthUnit();
  const BoundaryVertices boundary(stage);
  const PlanarDomain& domain = stage.potential->GetDomain();
  CandidateEnergies energies(stage, current);
  const double before = stage.CoreEnergy(current);
  // One that was absorbed was driven to the boundary. It is released only if the energy is lower
  // where the present mesh resolves it, at one or two default edge lengths: a trial takes up to
  // fifty times as many solves.
  const std::array<double, 2> releases = { 10.0 * CoreRadius(domain), 20.0 * CoreRadius(domain) };
  std::vector<CandidateEnergies::Place> places;
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    const Corner& corner = boundary.vertices[v];
    const std::size_t row = RowAt(stage.tracked.singularities, corner.position, boundary.reach);
    if (row < stage.tracked.singularities.size() &&
      stage.tracked.absorbed.count(stage.tracked.origins[row]) != 0)
    {
      places.push_back(energies.At(boundary, v));
      for (const double away : releases)
      {
        places.push_back({ corner.position + away * corner.inward, -1 });
      }
    }
  }
  bool isPrepared = false;
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    const Corner& corner = boundary.vertices[v];
    const std::size_t row = RowAt(stage.tracked.singularities, corner.position, boundary.reach);
    if (row == stage.tracked.singularities.size())
    {
      continue;
    }
    for (const int quarters : { 1, -1 })
    {
      const int remaining = boundary.quarters[v] - quarters;
      const std::string key = "out " + FormatNumber(corner.position.x(), 9) + " " +
        FormatNumber(corner.position.y(), 9) + " " + std::to_string(quarters);
      if (CornerCoefficient(corner, remaining) + Pi >=
          CornerCoefficient(corner, boundary.quarters[v]) ||
        rejected.count(key) != 0)
      {
        continue;
      }
      // Twice the clearance away from both sides of the corner, or halfway to the opposite boundary
      // if that is closer.
      const double distance = std::min(2.0 * clearance / std::sin(0.5 * std::min(corner.angle, Pi)),
        0.5 * DistanceAlongRay(domain, corner.position, corner.inward));
      ConfigurationChange change;
      change.key = key;
      change.tracked = stage.At(current.positions);
      change.events = { Capitalised(change.tracked.Name(row)) + " on the boundary at " +
        Describe(corner.position) + " released a singularity with quarter index " +
        std::to_string(quarters) + " into the interior; quarter index " +
        std::to_string(remaining) + " remains there." };
      const auto released = [&](double away)
      {
        const Singularity inside{ corner.position + away * corner.inward, quarters, 0.0 };
        TrackedConfiguration tracked = change.tracked;
        if (remaining == SmallestRotationIndex(corner.Turning()))
        {
          tracked.singularities[row] = inside;
        }
        else
        {
          tracked.singularities[row].quarterIndex = remaining;
          tracked.singularities.push_back(inside);
          tracked.origins.push_back(BoundaryOrigin);
        }
        return tracked;
      };
      const auto isLowerAt = [&](double away)
      {
        if (!isPrepared)
        {
          energies.Prepare(places);
          isPrepared = true;
        }
        return energies.After({ { energies.At(boundary, v), -quarters },
                 { { corner.position + away * corner.inward, -1 }, quarters } }) < before;
      };
      if (change.tracked.absorbed.count(change.tracked.origins[row]) != 0 &&
        std::none_of(releases.begin(), releases.end(), isLowerAt))
      {
        rejected.insert(key); // changes elsewhere hardly change it
        continue;
      }
      change.tracked = released(distance);
      return change;
    }
  }
  return std::nullopt;
}

std::optional<ConfigurationChange> FindBoundaryMoves(
  const OptimizerStage& stage, const OptimizerState& current, std::set<std::string>& rejected)
{
  ConfigurationChange change;
  change.tracked = stage.At(current.positions);
  TrackedConfiguration& tracked = change.tracked;
  if (tracked.absorbed.empty())
  {
    return std::nullopt;
  }
  const BoundaryVertices boundary(stage);
  const double reach = VertexReach(stage);
  CandidateEnergies energies(stage, current);
  double lowest = energies.After({});
  const auto isFixed = [&](std::size_t row)
  {
    const Point& position = tracked.singularities[row].position;
    const std::string key = "along " + std::to_string(tracked.origins[row]);
    return tracked.absorbed.count(tracked.origins[row]) == 0 || rejected.count(key) != 0 ||
      boundary.At(position) == boundary.vertices.size() || !boundary.IsSmooth(position);
  };
  std::vector<CandidateEnergies::Place> places;
  for (std::size_t row = 0; row < tracked.singularities.size(); ++row)
  {
    if (!isFixed(row))
    {
      const auto around =
        energies.Around(boundary, boundary.At(tracked.singularities[row].position));
      places.insert(places.end(), around.begin(), around.end());
    }
  }
  energies.Prepare(places);
  for (std::size_t row = 0; row < tracked.singularities.size(); ++row)
  {
    const std::string key = "along " + std::to_string(tracked.origins[row]);
    const Point position = tracked.singularities[row].position;
    const std::size_t start = boundary.At(position);
    if (isFixed(row))
    {
      continue;
    }
    const int quarters = tracked.singularities[row].quarterIndex;
    const auto moved = [&](std::size_t v)
    {
      return CandidateEnergies::Changes{ { energies.At(boundary, start), -quarters },
        { energies.At(boundary, v), quarters } };
    };
    const auto energyAt = [&](std::size_t v)
    {
      const Point& target = boundary.vertices[v].position;
      const bool isFree = (target - position).norm() <= reach && boundary.quarters[v] == 0 &&
        boundary.IsSmooth(target) &&
        RowAt(tracked.singularities, target, boundary.reach) == tracked.singularities.size() &&
        boundary.Allows(v, quarters, start);
      if (v == start || !isFree)
      {
        return v == start ? lowest : std::numeric_limits<double>::infinity();
      }
      if (!energies.IsPrepared(energies.At(boundary, v)))
      {
        energies.Prepare(energies.Around(boundary, v));
      }
      return energies.After(moved(v));
    };
    const VertexEnergy found = DescendAlongLoop(boundary, start, energyAt);
    if (found.vertex == start)
    {
      rejected.insert(key); // others move by little, and it would follow them by less
    }
    else
    {
      lowest = found.energy;
      energies.Accept(moved(found.vertex));
      tracked.singularities[row].position = boundary.vertices[found.vertex].position;
      change.key = change.events.empty() ? key : change.key;
      change.events.push_back(Capitalised(tracked.Name(row)) + " moved along the boundary to " +
        Describe(tracked.singularities[row].position) + ".");
    }
  }
  return change.events.empty() ? std::nullopt : std::make_optional(change);
}
}
