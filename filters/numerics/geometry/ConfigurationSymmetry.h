#pragma once

#include "BoundarySymmetry.h"
#include "Singularity.h"

#include <functional>

namespace crossfield
{
/// Symmetries of a domain under which a configuration is about the same.
struct ConfigurationSymmetry
{
  std::vector<Isometry> elements; ///< A group, the identity first.
  /// Of every element and row the row that it takes its place to.
  std::vector<std::vector<std::size_t>> images;

  bool IsTrivial() const { return this->elements.size() < 2; }

  /// Projects places to the symmetric ones: every one becomes the mean of what the elements bring to it.
  /// The result is symmetric to rounding.
  void Project(Configuration& configuration) const;
  /// The derivative of that: projects directions, two coordinates for each row. It is an orthogonal
  /// projection, so it takes the gradient of a function of places to that of the function of projected ones.
  Eigen::VectorXd ProjectDirections(const Eigen::VectorXd& directions) const;
};

/// Whether something else than the configuration is the same under a symmetry of the domain.
using IsometryTest = std::function<bool(const Isometry&)>;

/// The largest subgroup under which places are moved by at most a distance when they are projected.
/// Circles have more symmetries than any four singularities: so subgroups are tried, the largest first,
/// and of these with rotations by 2π / d only those where d is at most the number of singularities.
/// All elements have to pass the test, if there is one.
ConfigurationSymmetry MatchSymmetry(const Configuration& configuration, const SymmetryGroup& group,
  double distance, const IsometryTest& keeps = {});
}
