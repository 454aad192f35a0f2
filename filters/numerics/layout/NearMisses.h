#pragma once

#include "TraceGraph.h"

namespace crossfield
{
/// Separatrix that passes close to a cone, or ends in it. The triangles along it, and then back to
/// the cone along the separatrix at which it stops, are unfolded into one plane, where the cone has
/// an offset from the first separatrix.
struct NearMiss
{
  int from = 0;        ///< Cone where the separatrix starts, a row of SeamlessMap::cones.
  int to = 0;          ///< Cone that it passes.
  bool meets = false;  ///< Whether the separatrices of the two cones coincide.
  double across = 0.0; ///< Transverse distance, not negative.

  /// Step from a triangle through one of its sides.
  struct Step
  {
    int triangle;
    int side;
  };
  std::vector<Step> steps; ///< Path from firstTriangle to lastTriangle.
  int firstTriangle = 0;   ///< Triangle at the cone `from`.
  int lastTriangle = 0;    ///< Triangle at the cone `to`.

  /// Returns the signed transverse offset in a map on the same mesh, of a configuration close to
  /// the original one. Exact, since w is linear on triangles; valid as long as the offset is small
  /// compared to the distance along the separatrix.
  double Offset(const SeamlessMap& map) const;
};

/// Finds all near misses with a distance of at most `tolerance` in the map, each pair of
/// separatrices once.
std::vector<NearMiss> FindNearMisses(const TraceGraph& graph, double tolerance);
}
