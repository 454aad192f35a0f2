#pragma once

namespace crossfield
{
/// Part of the domain to which a marked edge of a drilled mesh belongs; the values are those of the
/// array `BoundaryKind`.
enum class BoundaryKind
{
  Outer = 1,
  Inner = 2,
  Hole = 3,
  ImprintedCircle = 4,
  Interface = 5, ///< Of quads: between two regions.
  Feature = 7    ///< Of quads: a sharp edge of a surface.
};
}
