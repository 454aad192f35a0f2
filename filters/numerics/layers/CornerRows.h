#pragma once

#include "BoundaryCorners.h"

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace crossfield
{
/// What the rows of quads beside a side do at its corner (docs/method.md §16.4).
enum class CornerRows
{
  End,  ///< They end on the next side: one quad, quarter index 1.
  Turn, ///< They follow the boundary: two quads, quarter index 0.
  Leave ///< They follow the grid line that leaves the corner: three quads or more.
};

/// Treatment of one or several corners: that at a position, or those of a side, or those with an
/// interior angle between two bounds.
struct CornerRule
{
  std::optional<Point> position;
  std::string side;
  std::array<double, 2> angles{}; ///< In radians; used without a position and a side.
  CornerRows rows = CornerRows::End;
};

/// Returns the names of the sides that meet at a corner.
using SidesAtCorner = std::function<std::vector<std::string>(const Corner& corner)>;

/// Returns the treatment of a corner of a side with a layer: End up to an interior angle of 135°,
/// Turn up to 315°, above that Leave.
CornerRows DefaultRows(double angle);

/// Returns the quarter index that a treatment gives to a corner. Throws Error if the corner has no
/// angle for it: End needs less than 170°, Turn 100° to 350°, and Leave more than 225°.
int QuarterIndexFor(const Corner& corner, CornerRows rows);

/// Returns the choices for the corners that rules treat. At a corner, a position takes precedence
/// over a side, and a side over an angle. Rules for sides and angles treat only corners with an angle
/// for the treatment. Throws Error if a rule treats no corner, if two of a kind differ at one, and for
/// positions as QuarterIndexFor does.
std::vector<CornerChoice> TreatCorners(
  const PlanarDomain& domain, const std::vector<CornerRule>& rules, const SidesAtCorner& sidesAt);
}
