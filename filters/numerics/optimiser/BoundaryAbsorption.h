#pragma once

#include "ConfigurationChange.h"
#include "StageBoundary.h"

#include <map>

namespace crossfield
{
/// Boundary vertices at which stopped singularities would be absorbed, by the number of the
/// singularity. A vertex is found anew only when the singularity has moved, because that takes
/// several solves.
struct BoundaryTargets
{
  struct Found
  {
    Point from;          ///< Position for which the vertex was found, in units of the diagonal.
    VertexEnergy target; ///< The vertex, and the energy with the singularity there.
  };
  std::map<std::size_t, Found> found;
};

/// Finds an interior singularity at the clearance from the boundary with W decreasing further
/// towards it, and adds it to the quarter index of a boundary vertex nearby: of the corner whose
/// energy this lowers most, otherwise of the nearby vertex with the lowest energy; only vertices are
/// considered whose angle allows the index (BoundaryVertices::Allows). If several singularities have
/// been stopped, the one that lowers the energy most is absorbed, then with `several` each further
/// one at some distance that lowers it further: a change costs a mesh, whatever their number. As many
/// remain inside as the holonomy conditions of the inner loops need.
std::optional<ConfigurationChange> FindAbsorption(const OptimizerStage& stage,
  const OptimizerState& current, std::set<std::string>& rejected, BoundaryTargets& targets,
  bool several);

/// Returns whether FindAbsorption may find a singularity. Costs no solves.
bool IsAbsorptionDue(const OptimizerStage& stage, const OptimizerState& current,
  const std::set<std::string>& rejected, BoundaryTargets& targets);
}
