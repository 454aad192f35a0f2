#pragma once

#include "PairedSides.h"
#include "PotentialSolver.h"
#include "Progress.h"
#include "SeamlessMapSolve.h"
#include "TMesh.h"
#include "TraceGraph.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace crossfield
{
/// Singularities of one region with their seamless map, its separatrices and its T-mesh.
struct Layout
{
  Configuration singularities;
  SeamlessMap map;
  TraceGraph separatrices;
  TMesh tMesh;
  /// The factor that the map was solved with, for its derivatives; null if it was not retained.
  std::shared_ptr<const PotentialSolver> potential = nullptr;
  double mapSeconds = 0.0;   ///< Time to solve for the map.
  double traceSeconds = 0.0; ///< Time to trace the separatrices.
};

/// What the lines between the faces of a surface and its boundary are called, and where these meet.
struct FaceSides
{
  std::vector<std::array<int, 2>> twins; ///< Vertices at the same place on both sides of lines.
  std::vector<std::string> ofPairs;
  std::vector<std::string> ofBoundary; ///< Per entry of mesh.boundary; empty without a given name.
};

/// The layouts of a domain, one per region, with the pairs of sides whose nodes match.
struct LayoutSet
{
  std::vector<Layout> regions;
  std::vector<PairedSides> pairs;
  FaceSides sides; ///< Of a surface that consists of faces.

  LayoutSet() = default;
  /// Not explicit: a layout alone is such a set.
  LayoutSet(Layout region, std::vector<PairedSides> matching = {});

  /// Returns the only layout. Throws Error if there are several regions: steps that call this work on
  /// one.
  const Layout& Single() const;
};

/// Solves for the map of singularities on a mesh with vertices at them, traces the separatrices and
/// builds the T-mesh. `retainsFactor` keeps the factor of the potential, which saves CloseLayout one
/// factorisation; otherwise it is freed before that of the map is made. Throws Error as
/// SolveSeamlessMap, TraceSeparatrices and MakeTMesh do.
Layout LayOut(const SharedPlanarTopology& topology, const Configuration& singularities,
  const SeamlessMapOptions& options, bool retainsFactor, const Progress& progress = {});

/// Returns the maximum distance between corresponding singularities.
double LargestMove(const Configuration& from, const Configuration& to);
}
