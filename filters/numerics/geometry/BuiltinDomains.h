#pragma once

#include "Plane.h"

#include <string>

namespace crossfield
{
/// Shape and dimensions of a built-in domain. Each shape uses the lengths listed beside it.
struct BuiltinDomain
{
  /// disk (radius), ring (radius, innerRadius), ellipse (width, height), quarter-disk (radius),
  /// square (width), rectangle (width, height), l-shape (width, the removed quarter is half of it),
  /// hexagonal (radius), star (radius, innerRadius), and those of AngularDomains.h (width):
  /// angular-balanced, angular-negative, angular-positive, angular-hole.
  std::string name = "disk";
  double radius = 1.0;
  double innerRadius = 0.4;
  double width = 1.0;
  double height = 0.5;
  /// Length of the segments that approximate curves; 0 means 1/40 of the bounding box's diagonal.
  double edgeLength = 0.0;
};

/// Returns the names of the shapes that MakeBuiltinDomain accepts.
const std::vector<std::string>& BuiltinDomainNames();

/// Returns the boundary loops of a built-in domain, counter-clockwise, the outer one first.
///
/// Disk, ring, ellipse, hexagonal, star and the angular domains are centred at the origin, except
/// angular-balanced, whose left side is on the y axis. The other shapes have their lower left
/// corner at the origin. Throws Error for an unknown name or a length that is not positive.
std::vector<Loop> MakeBuiltinDomain(const BuiltinDomain& domain);
}
