#pragma once

#include "MeshTopology.h"

namespace crossfield
{
/// Edges along which a domain is cut so that it becomes simply connected and has every singularity on
/// its boundary (docs/method.md §12.2): shortest ways along edges from each singularity to the boundary,
/// and between boundary loops.
struct CutGraph
{
  /// A way along cut edges through vertices without anything special.
  struct Chain
  {
    std::vector<int> vertices; ///< Ends included.
    std::vector<int> edges;    ///< Edge j joins vertices j and j + 1.
  };

  std::vector<bool> isCut; ///< Of every edge.
  std::vector<Chain> chains;

  /// Per triangle corner its vertex in the mesh that is cut open,
  std::vector<std::array<int, 3>> corners;
  /// and per vertex of that mesh where it was.
  std::vector<int> original;
};

/// `singular`: vertices inside the domain.
CutGraph CutOpen(const MeshTopology& topology, const std::vector<int>& singular);
}
