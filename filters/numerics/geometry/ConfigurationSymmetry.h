#pragma once

#include "BoundarySymmetry.h"
#include "Singularity.h"

#include <functional>

namespace crossfield
{
/// Symmetries of a domain that also leave a configuration invariant, within a tolerance.
struct ConfigurationSymmetry
{
  SymmetryGroup group;
  std::vector<Isometry> elements; ///< The elements of the group, the identity first.
  /// For each element and each row of the configuration, the row that it is mapped to.
  std::vector<std::vector<std::size_t>> images;

  bool IsTrivial() const { return this->elements.size() < 2; }

  /// Projects the positions to symmetric ones: each becomes the mean of its preimages under all
  /// elements. The result is symmetric up to rounding.
  void Project(Configuration& configuration) const;
  /// Applies the derivative of Project to directions, two coordinates for each row. It is an
  /// orthogonal projection, so it maps the gradient of a function of positions to the gradient of
  /// that function composed with Project.
  Eigen::VectorXd ProjectDirections(const Eigen::VectorXd& directions) const;
};

/// Predicate for the invariance of further data under a symmetry of the domain.
using IsometryTest = std::function<bool(const Isometry&)>;

/// Returns the largest subgroup whose projection moves no position by more than `distance`.
///
/// A circle has more symmetries than any four singularities on it. Subgroups are therefore tried in
/// decreasing order of size, and among those with rotations by 2π / d only the ones where d does
/// not exceed the number of singularities. If a test is given, all elements must pass it.
ConfigurationSymmetry MatchSymmetry(const Configuration& configuration, const SymmetryGroup& group,
  double distance, const IsometryTest& isInvariant = {});
}
