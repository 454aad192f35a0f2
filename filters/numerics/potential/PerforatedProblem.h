#pragma once

#include "CrouzeixRaviart.h"
#include "PoincareHopf.h"
#include "PotentialSolver.h"

#include <map>

namespace crossfield
{
/// What every solve on a perforated domain starts from: a drilled mesh with its edges, loops, count
/// of quarter indices, prescribed crosses and factored Laplacian.
struct PerforatedProblem
{
  const TriangleMesh& mesh;
  EdgeNumbering edges;
  std::vector<BoundaryLoop> loops;
  PoincareHopfCount count;
  std::vector<CornerChoice> corners; ///< As they were given.
  std::map<int, int> chosenQuarters; ///< The same by vertex of the mesh.
  /// u = e^{4iτ} on the edges of outer and inner loops, in the order of mesh.boundary; 0 on holes.
  ComplexVector aligned;
  std::unique_ptr<PotentialSolver> potential;
  double assembleSeconds = 0.0;
  double factorSeconds = 0.0;

  /// `chosenCorners`: quarter indices chosen for vertices of outer and inner loops; at the others
  /// the cross makes the smallest rotation. `pointQuarters`: sum of the quarter indices of
  /// singularities without holes. Throws Error when the quarter indices violate Poincaré-Hopf.
  explicit PerforatedProblem(const TriangleMesh& drilled,
    PotentialSolver::Periods periods = PotentialSolver::Periods::Islands,
    const std::vector<CornerChoice>& chosenCorners = {}, int pointQuarters = 0,
    const Progress& progress = {});

  /// Number of inner loops.
  Eigen::Index IslandCount() const;

  /// Boundary edge (position in mesh.boundary) that ends where each boundary edge starts.
  std::vector<int> PreviousBoundaryEdges() const;
  /// A boundary edge of the outer loop, where integration along edges starts.
  int FirstOuterEdge() const;
  /// Copies the prescribed crosses into u and returns the largest change that this was.
  double Align(ComplexVector& u) const;
};
}
