#pragma once

#include "FactoredDomain.h"
#include "NodePositions.h"
#include "PatchColours.h"
#include "QuadMesher.h"
#include "SurfaceCones.h"

#include "RenormalizedEnergy.h"

#include <optional>
#include <string>
#include <vector>

namespace crossfield
{
struct LayoutOptions
{
  SeamlessMapOptions map;
  /// Options of the quads; none are made if empty.
  std::optional<QuadOptions> quads;
  /// Moves singularities so that separatrices that nearly meet do meet, if the quads stay as good
  /// (CleanBlocks); needs smooth quads.
  bool clean = false;
  std::vector<PatchColour> earlier; ///< Colours of an earlier layout, which patches keep.
};

/// Layout of a domain for a configuration, as shown while singularities are moved: separatrices,
/// patches, quads and quality.
struct LayoutDesign
{
  LayoutSet layouts; ///< The layout of the domain, which has one region.
  std::optional<QuadResult> quads;
  /// Where the nodes of the singularities are, and how far from the given positions. Without quads
  /// these are the given positions.
  NodePositions nodes;
  std::vector<SurfaceSingularity> onSurface; ///< Where the nodes are on a surface in space.
  std::vector<PatchColour> colours;          ///< Colours of the patches.
  std::string reason;             ///< Why crosses with these singularities exist, in one sentence.
  RenormalizedEnergyValue energy; ///< W; not a number on a surface in space.
  /// Minimum length of an arc, in the map, whose area is that of the domain.
  double shortestArc = 0.0;
  double seconds = 0.0; ///< Computing time.
};

/// Returns the minimum length of an arc.
double ShortestArc(const TMesh& mesh);

/// Computes the layout of a configuration on a factored domain (docs/method.md §15.2). W costs two
/// back-substitutions with its factor. The map is solved on a mesh with vertices at the
/// singularities, obtained from that of the domain by local changes.
///
/// Throws Error as SolveSeamlessMap, MakeTMesh and MakeQuads do, of kind Inconsistent if the
/// quarter indices violate Poincaré-Hopf.
LayoutDesign DesignLayout(const FactoredDomain& domain, const Configuration& singularities,
  const LayoutOptions& options = {}, const Progress& progress = {});

/// Returns the edge length for layouts while a handle is dragged: `meshSize` (as in DrillOptions),
/// or a larger one if the mesh would have too many triangles. The error of separatrices is O(h²);
/// the layout is computed with `meshSize` when the handle is released.
double LiveMeshSize(const PlanarDomain& domain, double meshSize);
}
