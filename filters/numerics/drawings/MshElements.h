#pragma once

#include <cstddef>
#include <vector>

namespace crossfield
{
/// Shape of an element type of Gmsh.
struct MshElementType
{
  int dimension = -1; ///< −1 for an unknown type.
  int nodes = 0;
  int corners = 0;
  int order = 1;
};

/// Returns the shape of an element type.
MshElementType MshTypeOf(int type);

/// Returns the nodes along each edge of an element: of a line itself, and of the sides of a
/// triangle or a quadrilateral; both corners and the nodes between them, in order.
std::vector<std::vector<std::size_t>> MshEdges(
  const MshElementType& type, const std::vector<std::size_t>& nodes);
}
