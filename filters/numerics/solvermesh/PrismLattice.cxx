#include "PrismLattice.h"

#include "Index.h"

#include <array>
#include <cstddef>

namespace crossfield
{
namespace
{
/// Position of a node `along` the axis from the collapsed edge's first corner, `away` from the
/// axis, at a `level` of the lattice.
int PositionOf(int order, int collapsed, const std::array<int, 3>& node)
{
  const auto [along, away, level] = node;
  const int p = order;
  const std::array<std::array<int, 2>, 4> places = { { { along, away }, { p - away, along },
    { p - along, p - away }, { away, p - along } } };
  const std::array<int, 2>& place = places[Index(collapsed)];
  return place[0] + (p + 1) * (place[1] + (p + 1) * level);
}

using Edges = std::vector<std::array<int, 2>>;

// Edges between corners, in the order of their nodes: around each triangle, then between them, and
// Gmsh's.
const Edges EdgesOfPrism = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 },
  { 1, 4 }, { 2, 5 } };
const Edges EdgesOfGmsh = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 4 }, { 2, 5 }, { 3, 4 },
  { 3, 5 }, { 4, 5 } };
// Opposite corners of the quadrilaterals.
const Edges QuadsOfPrism = { { 0, 4 }, { 1, 5 }, { 2, 3 } };
const Edges QuadsOfGmsh = { { 0, 4 }, { 0, 5 }, { 1, 5 } };
}

std::vector<int> PrismPositions(int order, int collapsed, NodeOrder format)
{
  // Corners of a triangle, away from the axis and level: on the axis, where all levels are one,
  // level 0 stands for all.
  std::array<std::array<int, 2>, 3> triangle = { { { 0, 0 }, { order, 0 }, { order, order } } };
  if (format == NodeOrder::Vtk)
  {
    std::swap(triangle[1], triangle[2]);
  }
  std::vector<std::array<int, 3>> nodes;
  for (const int along : { 0, order })
  {
    for (const auto& [away, level] : triangle)
    {
      nodes.push_back({ along, away, level });
    }
  }
  const auto addMiddles = [&](const Edges& edges)
  {
    for (const auto& [first, second] : edges)
    {
      const std::array<int, 3> a = nodes[Index(first)];
      const std::array<int, 3> b = nodes[Index(second)];
      const bool isFromAxis = a[1] == 0 || b[1] == 0; // whose other end has the level
      const int level = isFromAxis ? a[2] + b[2] : (a[2] + b[2]) / 2;
      nodes.push_back({ (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, level });
    }
  };
  if (order == 2)
  {
    addMiddles(format == NodeOrder::Gmsh ? EdgesOfGmsh : EdgesOfPrism);
    if (format != NodeOrder::Abaqus)
    {
      addMiddles(format == NodeOrder::Gmsh ? QuadsOfGmsh : QuadsOfPrism);
    }
  }
  std::vector<int> positions;
  for (const std::array<int, 3>& node : nodes)
  {
    positions.push_back(PositionOf(order, collapsed, node));
  }
  return positions;
}

void FillPrismLattice(int order, int* nodes)
{
  for (int along = 0; along <= order; ++along)
  {
    const auto at = [&](int away, int level) -> int& {
      return nodes[PositionOf(order, 0, { along, away, level })];
    };
    for (int level = 1; level <= order; ++level)
    {
      at(0, level) = at(0, 0);
    }
    if (order == 2)
    {
      at(1, 1) = at(2, 1);
    }
  }
}

void KeepTriangle(int order, std::vector<int>& nodes)
{
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    if (nodes[corner] != nodes[(corner + 1) % 4])
    {
      continue;
    }
    if (order == 2)
    {
      nodes.resize(8); // without the one inside
      nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(4 + corner));
    }
    nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(corner < 3 ? corner + 1 : corner));
    return;
  }
}
}
