#pragma once

#include "PlanarDomain.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// Polygons that cover a part of the plane once, each of a material. Polygons that share an edge share
/// both of its points.
struct MaterialCells
{
  std::vector<Point> points;
  std::vector<std::vector<int>> cells;
  std::vector<int> materials; ///< Per cell, an index in `names`.
  std::vector<std::string> names;
};

/// A connected domain of one material.
struct Region
{
  PlanarDomain domain;
  int material = 0; ///< Index in RegionSet::materials.
};

/// A line between two regions from one node to the next, or a closed one with one node, its only corner, or
/// none.
struct InterfacePiece
{
  std::string side; ///< Name of its side: its materials, `steel+copper`, or a given one.
  std::string name; ///< The same, with a number if it has several pieces: `steel+copper.2`.
  /// The regions on its left and on its right; that on the left has the lower number.
  std::array<int, 2> regions{};
  std::vector<Point> line; ///< Its points; the first one of a closed line is not repeated.
  bool isClosed = false;
};

/// A point where pieces of interfaces end: at least three regions or the outer boundary meet there,
/// or the interface has a corner.
struct RegionNode
{
  Point place = Point::Zero();
  bool isOnBoundary = false;
};

/// Regions that cover a part of the plane. Loops on both sides of a piece have its points, equal to the
/// last bit.
struct RegionSet
{
  std::vector<std::string> materials;
  std::vector<Region> regions; ///< By material, and from left to right.
  std::vector<InterfacePiece> interfaces;
  std::vector<RegionNode> nodes;
  std::vector<PlanarDomain> outlines; ///< The connected parts of what the regions cover.
};
}
