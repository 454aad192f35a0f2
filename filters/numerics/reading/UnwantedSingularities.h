#pragma once

#include "FieldSingularities.h"

namespace crossfield
{
/// Where singularities of a field are wanted, beside the holes and imprinted circles of its mesh.
struct WantedSingularities
{
  Configuration points;
  /// Vertices of aligned loops whose quarter index was chosen; what the field does next to them is
  /// theirs.
  std::vector<int> chosenVertices;
  /// What imprinted circles ask for is wanted.
  bool inCircles = true;
  /// So many quarters of whatever sign are wanted, no matter where.
  int anywhere = 0;
};

/// Number of quarter indices, counted by |k|, that nobody asked for: the one rule by which solvers and
/// checks tell them (docs/method.md §8.4).
///
/// The singularities are those of FieldSingularities.h off corners and chosen vertices, which may take
/// what they like. In an imprinted circle, or within an edge of it, they count as far as they exceed what
/// it asks for. Within two edges of a point the mesh cannot tell several from one: their sum counts.
/// `indices` are those of the field.
int CountUnwanted(
  const CrossField& field, const FieldIndices& indices, const WantedSingularities& wanted);
}
