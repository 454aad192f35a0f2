#pragma once

#include "CleanBlocks.h"
#include "ResolvedRequest.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Quads of a request, with blocks merged and sizes chosen, but without boundary layers.
struct MergedQuads
{
  MeshedLayout mesh;
  SeamlessMapOptions map; ///< Options of its map.
  QuadOptions options;    ///< Options of its quads.
  BlockCounts blocks;
  double moved = 0.0;        ///< Maximum displacement of a singularity for fewer blocks.
  double cleanSeconds = 0.0; ///< 0 unless blocks are merged.
  std::vector<std::string> events;
};

/// Makes the quads of a layout whose map has the given options. Merges blocks and chooses sizes as the
/// request says. Throws Error as MakeQuads does.
MergedQuads MakeMergedQuads(const PlanarDomain& domain, const ResolvedRequest& request,
  Layout layout, const SeamlessMapOptions& map, const Progress& progress);
}
