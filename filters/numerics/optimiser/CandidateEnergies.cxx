#include "CandidateEnergies.h"

#include "DomainQueries.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
CandidateEnergies::CandidateEnergies(const OptimizerStage& stage, const OptimizerState& current)
  : Stage(stage)
  , Interior(stage.objective->At(current.positions))
  , Energies(stage.objective->Energy(), Interior)
{
  stage.objective->Budget().Spend(stage.objective->EvaluationCost());
}

CandidateEnergies::Place CandidateEnergies::At(
  const BoundaryVertices& boundary, std::size_t vertex) const
{
  return { boundary.vertices[vertex].position,
    this->Stage.potential->GetProblem().Topology().VertexOf(boundary.vertices[vertex]) };
}

std::vector<CandidateEnergies::Place> CandidateEnergies::Around(
  const BoundaryVertices& boundary, std::size_t vertex) const
{
  constexpr int Steps = 2;
  std::vector<Place> places = { this->At(boundary, vertex) };
  for (const std::vector<std::size_t>* neighbours : { &boundary.next, &boundary.previous })
  {
    std::size_t v = vertex;
    for (int step = 0; step < Steps; ++step)
    {
      v = (*neighbours)[v];
      places.push_back(this->At(boundary, v));
    }
  }
  return places;
}

void CandidateEnergies::Prepare(const std::vector<Place>& places)
{
  // Measured: four responses take as long as one solve.
  constexpr std::size_t PlacesPerSolve = 4;
  const std::size_t added = this->Energies.Prepare(places);
  this->Stage.objective->Budget().Spend((added + PlacesPerSolve - 1) / PlacesPerSolve);
}

double CandidateEnergies::After(const Changes& changes)
{
  const PlanarDomain& domain = this->Stage.potential->GetDomain();
  std::vector<Place> places;
  Configuration interior = this->Interior;
  for (const StrengthChanges::Change& change : changes)
  {
    places.push_back(change.place);
    if (change.place.vertex >= 0)
    {
      continue;
    }
    const auto present = std::find_if(interior.begin(), interior.end(),
      [&](const Singularity& other) { return other.position == change.place.position; });
    if (present == interior.end())
    {
      const double minimum = 1e-6 * domain.Diagonal(); // as in PointPotential::RequireSolvable
      if (!(SignedDistance(change.place.position, domain) > minimum) ||
        RowAt(interior, change.place.position, minimum) < interior.size())
      {
        return std::numeric_limits<double>::infinity();
      }
      interior.push_back({ change.place.position, change.quarters, 0.0 });
    }
    else if (present->quarterIndex += change.quarters; present->quarterIndex == 0)
    {
      interior.erase(present);
    }
  }
  this->Prepare(places);
  const StrengthChanges::Value value = this->Energies.Evaluate(changes);
  const double radius = CoreRadius(domain);
  return value.energy - value.logarithmCoefficient * std::log(radius) +
    CoreOverlapEnergy(interior, radius);
}
}
