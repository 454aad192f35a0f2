#pragma once

#include "CrouzeixRaviart.h"
#include "PoincareHopf.h"
#include "PotentialSolver.h"

#include <map>

namespace crossfield
{
/// What the boundary of a mesh asks of crosses in one question: the quarter indices chosen for its
/// vertices, the count that follows, and the crosses themselves (docs/method.md §2.4, §7.1).
struct Alignment
{
  std::vector<CornerChoice> corners; ///< As they were given; elsewhere the smallest rotation.
  std::map<int, int> chosenQuarters; ///< The same by vertex of the mesh.
  PoincareHopfCount count;
  /// u = e^{4iτ} on aligned edges, in the order of mesh.boundary; 0 on holes.
  ComplexVector crosses;
};

/// `pointQuarters`: sum of the quarter indices of singularities without holes. Throws Error when a
/// choice is not at a vertex of an aligned loop. An inconsistent count is no error here.
Alignment AlignWithBoundary(const MeshTopology& topology,
  const std::vector<CornerChoice>& corners = {}, int pointQuarters = 0);

/// Copies the prescribed crosses into u and returns the largest change that this was.
double SetAlignedCrosses(
  const MeshTopology& topology, const Alignment& alignment, ComplexVector& u);

/// One question to the factored Laplacian of a mesh. Any number of them share a factor.
struct PotentialProblem
{
  std::shared_ptr<const PotentialSolver> potential;
  Alignment alignment;

  /// Throws Error when the quarter indices violate Poincaré-Hopf.
  PotentialProblem(std::shared_ptr<const PotentialSolver> solver, Alignment question);

  const MeshTopology& Topology() const { return this->potential->GetTopology(); }
};
}
