#pragma once

#include "TMesh.h"

#include <cstddef>

namespace crossfield
{
/// What the numbers of a T-mesh have to be increased by when it is appended to others.
struct TMeshOffsets
{
  std::size_t cones = 0;
  std::size_t loops = 0;
  std::size_t triangles = 0;
  std::size_t positions = 0; ///< Entries of mesh.boundary.
};

/// Appends a T-mesh of another domain: its nodes, half-edges, arcs and patches follow those of `to`.
void AppendTMesh(const TMesh& from, const TMeshOffsets& offsets, TMesh& to);
}
