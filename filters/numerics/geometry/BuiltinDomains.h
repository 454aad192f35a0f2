#pragma once

#include "Plane.h"

#include <string>

namespace crossfield
{
/// The shape and size of a built-in domain; each shape reads the lengths named beside it.
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
  /// Length of the segments that stand for curves; 0: 1/40 of the bounding box's diagonal.
  double edgeLength = 0.0;
};

/// The names that MakeBuiltinDomain knows.
const std::vector<std::string>& BuiltinDomainNames();

/// Boundary loops of a built-in domain, counter-clockwise, the outer one first. Disk, ring,
/// ellipse, hexagonal, star and the angular domains but angular-balanced, whose left side is on the
/// y axis, are centred at the origin; the other shapes have their lower left corner there.
/// Throws Error for an unknown name or a length that is not positive.
std::vector<Loop> MakeBuiltinDomain(const BuiltinDomain& domain);
}
