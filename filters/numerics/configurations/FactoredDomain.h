#pragma once

#include "PlanarDomain.h"
#include "PlanarMesher.h"
#include "PotentialSolver.h"
#include "Singularity.h"

#include <mutex>

namespace crossfield
{
/// A domain with what belongs to it whatever the singularities: its mesh and the factor of the Laplacian on it. Made
/// once, never changed, and shared by all configurations that are tried on it (docs/method.md §15).
class FactoredDomain
{
public:
  /// Meshes and factors. `meshSize` as in DrillOptions. Singularities of the configuration that lie on the boundary become
  /// vertices of it; those inside mean nothing.
  FactoredDomain(PlanarDomain domain, const Configuration& configuration, double meshSize,
    const Progress& progress = {});

  const PlanarDomain& GetDomain() const { return this->Domain; }
  /// The edge length that was asked for, resolved.
  double GetMeshSize() const { return this->MeshSize; }
  const std::shared_ptr<const PotentialSolver>& GetPotential() const { return this->Potential; }

  /// Whether the singularities of a configuration that lie on the boundary are vertices of the mesh.
  bool Serves(const Configuration& configuration) const;

  /// The mesh with a vertex on every singularity inside, as SolveSeamlessMap needs it: the Delaunay triangulation of its vertices with these
  /// instead of those next to them, where they keep two edges' lengths from the boundary and from each other; else that of
  /// MeshOnPoints.
  TriangleMesh MeshOn(const Configuration& configuration) const;

private:
  PlanarDomain Domain;
  double MeshSize;
  std::shared_ptr<const PotentialSolver> Potential;
  /// Made by the first MeshOn: who wants H or W alone has no use for it.
  mutable std::once_flag IsTriangulated;
  mutable std::unique_ptr<const KeptTriangulation> Triangulation;
};
}
