#pragma once

#include "FactoredDomain.h"
#include "QuadMesher.h"

#include "SeamlessMapSolve.h"
#include "PoincareHopf.h"
#include "RenormalizedEnergy.h"

#include <optional>

namespace crossfield
{
struct LayoutOptions
{
  SeamlessMapOptions map;
  /// Quads to lay, if any are wanted.
  std::optional<QuadOptions> quads;
};

/// What a configuration makes of a domain, as a person who moves its singularities wants to see it: lines, faces, quality.
struct LayoutDesign
{
  Configuration singularities;
  SeamlessMap map;
  TraceGraph lines;
  TMesh mesh;
  std::optional<QuadResult> quads;
  PoincareHopfCount count;
  RenormalizedEnergyValue energy;
  double shortestArc = 0.0; ///< In the map, whose area is that of the domain.
  double seconds = 0.0;
};

/// The layout of one configuration on a domain that is factored (docs/method.md §15.2). W costs two back-substitutions on its
/// factor; the map is solved for on a mesh with vertices at the singularities, which the domain's becomes by local changes.
///
/// Throws Error as SolveSeamlessMap, MakeTMesh and MakeQuads do, of kind Inconsistent where the quarter indices violate Poincaré-Hopf.
LayoutDesign DesignLayout(const FactoredDomain& domain, const Configuration& singularities,
  const LayoutOptions& options = {}, const Progress& progress = {});

/// The edge length with which a layout follows a hand: `meshSize` (as in DrillOptions), or a larger one where that would make
/// too many triangles for it. Lines are off by O(h²), and exact when the hand lets go.
double LiveMeshSize(const PlanarDomain& domain, double meshSize);
}
