#pragma once

#include "CrouzeixRaviart.h"
#include "PoincareHopf.h"
#include "PotentialSolver.h"

#include <map>

namespace crossfield
{
/// The boundary condition of one problem: the quarter indices chosen for boundary vertices, the
/// Poincaré-Hopf count that follows, and the crosses on the boundary (docs/method.md §2.4, §7.1).
struct Alignment
{
  std::vector<CornerChoice>
    corners; ///< As given; elsewhere the cross turns by its smallest rotation.
  std::map<int, int> chosenQuarters; ///< The same choices by mesh vertex.
  PoincareHopfCount count;
  /// u = e^{4iτ} on aligned edges, in the order of mesh.boundary; 0 on holes.
  ComplexVector crosses;
};

/// Aligns crosses with the boundary. `pointQuarters` is the sum of the quarter indices of
/// singularities without holes. Throws Error when a choice is not at a vertex of an aligned loop.
/// Does not check that the count is consistent.
Alignment AlignWithBoundary(const PlanarTopology& topology,
  const std::vector<CornerChoice>& corners = {}, int pointQuarters = 0);

/// Copies the prescribed crosses into u, a value per edge, and returns the largest change |Δu|.
double SetAlignedCrosses(
  const PlanarTopology& topology, const Alignment& alignment, ComplexVector& u);

/// A boundary condition together with the factored Laplacian of the mesh. Any number of problems
/// share one factor.
struct PotentialProblem
{
  std::shared_ptr<const PotentialSolver> potential;
  Alignment alignment;

  /// Throws Error when the quarter indices violate Poincaré-Hopf.
  PotentialProblem(std::shared_ptr<const PotentialSolver> solver, Alignment boundaryCondition);

  const PlanarTopology& Topology() const { return this->potential->GetTopology(); }
};
}
