#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

#include <Eigen/Core>

namespace crossfield
{
/// Keeps singularities at a distance δ from the boundary and from each other (docs/method.md §5.5):
///   b(t) = −κ (t − 1)² ln t, t = (d − δ)/δ, for δ < d < 2δ; nothing beyond, infinite below.
/// It is summed over the sides of the boundary and over pairs. The distance to one side is
/// differentiable wherever b is not zero or infinite, that to the whole boundary is not: in a corner
/// two sides are nearest. Sides shorter than δ count by their length, so that a curve of many sides
/// counts like a straight one.
class ClearanceBarrier
{
public:
  struct Value
  {
    double energy = 0.0; ///< Infinite where a distance is not above δ.
    Eigen::VectorXd gradient;
    /// Σ b'' ∇d ∇dᵀ, the positive part of the second derivatives.
    Eigen::MatrixXd hessian;
    /// Σ b' ∇∇d, the rest of the second derivatives, negative.
    Eigen::MatrixXd bend;
  };

  /// κ is 1/10 of the product of the two quarter indices, or of their square at the boundary: forces of
  /// singularities are about π/δ, so that minima of W at 1.5 δ move by 0.04 δ. Opposite signs attract and
  /// have none there: κ is their product, which holds them at 1.22 δ and the iteration well conditioned.
  ClearanceBarrier(const PlanarDomain& domain, const Configuration& configuration, double distance);

  /// `places`: two coordinates per singularity, lengths in those of the domain.
  Value Evaluate(const Eigen::VectorXd& places) const;
  double GetDistance() const { return this->Distance; }

private:
  struct Side
  {
    Point from;
    Point to;
    double weight;
  };

  std::vector<Side> Sides;
  std::vector<double> Quarters; ///< k of every singularity, 1 instead of 0.
  double Distance;
};
}
