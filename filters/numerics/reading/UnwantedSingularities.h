#pragma once

#include "FieldSingularities.h"

namespace crossfield
{
/// Expected singularities of a field, in addition to the holes and imprinted circles of its mesh.
struct WantedSingularities
{
  Configuration points;
  /// Vertices of aligned loops whose quarter index was chosen; singularities next to them belong to
  /// them.
  std::vector<int> chosenVertices;
  /// Whether the indices of imprinted circles are expected.
  bool inCircles = true;
  /// Number of quarters, of either sign, that are expected anywhere.
  int anywhere = 0;
};

/// Returns the number of unwanted quarter indices, counted by |k|. Solvers and checks share this
/// rule (docs/method.md §8.4).
///
/// The singularities are those of FieldSingularities.h, without corners and chosen vertices, whose
/// indices are free. In an imprinted circle, or within an edge of it, they count as far as they
/// exceed the index of the circle. Within two edges of a point the mesh cannot separate several
/// singularities, so their sum counts. `indices` are those of the field.
int CountUnwanted(
  const CrossField& field, const FieldIndices& indices, const WantedSingularities& wanted);
}
