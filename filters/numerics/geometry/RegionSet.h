#pragma once

#include "PlanarDomain.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// An edge of cells that is part of a line along which quads are aligned.
struct LineEdge
{
  std::array<int, 2> points{}; ///< In the direction of the line.
  int name = 0;                ///< Index in MaterialCells::lineNames.
};

/// Polygons that cover a part of the plane once, each of a material. Polygons that share an edge share
/// both of its points.
struct MaterialCells
{
  std::vector<Point> points;
  std::vector<std::vector<int>> cells;
  std::vector<int> materials; ///< Per cell, an index in `names`.
  std::vector<std::string> names;
  std::vector<LineEdge> lines;
  std::vector<std::string> lineNames;
};

/// A connected domain of one material.
struct Region
{
  /// A line with the region on both sides is a slit, about SlitWidth wide: its points are moved apart.
  PlanarDomain domain;
  int material = 0; ///< Index in RegionSet::materials.
  /// Per loop, of the segment after each point: twice the piece that it is on, and one more on its right; −1 on
  /// the outer boundary.
  std::vector<std::vector<int>> pieces;
};

/// Width of slits relative to the diagonal of a region. It is small beside a quad, so the mesh hardly changes
/// when slits are closed, and large enough for triangles of this size along lines: some thousands.
constexpr double SlitWidth = 2e-4;

/// A line between two regions, or inside of one, from one node to the next, or a closed one with one node,
/// its only corner, or none.
struct InterfacePiece
{
  std::string side; ///< Name of its side: its materials, `steel+copper`, or a given one.
  std::string name; ///< The same, with a number if it has several pieces: `steel+copper.2`.
  /// The regions on its left and on its right; that on the left has the lower number.
  std::array<int, 2> regions{};
  std::vector<Point> line; ///< Its points; the first one of a closed line is not repeated.
  bool isClosed = false;
  bool isOpen = false; ///< Its two sides have nodes of their own, as those of a crack.

  /// Returns whether one region is on both sides.
  bool IsSlit() const { return this->regions[0] == this->regions[1]; }
  /// Returns its name as a side of one of `regions`, by the index there.
  std::string NameIn(std::size_t index) const
  {
    return this->IsSlit() ? this->name + (index == 0 ? ".left" : ".right") : this->name;
  }
};

/// A point of a region's boundary.
struct RegionPoint
{
  std::size_t region = 0;
  std::size_t loop = 0;
  std::size_t point = 0;
};

/// A point where pieces of interfaces end: at least three regions or the outer boundary meet there, a line
/// ends, or the interface has a corner.
struct RegionNode
{
  Point place = Point::Zero();
  bool isOnBoundary = false;
  std::vector<RegionPoint> corners; ///< Of the regions that meet there.
};

/// Regions that cover a part of the plane. Loops on both sides of a piece have its points, equal to the
/// last bit but for slits.
struct RegionSet
{
  std::vector<std::string> materials;
  std::vector<Region> regions; ///< By material, and from left to right.
  std::vector<InterfacePiece> interfaces;
  std::vector<RegionNode> nodes;
  std::vector<PlanarDomain> outlines; ///< The connected parts of what the regions cover.
};
}
