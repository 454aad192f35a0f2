#pragma once

#include "LoopArc.h"
#include "PlanarDomain.h"

#include <string>
#include <vector>

namespace crossfield
{
/// The point where a piece of a side starts. The piece leads along its loop, with the domain on the
/// left, to the next start on that loop.
struct SideStart
{
  Point place = Point::Zero(); ///< A vertex of the boundary.
  int side = 0;                ///< Index in BoundarySides::names.
  /// Whether the quads have a node exactly here. Not set at corners, which have one if quads are
  /// small enough, and where a whole loop is one piece.
  bool isFixed = false;
  int loop = -1; ///< Its loop, where several lead through the place; −1: the nearest one.
};

/// The sides of a domain: every point of its boundary belongs to one side, which has a name and
/// consists of one or several pieces. Pieces are given by points of the plane instead of numbers of
/// vertices, so they stay valid when the boundary is simplified and meshed.
struct BoundarySides
{
  std::vector<std::string> names; ///< Given names in order of appearance, then generated ones.
  int given = 0;                  ///< Number of given names.
  std::vector<SideStart> starts;  ///< Loop after loop, in order along each loop.

  /// Returns the index of a name, −1 if there is none.
  int Find(const std::string& name) const;
  /// Returns the places that need a node.
  std::vector<Point> FixedPlaces() const;
};

/// Throws Error that lists names of sides unless `name` is one of them. `purpose` continues the
/// sentence, such as " for a layer".
void RequireSide(
  const std::vector<std::string>& names, const std::string& name, const std::string& purpose = {});

/// Names of the segments of a domain: per loop, of the segment after each vertex. Empty: no name.
using SegmentNames = std::vector<std::vector<std::string>>;

/// Collects the sides of a domain from the names of its segments. Those without a name are split at
/// corners, and each piece is a side of its own: `outer0`, `outer1`, ... on the outer loop, `hole0`,
/// `hole1`, ... on inner loops. Without `names` no segment has a name. Names in `taken`, of other
/// parts of a domain, are not generated again.
BoundarySides NameSides(const PlanarDomain& domain, const SegmentNames& names = {},
  const std::vector<std::string>& taken = {});

/// A start of a side on a loop.
struct LoopSide
{
  double at = 0.0; ///< Arc length.
  int side = 0;
  bool isFixed = false;
};

/// The sides along loops. Each start is located at the nearest point of its loop, or of all loops; with
/// the loops of the domain or of its mesh this is a vertex at exactly that place.
class SidesAlong
{
public:
  SidesAlong(const BoundarySides& sides, const std::vector<LoopArc>& loops);

  /// Returns the starts on a loop by increasing arc length.
  const std::vector<LoopSide>& On(std::size_t loop) const { return this->Starts[loop]; }
  /// Returns the side at an arc length; at a start, the side that starts there. −1 if the loop has
  /// no sides.
  int At(std::size_t loop, double at) const;

private:
  std::vector<std::vector<LoopSide>> Starts;
  std::vector<double> Lengths;
};
}
