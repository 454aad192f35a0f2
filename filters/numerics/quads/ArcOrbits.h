#pragma once

#include "BoundarySymmetry.h"
#include "QuantisationProblem.h"

namespace crossfield
{
/// The arcs of a T-mesh that the symmetries of a domain map to each other, which get equal edge
/// counts (docs/method.md §14.3).
class ArcOrbits
{
public:
  /// Finds the orbits for those of the given symmetries that map the T-mesh to itself
  /// (FindArcImages), the targets of a problem to similar ones, and its sums to sums.
  ArcOrbits(const TMesh& mesh, const std::vector<Isometry>& symmetries,
    const QuantisationProblem& problem, double reach);

  /// Returns the number of symmetries with the identity.
  int CountSymmetries() const { return this->Symmetries; }
  /// Gives the arcs of an orbit the mean of their targets and weights, and adds a sum for each but
  /// the first, that its count equals that of the first.
  void Equate(QuantisationProblem& problem) const;

private:
  std::vector<std::vector<int>> Orbits; ///< Of two or more arcs.
  int Symmetries = 1;
};
}
