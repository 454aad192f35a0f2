#pragma once

// Part of PlanarMesher.cxx: the core of the lattice and the
// triangulation around it.
#include "LatticeCore.h"
#include "MesherTriangulation.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace crossfield::mesher
{
/// Returns all points except those of the coarsest lattice.
inline std::vector<Point> OtherPoints(const Triangulation& start, const GradedLattice& lattice)
{
  std::vector<Point> others = lattice.finer;
  for (auto vertex = start.finite_vertices_begin(); vertex != start.finite_vertices_end(); ++vertex)
  {
    others.push_back(FromCgal(vertex->point()));
  }
  return others;
}

/// Returns the vertices of the border of the core, without duplicates.
inline std::vector<std::size_t> BorderVertices(const LatticeCore& core)
{
  std::vector<std::size_t> corners;
  for (const auto& edge : core.GetBorder())
  {
    corners.push_back(edge[0]);
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Returns the lattice points that are not vertices of triangles of the core.
inline std::vector<Point> PointsOutsideCore(
  const LatticeCore& core, const std::vector<std::size_t>& corners, const GradedLattice& lattice)
{
  std::vector<Point> outside;
  for (int row = 0; row < lattice.coarsest.rows; ++row)
  {
    for (int column = 0; column < lattice.coarsest.columns; ++column)
    {
      if (!core.IsInterior(column, row) &&
        !std::binary_search(corners.begin(), corners.end(), lattice.coarsest.NumberOf(column, row)))
      {
        outside.push_back(lattice.coarsest.At(column, row));
      }
    }
  }
  outside.insert(outside.end(), lattice.finer.begin(), lattice.finer.end());
  return outside;
}

/// Margin of the core in spacings. Refinement improves the triangles between the boundary and the
/// first points of the lattice. At a margin of 1 it did not reach the core in any of 650 domains,
/// 400 of them with tiny holes and gradations up to 100.
constexpr int CoreMargin = 4;

using Ends = std::array<Triangulation::Vertex_handle, 2>;

/// Inserts the border vertices of the core, constrains the border edges and returns them.
inline std::vector<Ends> InsertBorder(
  const LatticeCore& core, const std::vector<std::size_t>& corners, Triangulation& triangulation)
{
  std::vector<std::pair<CgalPoint, VertexInfo>> points;
  for (const std::size_t corner : corners)
  {
    VertexInfo info;
    info.lattice = static_cast<std::int64_t>(corner);
    points.emplace_back(ToCgal(core.GetLattice().At(corner)), info);
  }
  triangulation.insert(points.begin(), points.end());
  std::map<std::int64_t, Triangulation::Vertex_handle> handles;
  for (auto vertex = triangulation.finite_vertices_begin();
       vertex != triangulation.finite_vertices_end(); ++vertex)
  {
    if (vertex->info().lattice != None)
    {
      handles[vertex->info().lattice] = vertex;
    }
  }
  std::vector<Ends> border;
  for (const auto& [from, to] : core.GetBorder())
  {
    border.push_back(
      { handles.at(static_cast<std::int64_t>(from)), handles.at(static_cast<std::int64_t>(to)) });
    triangulation.insert_constraint(border.back()[0], border.back()[1]);
  }
  return border;
}

/// Returns one point in each run of core triangles, so that the mesher leaves the core unrefined.
inline std::vector<CgalPoint> CoreSeeds(const LatticeCore& core)
{
  std::vector<CgalPoint> seeds;
  for (const std::size_t first : core.GetFirsts())
  {
    const auto& [a, b, c] = core.GetTriangles()[first];
    const TriangularLattice& lattice = core.GetLattice();
    seeds.push_back(ToCgal((lattice.At(a) + lattice.At(b) + lattice.At(c)) / 3.0));
  }
  return seeds;
}
}
