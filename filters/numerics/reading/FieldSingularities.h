#pragma once

#include "FieldIndices.h"
#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// A place where a cross field is singular. `radius` is that of the hole, 0 for all others.
struct FieldSingularity : Singularity
{
  /// Where it is; the codes of `BoundaryKind`.
  enum class Place
  {
    Inside = 0,
    OuterLoop = 1,
    InnerLoop = 2,
    Hole = 3
  };
  Place place = Place::Inside;
  /// Loop number on the boundary, row of the configuration for holes, −1 inside.
  int id = -1;
  /// The vertex of the mesh that it is at on an outer or inner loop, else −1.
  int vertex = -1;
  /// Longest edge at the vertices of its triangles: how well its place is known.
  double edge = 0.0;
};

struct FieldSingularityOptions
{
  /// Also the corners of the boundary, with the quarter index that the field takes there, if any.
  bool corners = false;
  /// Also the holes, at their centres, with the degree of the field on them, if any.
  bool holes = false;
  /// A vertex of an outer or inner loop that turns by more is a corner; radians.
  double cornerAngle = DefaultCornerAngle;
  /// Further vertices of aligned loops that are read like corners: those with a chosen quarter index.
  std::vector<int> chosenVertices;
};

/// Reads the singularities of a field, one for each, from the indices of triangles and vertices
/// (FieldIndices.h). The field may vanish.
///
/// Wherever u turns by more than half a turn from one midpoint to the next, the index of one
/// singularity is spread over neighbouring triangles and vertices, and for |k| ≥ 2 with both signs.
/// So singular triangles and vertices are merged when they share a vertex or are joined by an edge;
/// the quarter index is their sum, and what adds up to zero is none. Corners take the indices of
/// their triangles (MergeAtVertices) and are merged with nothing else, they are of the boundary.
///
/// The position is the zero of the piecewise linear field if |k| = 1 and one lies in the merged
/// triangles, else the mean of the centroids and vertices weighted by |index|; next to the boundary, where
/// the mean may be outside, the one of them nearest to it. A singularity of which nothing but vertices of a loop is left has moved into the boundary: the place says so.
///
/// The result is sorted by place, then by x and y. Throws Error for values that are not finite, and
/// if the indices inside, on the boundary and on holes do not add up to 4χ, as they do for every
/// field that is aligned with outer and inner loops.
std::vector<FieldSingularity> FindFieldSingularities(
  const CrossField& field, const FieldSingularityOptions& options = {});

/// The same where the indices are at hand.
std::vector<FieldSingularity> FindFieldSingularities(
  const CrossField& field, const FieldIndices& indices, const FieldSingularityOptions& options);
}
