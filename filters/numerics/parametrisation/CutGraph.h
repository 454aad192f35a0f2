#pragma once

#include "MeshTopology.h"

namespace crossfield
{
/// Edges along which a domain is cut so that it becomes simply connected and has every singularity
/// on its boundary (docs/method.md §12.2): shortest edge paths from each singularity to the
/// boundary, or on a closed surface to the first one, between boundary loops, and around handles.
struct CutGraph
{
  /// A maximal path of cut edges that passes only through vertices with two cut edges, which are
  /// not singular and not on the boundary.
  struct Chain
  {
    std::vector<int> vertices; ///< Vertices along the path, ends included.
    std::vector<int> edges;    ///< Edge j joins vertices j and j + 1.
  };

  std::vector<bool> isCut; ///< Per edge.
  std::vector<Chain> chains;

  std::vector<std::array<int, 3>> corners; ///< Vertex of the cut mesh at every triangle corner.
  std::vector<int> original;               ///< Vertex of the mesh for every vertex of the cut mesh.
};

/// Cuts the mesh open; `singular` are vertices inside the domain.
CutGraph CutOpen(const MeshTopology& topology, const std::vector<int>& singular);
}
