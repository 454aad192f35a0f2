#pragma once

#include "OptimizerStage.h"
#include "StageBoundary.h"
#include "StrengthChanges.h"

#include <optional>
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
  Place Inside(std::size_t i) const { return { this->Start[i].position, -1 }; }
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
  /// Returns whether the inner loops can be aligned after changes: whether as many singularities as
  /// inner loops are left inside, twice as many coordinates as holonomy conditions, because some of
  /// them are held by the clearance; or whether the defects vanish where they are. With at most
  /// twenty inner loops the energy of the defects decides.
  bool CanAlignAfter(const Changes& changes);
  /// Makes the changed configuration the present one.
  void Accept(const Changes& changes);

private:
  /// Returns the singularities inside after changes, or nothing if one would be outside the domain or
  /// where there is one already.
  std::optional<Configuration> InteriorAfter(const Changes& changes) const;

  const OptimizerStage& Stage;
  Configuration Start; ///< Singularities inside at the start, and now.
  Configuration Interior;
  double Diagonal; ///< Of the domain.
  double Radius;   ///< Core radius of the energies.
  StrengthChanges Energies;
};
}
