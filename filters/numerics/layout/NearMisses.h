#pragma once

#include "TraceGraph.h"

namespace crossfield
{
/// A line that passes a cone, or runs into it. The triangles along it, then back along the line that it stops at to the cone, can be
/// laid into one plane, and there the cone has a distance across from the line.
struct NearMiss
{
  int from = 0;        ///< Cone where the line starts,
  int to = 0;          ///< and that it passes; in SeamlessMap::cones.
  bool meets = false;  ///< They meet on one isoline.
  double across = 0.0; ///< The distance, not negative.

  /// A step from a triangle through one of its sides.
  struct Step
  {
    int triangle;
    int side;
  };
  std::vector<Step> steps;
  int firstTriangle = 0;
  int lastTriangle = 0;

  /// The distance across, with its sign, in a map of the same mesh: of a configuration a little off, as long as it
  /// is small beside the way along. Exact: w is linear on triangles.
  double Offset(const SeamlessMap& map) const;
};

/// All with a distance of no more than `tolerance`, in the map, each pair of lines once.
std::vector<NearMiss> FindNearMisses(const TraceGraph& graph, double tolerance);
}
