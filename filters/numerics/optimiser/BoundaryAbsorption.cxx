#include "BoundaryAbsorption.h"

#include "CandidateEnergies.h"
#include "OptimizerReport.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// A stopped singularity moves to a corner within this multiple of the clearance whose energy it
/// lowers.
constexpr double CornerReach = 20.0;

/// Returns the nearby corner whose energy a singularity lowers most, otherwise the vertex with the
/// lowest energy on the way down from the nearest one, or one that already has a singularity; only
/// vertices whose angle allows the index.
VertexEnergy FindTarget(const OptimizerStage& stage, const BoundaryVertices& boundary,
  const OptimizerState& current, std::size_t i, CandidateEnergies& energies)
{
  const int quarters = stage.placed.interior[i].quarterIndex;
  const Point position = stage.objective->LengthUnit() * current.PositionOf(i);
  const double cornerReach = ClearanceRange(stage, CornerReach);
  const double vertexReach = VertexReach(stage);
  double reduction = 0.0;
  std::size_t target = 0;
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    const Corner& corner = boundary.vertices[v];
    const double distance = (corner.position - position).norm();
    const double saved = CornerCoefficient(corner, boundary.quarters[v]) +
      Pi * quarters * quarters - CornerCoefficient(corner, boundary.quarters[v] + quarters);
    if (distance <= cornerReach && saved > reduction &&
      boundary.Allows(v, boundary.quarters[v] + quarters))
    {
      reduction = saved;
      target = v;
    }
  }
  const auto energyAt = [&](std::size_t v)
  {
    if (!energies.IsPrepared(energies.At(boundary, v)))
    {
      energies.Prepare(energies.Around(boundary, v));
    }
    return energies.After(
      { { energies.Inside(i), -quarters }, { energies.At(boundary, v), quarters } });
  };
  if (reduction > 0.0)
  {
    return { target, energyAt(target) };
  }
  VertexEnergy lowest{ boundary.vertices.size(), std::numeric_limits<double>::infinity() };
  const std::size_t nearest = NearestAllowedVertex(boundary, position, vertexReach, quarters);
  if (nearest < boundary.vertices.size())
  {
    lowest = DescendAlongLoop(boundary, nearest,
      [&](std::size_t v)
      {
        return (boundary.vertices[v].position - position).norm() <= vertexReach &&
            boundary.Allows(v, boundary.quarters[v] + quarters)
          ? energyAt(v)
          : std::numeric_limits<double>::infinity();
      });
  }
  // Singularities on the boundary attract those of opposite sign, and may hold equal ones,
  // except on loops within reach, which are too small for a map with both in one vertex.
  for (const Singularity& other : stage.tracked.singularities)
  {
    const std::size_t v = (other.position - position).norm() <= vertexReach
      ? boundary.At(other.position)
      : boundary.vertices.size();
    const double energy = v < boundary.vertices.size() && v != lowest.vertex &&
        boundary.LoopLength(v) > vertexReach && boundary.Allows(v, boundary.quarters[v] + quarters)
      ? energyAt(v)
      : lowest.energy;
    lowest = energy < lowest.energy ? VertexEnergy{ v, energy } : lowest;
  }
  return lowest;
}

/// Returns the places where FindTarget needs energies first.
std::vector<CandidateEnergies::Place> FirstPlaces(const OptimizerStage& stage,
  const BoundaryVertices& boundary, const OptimizerState& current, std::size_t i,
  const CandidateEnergies& energies)
{
  std::vector<CandidateEnergies::Place> places = { energies.Inside(i) };
  const std::size_t nearest =
    NearestAllowedVertex(boundary, stage.objective->LengthUnit() * current.PositionOf(i),
      VertexReach(stage), stage.placed.interior[i].quarterIndex);
  if (nearest < boundary.vertices.size())
  {
    const auto around = energies.Around(boundary, nearest);
    places.insert(places.end(), around.begin(), around.end());
  }
  return places;
}

/// A stopped singularity and the boundary vertex that would absorb it.
struct Absorption
{
  std::size_t interior = 0; ///< Number among the interior singularities.
  std::size_t row = 0;      ///< Of the tracked singularities.
  std::size_t vertex = 0;
  std::string key;
  double energy = 0.0; ///< With this singularity absorbed.
};

/// Returns the stopped singularities towards whose vertex W decreases, without rejected ones. Where
/// the vertex is not known yet, it is found with `energies`; if they are null, the nearest vertex
/// stands for it.
std::vector<Absorption> DueAbsorptions(const OptimizerStage& stage, const OptimizerState& current,
  const std::set<std::string>& rejected, CandidateEnergies* energies, BoundaryTargets& targets)
{
  // Relative to the clearance; the vertices that are compared are spread over several clearances.
  constexpr double SamePlace = 0.2;
  std::vector<Absorption> due;
  const std::vector<std::size_t> stopped = StoppedSingularities(stage, current);
  if (stopped.empty())
  {
    return due;
  }
  const BoundaryVertices boundary(stage);
  const auto isKnown = [&](std::size_t i)
  {
    const auto known = targets.found.find(i);
    return known != targets.found.end() &&
      (known->second.from - current.PositionOf(i)).norm() <
      SamePlace * stage.objective->Clearance();
  };
  std::vector<CandidateEnergies::Place> places;
  for (const std::size_t i : stopped)
  {
    if (energies != nullptr && !isKnown(i))
    {
      const auto first = FirstPlaces(stage, boundary, current, i, *energies);
      places.insert(places.end(), first.begin(), first.end());
    }
  }
  if (!places.empty())
  {
    energies->Prepare(places);
  }
  for (const std::size_t i : stopped)
  {
    const Point unit = current.PositionOf(i);
    const Point position = stage.objective->LengthUnit() * unit;
    const VertexEnergy target = isKnown(i) ? targets.found.at(i).target
      : energies != nullptr                ? FindTarget(stage, boundary, current, i, *energies)
                                           : VertexEnergy{ NearestVertex(boundary, position), 0.0 };
    if (energies != nullptr && !isKnown(i))
    {
      targets.found.insert_or_assign(i, BoundaryTargets::Found{ unit, target });
    }
    if (target.vertex == boundary.vertices.size())
    {
      continue;
    }
    const Point& place = boundary.vertices[target.vertex].position;
    // The singularity moves into the boundary only if W decreases in that direction.
    const Point gradient = current.gradient.segment<2>(2 * static_cast<Eigen::Index>(i));
    const std::size_t row = stage.placed.rows[i];
    const std::string key = "in " + std::to_string(row) + " " + FormatNumber(place.x(), 9) + " " +
      FormatNumber(place.y(), 9);
    if (gradient.dot(place - position) <= 0.0 && rejected.count(key) == 0)
    {
      due.push_back({ i, row, target.vertex, key, target.energy });
    }
  }
  return due;
}

/// Adds a singularity to the quarter index of its vertex, and returns the sentence about it.
std::string Absorb(
  const Absorption& absorption, BoundaryVertices& boundary, TrackedConfiguration& tracked)
{
  const int quarters = tracked.singularities[absorption.row].quarterIndex;
  const int before = boundary.quarters[absorption.vertex];
  const std::string event = Capitalised(tracked.Name(absorption.row)) + ", quarter index " +
    std::to_string(quarters) + ", reached the boundary at " +
    Describe(boundary.vertices[absorption.vertex].position) +
    " and became part of it: the quarter index there changed from " + std::to_string(before) +
    " to " + std::to_string(before + quarters) + ".";
  tracked.absorbed.insert(tracked.origins[absorption.row]);
  tracked = MovedToVertex(tracked, absorption.row, boundary, absorption.vertex);
  boundary.quarters[absorption.vertex] += quarters;
  return event;
}
}

bool IsAbsorptionDue(const OptimizerStage& stage, const OptimizerState& current,
  const std::set<std::string>& rejected, BoundaryTargets& targets)
{
  return !DueAbsorptions(stage, current, rejected, nullptr, targets).empty();
}

std::optional<ConfigurationChange> FindAbsorption(const OptimizerStage& stage,
  const OptimizerState& current, std::set<std::string>& rejected, BoundaryTargets& targets,
  bool several)
{
  if (StoppedSingularities(stage, current).empty())
  {
    return std::nullopt;
  }
  CandidateEnergies energies(stage, current);
  std::vector<Absorption> due = DueAbsorptions(stage, current, rejected, &energies, targets);
  BoundaryVertices boundary(stage);
  const auto with = [&](const Absorption& absorption)
  {
    const int quarters = stage.placed.interior[absorption.interior].quarterIndex;
    return CandidateEnergies::Changes{ { energies.Inside(absorption.interior), -quarters },
      { energies.At(boundary, absorption.vertex), quarters } };
  };
  due.erase(std::remove_if(due.begin(), due.end(),
              [&](const Absorption& absorption)
              {
                const bool isPossible = energies.CanAlignAfter(with(absorption));
                if (!isPossible)
                {
                  rejected.insert(absorption.key);
                }
                return !isPossible;
              }),
    due.end());
  if (due.empty())
  {
    return std::nullopt;
  }
  ConfigurationChange change;
  change.tracked = stage.At(current.positions);
  due.resize(several ? due.size() : 1);
  if (due.size() > 1)
  {
    std::stable_sort(due.begin(), due.end(),
      [](const Absorption& a, const Absorption& b) { return a.energy < b.energy; });
  }
  double lowest = due.size() > 1 ? energies.After(with(due.front())) : 0.0;
  change.key = due.front().key;
  const double nearby = VertexReach(stage);
  std::vector<Point> places; // of absorbed singularities
  for (std::size_t n = 0; n < due.size(); ++n)
  {
    const Point& place = boundary.vertices[due[n].vertex].position;
    if (n > 0)
    {
      // Neighbours change each other's vertex; they wait until the others have moved.
      if (std::any_of(places.begin(), places.end(),
            [&](const Point& other) { return (other - place).norm() <= nearby; }))
      {
        continue;
      }
      // The energy of one alone differs from its energy together with the previous ones.
      const double energy = energies.After(with(due[n]));
      if (!(energy < lowest) || !energies.CanAlignAfter(with(due[n])))
      {
        continue;
      }
      lowest = energy;
      change.several = true;
    }
    const std::size_t rows = change.tracked.singularities.size();
    places.push_back(place);
    if (due.size() > 1)
    {
      energies.Accept(with(due[n]));
    }
    change.events.push_back(Absorb(due[n], boundary, change.tracked));
    const bool isErased = change.tracked.singularities.size() < rows;
    for (std::size_t other = n + 1; other < due.size(); ++other)
    {
      due[other].row -= isErased && due[other].row > due[n].row ? 1U : 0U;
    }
  }
  return change;
}
}
