#pragma once

#include "LayeredMesh.h"
#include "QuadWalk.h"

#include <optional>
#include <set>

namespace crossfield
{
/// Why a band has no further row.
enum class BandEnd
{
  Limit,     ///< As many rows as were requested.
  Irregular, ///< An irregular node.
  Boundary,  ///< The boundary, or a corner of it.
  Other      ///< A row of another band, or of this one.
};

/// Rows of quads beside a part of the boundary, from its first row inwards. All rows are as long;
/// they are closed, or end on the boundary (docs/method.md §16.1).
struct QuadBand
{
  bool closed = false;
  /// Per row the sides of its quads nearest to the wall, in order along the wall with the quads on
  /// the left.
  std::vector<std::vector<int>> rows;
  std::vector<int> layers; ///< Per column of quads, the prescription at the wall, −1 beyond it.
  double growth = 0.0;     ///< Minimum growth that its layers allow.
  /// Per grid line across the band, the height of its first row; empty: as its layers prescribe.
  std::vector<double> heights;
  std::set<int> quads; ///< All quads of the band.
  BandEnd end = BandEnd::Limit;
  Point place = Point::Zero(); ///< Where the next row fails.

  /// Returns the number of grid lines across the band.
  std::size_t LineCount() const { return this->rows[0].size() + (this->closed ? 0 : 1); }
};

/// Returns the bands of the layered edges of a mesh, each with up to `maximumRows` rows. Bands
/// grow row by row together, so that two of them share what is between them. Points of inner lines
/// are regular.
std::vector<QuadBand> FindBands(const LayeredMesh& layered, const QuadWalk& walk, int maximumRows);

/// Returns the band of one layered edge, with a number of rows that FindBands found. Throws Error
/// if bands that were divided since have taken them.
QuadBand FindBand(const LayeredMesh& layered, const QuadWalk& walk, std::size_t edge, int rows);

/// A band that was divided: an edge of mesh.boundary at its wall, and its number of rows.
struct DividedBand
{
  std::size_t edge = 0;
  int rows = 0;
};

/// Returns a band behind the line that the rows of divided bands follow beyond their sides, as
/// behind the corner of a step: on the other side of this line, where quads are higher than its
/// first row by more than a ratio. Its first row is as high as the one on this side. Returns
/// nothing if there is no such line.
std::optional<QuadBand> FindBandBehind(const LayeredMesh& layered, const QuadWalk& walk,
  const std::vector<DividedBand>& divided, int maximumRows, double ratio);

/// Returns the points of a grid line across the first rows of a band, from the wall inwards.
std::vector<int> PointsAcross(
  const QuadBand& band, const QuadWalk& walk, std::size_t line, int rows);
}
