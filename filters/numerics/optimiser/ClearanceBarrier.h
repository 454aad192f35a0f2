#pragma once

#include "PlanarDomain.h"
#include "SegmentSearch.h"
#include "Singularity.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Factors of the clearance at the edges of a domain, per loop and edge; empty: 1 everywhere.
using ClearanceFactors = std::vector<std::vector<double>>;

/// Returns the factor of an edge.
inline double FactorAt(const ClearanceFactors& factors, std::size_t loop, std::size_t edge)
{
  return factors.empty() ? 1.0 : factors.at(loop).at(edge);
}

/// Returns the factors of a domain with further vertices on its edges (InsertBoundarySingularities):
/// parts of an edge have its factor.
ClearanceFactors FactorsOfParts(
  const PlanarDomain& domain, const PlanarDomain& refined, const ClearanceFactors& factors);

/// Barrier that keeps singularities at a distance δ from the boundary and from each other
/// (docs/method.md §5.5):
///   b(t) = −κ (t − 1)² ln t,  t = (d − δ)/δ,  for δ < d < 2δ; zero beyond, infinite below.
/// The barrier is summed over the sides of the boundary and over pairs of singularities. The
/// distance to a single side is differentiable wherever b is neither zero nor infinite; the
/// distance to the whole boundary is not, on the bisector of a corner. A side shorter than δ has
/// the weight length/δ, so that a curve of many sides acts like a straight one. At an edge with a
/// factor, the distance is divided by it.
class ClearanceBarrier
{
public:
  struct Value
  {
    double energy = 0.0; ///< Infinite if a distance is not greater than δ.
    Eigen::VectorXd gradient;
    /// Positive part of the second derivatives, Σ b'' ∇d ∇dᵀ.
    Eigen::MatrixXd hessian;
    /// Remaining, negative part of the second derivatives, Σ b' ∇∇d.
    Eigen::MatrixXd negativeHessian;
  };

  /// Sets κ to 1/10 of the product of the two quarter indices, or of the square of the index at the
  /// boundary: gradients of W are about π/δ, so that minima of W at a distance of 1.5 δ move by
  /// 0.04 δ. Singularities of opposite sign attract each other and have no minimum there: κ is the
  /// negative product, which keeps them at 1.22 δ and the iteration well conditioned.
  ClearanceBarrier(const PlanarDomain& domain, const Configuration& configuration, double distance,
    const ClearanceFactors& factors = {});

  /// Evaluates the barrier at positions with two coordinates per singularity, in the length unit of
  /// the domain.
  Value Evaluate(const Eigen::VectorXd& positions) const;
  double GetDistance() const { return this->Distance; }

private:
  struct Side
  {
    Point from;
    Point to;
    double weight;
    double factor;
  };

  std::vector<Side> Sides;
  std::vector<double> Quarters; ///< Quarter index k of each singularity, 1 instead of 0.
  double Distance;
  SegmentSearch Boundary; ///< Of the sides.
  double LargestFactor = 0.0;
};
}
