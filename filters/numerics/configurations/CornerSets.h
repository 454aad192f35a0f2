#pragma once

#include "BoundaryCorners.h"
#include "CornerClassification.h"

#include <cstddef>

namespace crossfield
{
/// What is known of corners before any field is solved with other indices of theirs.
struct CornerSetOptions
{
  double cornerAngle = DefaultCornerAngle;
  /// Of vertices; corners among them are decided.
  std::vector<CornerChoice> given;
  /// What a field takes otherwise than by the smallest rotation.
  std::vector<CornerChoice> ofField;
  /// Sets that are not wanted again, nor what a symmetry of the domain makes of them.
  std::vector<std::vector<CornerChoice>> known;
  /// How many sets to return, at most.
  std::size_t count = 6;
};

/// What is chosen for a vertex, if anything is; null otherwise.
const CornerChoice* FindChoice(
  const std::vector<CornerChoice>& choices, const Point& vertex, const PlanarDomain& domain);

/// How the classifier is asked where some corners are decided.
ClassificationOptions ClassificationBeside(
  const std::vector<CornerChoice>& given, const PlanarDomain& domain, double cornerAngle);

/// Quarter indices for all undecided corners at once (docs/method.md §5.6): of a corner the smallest rotation, what the classifier
/// (CornerClassification.h) and a field take, and where it is tied its neighbour of less energy. Of their
/// combinations those are returned that cost at most one interior quarter more than the cheapest,
///   Σ e(α, k) + c |4χ − Σ k|,   c = π/16,
/// where what a field takes costs no more than the smallest rotation: the cheapest first, and one of those that a symmetry of
/// the domain maps to each other. Each is `given` and the corners that count otherwise than by the smallest rotation;
/// that none does is left out.
std::vector<std::vector<CornerChoice>> FindCornerSets(
  const PlanarDomain& domain, const CornerSetOptions& options);
}
