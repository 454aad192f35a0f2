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
/// Nearer than this times the clearance is held by the barrier, whose slope begins at 2.
constexpr double Held = 1.25;
/// Nearer than this two of opposite sign have met. The barrier holds them at 1.22 clearances, and those that others
/// pull at a little farther apart (docs/method.md §5.5).
constexpr double Met = 1.5;
/// A corner within this times the clearance is where a held singularity goes, if it relieves it.
constexpr double CornerReach = 20.0;
/// How far it may go along the boundary otherwise.
constexpr double VertexReach = 6.0;

/// A length of so many clearances; of those of CoreRadius where they are larger, since it is about how far W
/// pulls, and not where the barrier holds. Not less than from there to the boundary.
double ReachOf(const OptimizerStage& stage, double clearances)
{
  const double clearance = stage.objective->Clearance() * stage.objective->Unit();
  return std::max(
    2.0 * clearance, clearances * std::min(clearance, CoreRadius(stage.potential->GetDomain())));
}

Point PlaceOf(const OptimizerPlace& here, std::size_t i)
{
  return here.place.segment<2>(2 * static_cast<Eigen::Index>(i));
}

std::string Capital(std::string sentence)
{
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

/// The corner nearby that a singularity relieves most, else the vertex nearby at which it costs least.
std::size_t FindTarget(const OptimizerStage& stage, const BoundaryVertices& boundary,
  const OptimizerPlace& here, std::size_t i)
{
  const int quarters = stage.placed.interior[i].quarterIndex;
  const Point place = stage.objective->Unit() * PlaceOf(here, i);
  const double cornerReach = ReachOf(stage, CornerReach);
  const double vertexReach = ReachOf(stage, VertexReach);
  double relief = 0.0;
  std::size_t target = 0;
  std::vector<std::pair<double, std::size_t>> near; // by distance
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    const Corner& corner = boundary.vertices[v];
    const double distance = (corner.position - place).norm();
    near.emplace_back(distance, v);
    const double own = CornerCoefficient(corner, boundary.quarters[v]) + Pi * quarters * quarters -
      CornerCoefficient(corner, boundary.quarters[v] + quarters);
    if (distance <= cornerReach && own > relief)
    {
      relief = own;
      target = v;
    }
  }
  if (relief > 0.0)
  {
    return target;
  }
  constexpr std::size_t MostVertices = 16;
  const std::size_t count = std::min(MostVertices, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
  target = near.front().second;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < count && near[n].first <= vertexReach; ++n)
  {
    const std::size_t v = near[n].second;
    const double energy = stage.CoreEnergyOf(
      MovedToVertex(stage, stage.At(here.place), stage.placed.rows[i], boundary, v).singularities);
    if (energy < least)
    {
      least = energy;
      target = v;
    }
  }
  return target;
}
}

std::vector<std::size_t> HeldSingularities(const OptimizerStage& stage, const OptimizerPlace& here)
{
  std::vector<std::size_t> held;
  for (std::size_t i = 0; i < stage.objective->Count(); ++i)
  {
    if (stage.objective->BoundaryDistance(here.place, i) < Held * stage.objective->Clearance())
    {
      held.push_back(i);
    }
  }
  return held;
}

std::optional<ConfigurationChange> FindMeeting(
  const OptimizerStage& stage, const OptimizerPlace& here)
{
  const Configuration& interior = stage.placed.interior;
  for (std::size_t i = 0; i < interior.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const int sum = interior[i].quarterIndex + interior[j].quarterIndex;
      const std::size_t left = interior.size() - (sum == 0 ? 2 : 1);
      if (interior[i].quarterIndex * interior[j].quarterIndex >= 0 ||
        (PlaceOf(here, i) - PlaceOf(here, j)).norm() > Met * stage.objective->Clearance() ||
        2 * left < static_cast<std::size_t>(here.defects.size()))
      {
        continue;
      }
      ConfigurationChange change;
      change.meets = true;
      change.tracked = stage.At(here.place);
      const std::size_t first = std::min(stage.placed.rows[i], stage.placed.rows[j]);
      const std::size_t second = std::max(stage.placed.rows[i], stage.placed.rows[j]);
      const Point middle = 0.5 * stage.objective->Unit() * (PlaceOf(here, i) + PlaceOf(here, j));
      change.pair = { change.tracked.origins[first], change.tracked.origins[second] };
      change.event = Capital(change.tracked.Name(first)) + " and " + change.tracked.Name(second) +
        ", of opposite sign, met at " + Describe(middle) +
        (sum == 0 ? " and were taken out."
                  : " and became one with quarter index " + std::to_string(sum) + ".");
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

std::optional<ConfigurationChange> FindPressed(
  const OptimizerStage& stage, const OptimizerPlace& here, const std::set<std::string>& refused)
{
  const std::vector<std::size_t> held = HeldSingularities(stage, here);
  if (held.empty())
  {
    return std::nullopt;
  }
  const BoundaryVertices boundary(stage);
  for (const std::size_t i : held)
  {
    const std::size_t row = stage.placed.rows[i];
    const int quarters = stage.placed.interior[i].quarterIndex;
    const Point place = stage.objective->Unit() * PlaceOf(here, i);
    const std::size_t target = FindTarget(stage, boundary, here, i);
    const Corner& corner = boundary.vertices[target];
    // Only where W falls on the way there.
    const Point pull = here.gradient.segment<2>(2 * static_cast<Eigen::Index>(i));
    const std::string key = "in " + std::to_string(row) + " " + Describe(corner.position);
    if (pull.dot(corner.position - place) > 0.0 || refused.count(key) != 0)
    {
      continue;
    }
    ConfigurationChange change;
    change.key = key;
    change.tracked = stage.At(here.place);
    const int sum = boundary.quarters[target] + quarters;
    change.event = Capital(change.tracked.Name(row)) + ", quarter index " +
      std::to_string(quarters) + ", was pressed against the boundary at " +
      Describe(corner.position) + " and became part of it: the quarter index there is now " +
      std::to_string(sum) + " instead of " + std::to_string(boundary.quarters[target]) + ".";
    change.tracked.absorbed.insert(change.tracked.origins[row]);
    change.tracked = MovedToVertex(stage, change.tracked, row, boundary, target);
    return change;
  }
  return std::nullopt;
}

std::optional<ConfigurationChange> FindLoose(
  const OptimizerStage& stage, const OptimizerPlace& here, const std::set<std::string>& refused)
{
  if (stage.placed.rows.size() == stage.tracked.singularities.size())
  {
    return std::nullopt;
  }
  const double clearance = stage.objective->Clearance() * stage.objective->Unit();
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
      const int left = boundary.quarters[v] - quarters;
      const std::string key = "out " + Describe(corner.position) + " " + std::to_string(quarters);
      if (CornerCoefficient(corner, left) + Pi >= CornerCoefficient(corner, boundary.quarters[v]) ||
        refused.count(key) != 0)
      {
        continue;
      }
      // Twice the clearance off both sides of the corner, or the middle of what there is.
      const double way = std::min(2.0 * clearance / std::sin(0.5 * std::min(corner.angle, Pi)),
        0.5 * ClearWay(domain, corner.position, corner.inward));
      const Singularity inside{ corner.position + way * corner.inward, quarters, 0.0 };
      ConfigurationChange change;
      change.key = key;
      change.tracked = stage.At(here.place);
      change.event = Capital(change.tracked.Name(row)) + " on the boundary at " +
        Describe(corner.position) + " sent a singularity of quarter index " +
        std::to_string(quarters) + " inside; " + std::to_string(left) + " is left there.";
      if (left == SmallestRotationIndex(corner.Turning()))
      {
        change.tracked.singularities[row] = inside;
      }
      else
      {
        change.tracked.singularities[row].quarterIndex = left;
        change.tracked.singularities.push_back(inside);
        change.tracked.origins.push_back(BoundaryOrigin);
      }
      return change;
    }
  }
  return std::nullopt;
}

std::optional<ConfigurationChange> FindSlide(
  const OptimizerStage& stage, const OptimizerPlace& here, const std::set<std::string>& refused)
{
  const TrackedConfiguration tracked = stage.At(here.place);
  if (tracked.absorbed.empty())
  {
    return std::nullopt;
  }
  const BoundaryVertices boundary(stage);
  const double reach = ReachOf(stage, VertexReach);
  double least = stage.CoreEnergyOf(tracked.singularities);
  std::optional<ConfigurationChange> best;
  for (std::size_t row = 0; row < tracked.singularities.size(); ++row)
  {
    const std::string key = "along " + std::to_string(tracked.origins[row]);
    const Point& place = tracked.singularities[row].position;
    const bool slides = tracked.absorbed.count(tracked.origins[row]) != 0 &&
      refused.count(key) == 0 && boundary.IsSmooth(place);
    for (std::size_t v = 0; slides && v < boundary.vertices.size(); ++v)
    {
      const Point& target = boundary.vertices[v].position;
      if ((target - place).norm() > reach || !boundary.IsSmooth(target) ||
        RowAt(stage, target) < tracked.singularities.size())
      {
        continue;
      }
      TrackedConfiguration moved = tracked;
      moved.singularities[row].position = target;
      const double energy = stage.CoreEnergyOf(moved.singularities);
      if (energy < least)
      {
        least = energy;
        best = ConfigurationChange();
        best->tracked = moved;
        best->key = key;
        best->event =
          Capital(tracked.Name(row)) + " went on along the boundary to " + Describe(target) + ".";
      }
    }
  }
  return best;
}
}
