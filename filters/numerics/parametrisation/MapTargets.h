#pragma once

#include "ConeMetric.h"
#include "SeamlessPoisson.h"

namespace crossfield
{
/// What a seamless map is solved from: crosses on the triangles of a mesh as integers, and the
/// gradients that the map should have, in the charts of the crosses.
struct MapTargets
{
  SharedTopology topology;
  std::vector<std::array<int, 3>> jumps; ///< As in TriangleFrames.
  SeamlessPoisson poisson;
};

/// Returns the layout of a metric whose angle sums and alignments are as prescribed, as targets: they
/// are isometric to it, so the seamless map with them is their layout, on the triangulation of the
/// metric (docs/method.md §12.7).
MapTargets LayOut(const ConeMetric& metric);
}
