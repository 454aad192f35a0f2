#pragma once

#include "FieldIndices.h"
#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Singularity of a cross field. `radius` is that of the hole, and 0 for all others.
struct FieldSingularity : Singularity
{
  /// Location relative to the boundary; the codes are those of `BoundaryKind`.
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
  /// Vertex of the mesh on an outer or inner loop, else −1.
  int vertex = -1;
  /// Longest edge at the vertices of its triangles, the accuracy of the position.
  double edge = 0.0;
};

struct FieldSingularityOptions
{
  /// Includes the corners of the boundary, with the quarter index that the field has there, if it
  /// is not 0.
  bool corners = false;
  /// Includes the holes, at their centres, with the degree of the field on them, if it is not 0.
  bool holes = false;
  /// Turning angle in radians above which a vertex of an outer or inner loop is a corner.
  double cornerAngle = DefaultCornerAngle;
  /// Further vertices of aligned loops that are read like corners: those with a chosen quarter
  /// index.
  std::vector<int> chosenVertices;
};

/// Finds the singularities of a field from the indices of triangles and vertices (FieldIndices.h).
/// The field may vanish.
///
/// Wherever u turns by more than half a turn from one midpoint to the next, the index of one
/// singularity is spread over neighbouring triangles and vertices, with both signs if |k| ≥ 2. So
/// singular triangles and vertices are merged when they share a vertex or are joined by an edge.
/// The quarter index is the sum of their indices; a sum of zero is no singularity. Corners take the
/// indices of their triangles (MergeAtVertices) and are merged with nothing else, because they
/// belong to the boundary.
///
/// The position is the zero of the piecewise linear field if |k| = 1 and a zero lies in the merged
/// triangles, otherwise the mean of the centroids and vertices weighted by |index|. Next to the
/// boundary, where the mean may be outside, the position is the nearest of them to the mean. A
/// singularity that consists only of vertices of a loop has moved into the boundary; its `place` is
/// then that loop.
///
/// The result is sorted by place, then by x and y. Throws Error for values that are not finite, and
/// if the indices inside, on the boundary and on holes do not add up to 4χ, as they do for every
/// field that is aligned with the outer and inner loops.
std::vector<FieldSingularity> FindFieldSingularities(
  const CrossField& field, const FieldSingularityOptions& options = {});

/// Finds the singularities from indices that have already been read.
std::vector<FieldSingularity> FindFieldSingularities(
  const CrossField& field, const FieldIndices& indices, const FieldSingularityOptions& options);
}
