#include "ConfigurationChange.h"

#include "DomainQueries.h"
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
/// A stopped singularity moves to a corner within this multiple of the clearance whose energy it
/// lowers.
constexpr double CornerReach = 20.0;
/// Otherwise, the maximum move along the boundary as a multiple of the clearance.
constexpr double VertexReach = 6.0;

/// Returns a multiple of the clearance or of CoreRadius, whichever is smaller: the range in which W
/// attracts a singularity does not grow with the clearance. The result is at least twice the
/// clearance, the range of the barrier.
double RangeOf(const OptimizerStage& stage, double clearances)
{
  const double clearance = stage.objective->Clearance() * stage.objective->LengthUnit();
  return std::max(
    2.0 * clearance, clearances * std::min(clearance, CoreRadius(stage.potential->GetDomain())));
}

Point PositionOf(const OptimizerState& current, std::size_t i)
{
  return current.positions.segment<2>(2 * static_cast<Eigen::Index>(i));
}

std::string Capitalised(std::string sentence)
{
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

/// Returns the nearby corner whose energy a singularity lowers most, otherwise the nearby vertex at
/// which the configuration has the lowest energy.
std::size_t FindTarget(const OptimizerStage& stage, const BoundaryVertices& boundary,
  const OptimizerState& current, std::size_t i)
{
  const int quarters = stage.placed.interior[i].quarterIndex;
  const Point position = stage.objective->LengthUnit() * PositionOf(current, i);
  const double cornerReach = RangeOf(stage, CornerReach);
  const double vertexReach = RangeOf(stage, VertexReach);
  double reduction = 0.0;
  std::size_t target = 0;
  std::vector<std::pair<double, std::size_t>> nearest; // sorted by distance
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    const Corner& corner = boundary.vertices[v];
    const double distance = (corner.position - position).norm();
    nearest.emplace_back(distance, v);
    const double saved = CornerCoefficient(corner, boundary.quarters[v]) +
      Pi * quarters * quarters - CornerCoefficient(corner, boundary.quarters[v] + quarters);
    if (distance <= cornerReach && saved > reduction)
    {
      reduction = saved;
      target = v;
    }
  }
  if (reduction > 0.0)
  {
    return target;
  }
  constexpr std::size_t MaximumVertices = 16;
  const std::size_t count = std::min(MaximumVertices, nearest.size());
  std::partial_sort(
    nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end());
  target = nearest.front().second;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < count && nearest[n].first <= vertexReach; ++n)
  {
    const std::size_t v = nearest[n].second;
    const double energy = stage.CoreEnergyOf(
      MovedToVertex(stage, stage.At(current.positions), stage.placed.rows[i], boundary, v)
        .singularities);
    if (energy < lowest)
    {
      lowest = energy;
      target = v;
    }
  }
  return target;
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

std::optional<ConfigurationChange> FindAnnihilation(
  const OptimizerStage& stage, const OptimizerState& current)
{
  const Configuration& interior = stage.placed.interior;
  for (std::size_t i = 0; i < interior.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const int sum = interior[i].quarterIndex + interior[j].quarterIndex;
      const std::size_t remaining = interior.size() - (sum == 0 ? 2 : 1);
      if (interior[i].quarterIndex * interior[j].quarterIndex >= 0 ||
        (PositionOf(current, i) - PositionOf(current, j)).norm() >
          MeetingFactor * stage.objective->Clearance() ||
        2 * remaining < static_cast<std::size_t>(current.defects.size()))
      {
        continue;
      }
      ConfigurationChange change;
      change.annihilates = true;
      change.tracked = stage.At(current.positions);
      const std::size_t first = std::min(stage.placed.rows[i], stage.placed.rows[j]);
      const std::size_t second = std::max(stage.placed.rows[i], stage.placed.rows[j]);
      const Point middle =
        0.5 * stage.objective->LengthUnit() * (PositionOf(current, i) + PositionOf(current, j));
      change.pair = { change.tracked.origins[first], change.tracked.origins[second] };
      change.event = Capitalised(change.tracked.Name(first)) + " and " +
        change.tracked.Name(second) + ", which have opposite signs, met at " + Describe(middle) +
        (sum == 0 ? " and were removed."
                  : " and were merged into one with quarter index " + std::to_string(sum) + ".");
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

std::optional<ConfigurationChange> FindAbsorption(
  const OptimizerStage& stage, const OptimizerState& current, const std::set<std::string>& rejected)
{
  const std::vector<std::size_t> stopped = StoppedSingularities(stage, current);
  if (stopped.empty())
  {
    return std::nullopt;
  }
  const BoundaryVertices boundary(stage);
  for (const std::size_t i : stopped)
  {
    const std::size_t row = stage.placed.rows[i];
    const int quarters = stage.placed.interior[i].quarterIndex;
    const Point position = stage.objective->LengthUnit() * PositionOf(current, i);
    const std::size_t target = FindTarget(stage, boundary, current, i);
    const Corner& corner = boundary.vertices[target];
    // The singularity moves into the boundary only if W decreases in that direction.
    const Point gradient = current.gradient.segment<2>(2 * static_cast<Eigen::Index>(i));
    const std::string key = "in " + std::to_string(row) + " " + Describe(corner.position);
    if (gradient.dot(corner.position - position) > 0.0 || rejected.count(key) != 0)
    {
      continue;
    }
    ConfigurationChange change;
    change.key = key;
    change.tracked = stage.At(current.positions);
    const int sum = boundary.quarters[target] + quarters;
    change.event = Capitalised(change.tracked.Name(row)) + ", quarter index " +
      std::to_string(quarters) + ", reached the boundary at " + Describe(corner.position) +
      " and became part of it: the quarter index there changed from " +
      std::to_string(boundary.quarters[target]) + " to " + std::to_string(sum) + ".";
    change.tracked.absorbed.insert(change.tracked.origins[row]);
    change.tracked = MovedToVertex(stage, change.tracked, row, boundary, target);
    return change;
  }
  return std::nullopt;
}

std::optional<ConfigurationChange> FindRelease(
  const OptimizerStage& stage, const OptimizerState& current, const std::set<std::string>& rejected)
{
  if (stage.placed.rows.size() == stage.tracked.singularities.size())
  {
    return std::nullopt;
  }
  const double clearance = stage.objective->Clearance() * stage.objective->LengthUnit();
  const BoundaryVertices boundary(stage);
  const PlanarDomain& domain = stage.potential->GetDomain();
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    const Corner& corner = boundary.vertices[v];
    const std::size_t row = RowAt(stage, corner.position);
    if (row == stage.tracked.singularities.size())
    {
      continue;
    }
    for (const int quarters : { 1, -1 })
    {
      const int remaining = boundary.quarters[v] - quarters;
      const std::string key = "out " + Describe(corner.position) + " " + std::to_string(quarters);
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
      const Singularity inside{ corner.position + distance * corner.inward, quarters, 0.0 };
      ConfigurationChange change;
      change.key = key;
      change.tracked = stage.At(current.positions);
      change.event = Capitalised(change.tracked.Name(row)) + " on the boundary at " +
        Describe(corner.position) + " released a singularity with quarter index " +
        std::to_string(quarters) + " into the interior; quarter index " +
        std::to_string(remaining) + " remains there.";
      if (remaining == SmallestRotationIndex(corner.Turning()))
      {
        change.tracked.singularities[row] = inside;
      }
      else
      {
        change.tracked.singularities[row].quarterIndex = remaining;
        change.tracked.singularities.push_back(inside);
        change.tracked.origins.push_back(BoundaryOrigin);
      }
      return change;
    }
  }
  return std::nullopt;
}

std::optional<ConfigurationChange> FindBoundaryMove(
  const OptimizerStage& stage, const OptimizerState& current, const std::set<std::string>& rejected)
{
  const TrackedConfiguration tracked = stage.At(current.positions);
  if (tracked.absorbed.empty())
  {
    return std::nullopt;
  }
  const BoundaryVertices boundary(stage);
  const double reach = RangeOf(stage, VertexReach);
  double lowest = stage.CoreEnergyOf(tracked.singularities);
  std::optional<ConfigurationChange> best;
  for (std::size_t row = 0; row < tracked.singularities.size(); ++row)
  {
    const std::string key = "along " + std::to_string(tracked.origins[row]);
    const Point& position = tracked.singularities[row].position;
    const bool mayMove = tracked.absorbed.count(tracked.origins[row]) != 0 &&
      rejected.count(key) == 0 && boundary.IsSmooth(position);
    for (std::size_t v = 0; mayMove && v < boundary.vertices.size(); ++v)
    {
      const Point& target = boundary.vertices[v].position;
      if ((target - position).norm() > reach || !boundary.IsSmooth(target) ||
        RowAt(stage, target) < tracked.singularities.size())
      {
        continue;
      }
      TrackedConfiguration moved = tracked;
      moved.singularities[row].position = target;
      const double energy = stage.CoreEnergyOf(moved.singularities);
      if (energy < lowest)
      {
        lowest = energy;
        best = ConfigurationChange();
        best->tracked = moved;
        best->key = key;
        best->event =
          Capitalised(tracked.Name(row)) + " moved along the boundary to " + Describe(target) + ".";
      }
    }
  }
  return best;
}
}
