#include "CandidateEnergies.h"

#include "DomainQueries.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
CandidateEnergies::CandidateEnergies(const OptimizerStage& stage, const OptimizerState& current)
  : Stage(stage)
  , Start(stage.objective->At(current.positions))
  , Interior(Start)
  , Diagonal(stage.potential->GetDomain().Diagonal())
  , Radius(CoreRadius(stage.potential->GetDomain()))
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
  constexpr int Steps = 1;
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

std::optional<Configuration> CandidateEnergies::InteriorAfter(const Changes& changes) const
{
  const PlanarDomain& domain = this->Stage.potential->GetDomain();
  Configuration interior = this->Interior;
  for (const StrengthChanges::Change& change : changes)
  {
    if (change.place.vertex >= 0)
    {
      continue;
    }
    const auto present = std::find_if(interior.begin(), interior.end(),
      [&](const Singularity& other) { return other.position == change.place.position; });
    if (present != interior.end())
    {
      present->quarterIndex += change.quarters;
      if (present->quarterIndex == 0)
      {
        interior.erase(present);
      }
      continue;
    }
    const double minimum = 1e-6 * this->Diagonal; // as in PointPotential::RequireSolvable
    if (!(SignedDistance(change.place.position, domain) > minimum) ||
      RowAt(interior, change.place.position, minimum) < interior.size())
    {
      return std::nullopt;
    }
    interior.push_back({ change.place.position, change.quarters, 0.0 });
  }
  return interior;
}

double CandidateEnergies::After(const Changes& changes)
{
  const std::optional<Configuration> interior = this->InteriorAfter(changes);
  if (!interior)
  {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<Place> places;
  for (const StrengthChanges::Change& change : changes)
  {
    places.push_back(change.place);
  }
  this->Prepare(places);
  const StrengthChanges::Value value = this->Energies.Evaluate(changes);
  return value.energy - value.logarithmCoefficient * std::log(this->Radius) +
    CoreOverlapEnergy(*interior, this->Radius);
}

bool CandidateEnergies::CanAlignAfter(const Changes& changes)
{
  const std::optional<Configuration> interior = this->InteriorAfter(changes);
  const Eigen::Index loops = this->Stage.potential->GetPeriodBasis().cols();
  // The defects of few loops are small, and the energy of their harmonic fields counts.
  constexpr Eigen::Index FewLoops = 20;
  return interior &&
    (loops <= FewLoops || static_cast<Eigen::Index>(interior->size()) >= loops ||
      this->Energies.Evaluate(changes).largestDefect < NoticeableDefect);
}

void CandidateEnergies::Accept(const Changes& changes)
{
  this->Interior = *this->InteriorAfter(changes);
  this->Energies.Accept(changes);
}
}
