#pragma once

#include "EdgeCounts.h"
#include "QuadBlocks.h"
#include "QuadQuality.h"
#include "QuadSmoothing.h"
#include "TMesh.h"

namespace crossfield
{
/// An all-quad mesh whose irregular points are exactly the cones of a map, with reports of the
/// stages.
struct QuadResult
{
  QuadMesh mesh;
  /// Per quad, a number that is 0 outside of layers (LayeredMesh::regions); empty without layers.
  std::vector<int> regions;
  std::vector<int> face;       ///< Of a surface: per quad, its face, in the order of the layouts.
  std::vector<double> targets; ///< Of a surface with target sizes: that of each quad.
  TMesh tMesh;       ///< T-mesh of the layout, with nodes where sides and graded parts of them end.
  double size = 0.0; ///< Edge length of quads in the map.
  EdgeCounts counts;
  SmoothingReport smoothing;
  QuadQuality quality;
  QuadBlocks blocks;
  int separateBlocks = 0;     ///< Number of blocks without QuadOptions::coarse.
  double layoutSeconds = 0.0; ///< Time to place the quads in the map.
  double smoothSeconds = 0.0;
};
}
