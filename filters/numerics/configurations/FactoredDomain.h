#pragma once

#include "PlanarDomain.h"
#include "PlanarMesher.h"
#include "PotentialSolver.h"
#include "Singularity.h"

#include <mutex>

namespace crossfield
{
/// Domain with the data that do not depend on singularities: its mesh and the factor of the
/// Laplacian on it. Built once, immutable, and shared by all configurations on it (docs/method.md
/// §15).
class FactoredDomain
{
public:
  /// Meshes and factors a domain. `meshSize` is as in DrillOptions. Singularities of the
  /// configuration on the boundary become vertices of it; interior ones are ignored.
  FactoredDomain(PlanarDomain domain, const Configuration& configuration, double meshSize,
    const Progress& progress = {});

  const PlanarDomain& GetDomain() const { return this->Domain; }
  /// Returns the requested edge length, resolved.
  double GetMeshSize() const { return this->MeshSize; }
  const std::shared_ptr<const PotentialSolver>& GetPotential() const { return this->Potential; }

  /// Returns whether all singularities of a configuration on the boundary are vertices of the mesh.
  bool HasBoundaryVertices(const Configuration& configuration) const;

  /// Returns the mesh with a vertex at every interior singularity, as SolveSeamlessMap requires. If
  /// the singularities are at least two edge lengths away from the boundary and from each other,
  /// this is the Delaunay triangulation in which they replace the vertices near them; otherwise it
  /// is the mesh of MeshThroughPoints.
  TriangleMesh MeshOn(const Configuration& configuration) const;

private:
  PlanarDomain Domain;
  double MeshSize;
  std::shared_ptr<const PotentialSolver> Potential;
  /// Built by the first call of MeshOn; H and W do not need it.
  mutable std::once_flag IsTriangulated;
  mutable std::unique_ptr<const BaseTriangulation> Triangulation;
};
}
