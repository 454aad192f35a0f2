#pragma once

#include "Plane.h"

#include <functional>

namespace crossfield
{
/// Relative target size of quads as a function of position: positive, and only its proportions
/// matter.
using SizeFunction = std::function<double(const Point&)>;

/// How the target size of quads varies over a domain.
enum class Sizing
{
  Conformal, ///< Sizes of the map, e^H.
  Uniform,   ///< Equal sizes everywhere.
  Field      ///< Sizes in proportion to a size field.
};

/// Relative target sizes of quads over a domain.
struct TargetSizes
{
  Sizing sizing = Sizing::Conformal;
  SizeFunction field; ///< Size field; used with Sizing::Field only.

  /// Returns the relative target size at a point: that of the size field, 1 with the other sizings.
  /// Throws Error where the field is not a positive number.
  double At(const Point& place) const;
};
}
