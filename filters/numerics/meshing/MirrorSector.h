#pragma once

#include "BoundarySymmetry.h"

#include <map>
#include <optional>
#include <utility>

namespace crossfield
{
/// The part of a domain between two neighbouring mirror lines, from whose mesh reflections and
/// rotations make that of the domain (docs/method.md §10.8). Its sides along the mirror lines are
/// sides of the outer loop of `domain`.
struct MirrorSector
{
  SymmetryGroup group; ///< The group or a subgroup.
  double start = 0.0;  ///< Angle of the first mirror line; the second is at π / order more.
  PlanarDomain domain;
  /// Points in the sector that become vertices; those on mirror lines are in the outer loop.
  std::vector<Point> vertices;
  /// The loop of the whole domain that the side beginning at a vertex of `domain` is part of; −1
  /// for a mirror line.
  std::map<std::pair<double, double>, int> loopOfSide;
};

/// Cuts a sector out of a domain that has the symmetries of a group with reflections. Its first
/// mirror line is the first one of the group at an angle of at least `from`, radians; of a group
/// with more than 12, those of a subgroup are used. Of `vertices`, those outside the sector are
/// left out. Points nearer to a mirror line than `reach` are on it. Returns none if the boundary
/// does not cross the mirror lines alternately from outside and from inside, which only rounding
/// can cause.
std::optional<MirrorSector> CutMirrorSector(const PlanarDomain& domain, const SymmetryGroup& group,
  double from, const std::vector<Point>& vertices, double reach);
}
