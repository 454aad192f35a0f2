#pragma once

#include "BoundaryCorners.h"
#include "CornerClassification.h"

#include <cstddef>

namespace crossfield
{
/// Known choices for corners, before any field is solved with other indices.
struct CornerSetOptions
{
  double cornerAngle = DefaultCornerAngle;
  /// Given indices of vertices; corners among them are decided.
  std::vector<CornerChoice> given;
  /// Indices of a field that differ from the smallest rotation.
  std::vector<CornerChoice> fieldCorners;
  /// Sets that are not to be returned again, nor any of their images under symmetries of the
  /// domain.
  std::vector<std::vector<CornerChoice>> known;
  /// Maximum number of sets to return.
  std::size_t count = 6;
};

/// Returns the choice for a vertex, null if there is none.
const CornerChoice* FindChoice(
  const std::vector<CornerChoice>& choices, const Point& vertex, const PlanarDomain& domain);

/// Returns the options of the corner classifier in which given corners are decided.
ClassificationOptions ClassificationBeside(
  const std::vector<CornerChoice>& given, const PlanarDomain& domain, double cornerAngle);

/// Returns sets of quarter indices for all undecided corners (docs/method.md §5.6). The candidates
/// of a corner are the smallest rotation, the choices of the classifier (CornerClassification.h)
/// and of a field, and, if it is tied, the neighbouring index of lower energy. A combination costs
///   Σ e(α, k) + c |4χ − Σ k|,   c = π/16,
/// where the index of a field costs no more than the smallest rotation. The combinations are
/// returned whose cost exceeds the minimum by at most one interior quarter, the cheapest first, and
/// only one of those that symmetries of the domain map to each other. Each set consists of `given`
/// and the corners whose index is not the smallest rotation; the set without such corners is not
/// returned.
std::vector<std::vector<CornerChoice>> FindCornerSets(
  const PlanarDomain& domain, const CornerSetOptions& options);
}
