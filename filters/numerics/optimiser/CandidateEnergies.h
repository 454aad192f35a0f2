#pragma once

#include "OptimizerStage.h"
#include "StageBoundary.h"
#include "StrengthChanges.h"

#include <vector>

namespace crossfield
{
/// Energies OptimizerStage::CoreEnergy of configurations that differ from the present one in a few
/// quarter indices: candidates for a change. No candidate needs a solve of its own
/// (StrengthChanges.h).
class CandidateEnergies
{
public:
  using Place = StrengthChanges::Place;
  using Changes = std::vector<StrengthChanges::Change>;

  CandidateEnergies(const OptimizerStage& stage, const OptimizerState& current);

  /// Returns the place of interior singularity i of the stage.
  Place Inside(std::size_t i) const { return { this->Interior[i].position, -1 }; }
  /// Returns the place of a boundary vertex.
  Place At(const BoundaryVertices& boundary, std::size_t vertex) const;
  /// Returns a boundary vertex and its neighbours: those at which a walk along the boundary that
  /// comes to the vertex needs the energy next.
  std::vector<Place> Around(const BoundaryVertices& boundary, std::size_t vertex) const;

  /// Prepares places together, which costs less than one after the other.
  void Prepare(const std::vector<Place>& places);
  bool IsPrepared(const Place& place) const { return this->Energies.IsPrepared(place); }
  /// Returns the energy after changes; infinity if a singularity would be added outside the domain or
  /// where there is one already.
  double After(const Changes& changes);

private:
  const OptimizerStage& Stage;
  Configuration Interior;
  StrengthChanges Energies;
};
}
