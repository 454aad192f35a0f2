#pragma once

#include "ExportMesh.h"

#include <vector>

namespace crossfield
{
/// Numbers of the nodes that a file has; points that no cell of the file uses are left out.
struct MeshNumbering
{
  std::vector<int> number; ///< Per point, its number from `first`, or −1.
  std::vector<int> point;  ///< Per node of the file, its point, in the order of points.
};

/// Numbers the nodes at `positions` of the lattices of all cells, from `first`.
MeshNumbering NumberNodes(const ExportMesh& mesh, const std::vector<int>& positions, int first);
}
