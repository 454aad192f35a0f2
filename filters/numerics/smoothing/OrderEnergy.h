#pragma once

#include "TangentFrames.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// The energy that keeps points that slide along the boundary in order: the sum of
/// d + 1/d + t³ / (1 − t) over boundary edges, d the length along the boundary over the target,
/// t = max(0, (c − 1/8) / (LongestPartOfLoop − 1/8)), c the part of the loop, so that no edge leads
/// around too much of it. Unknowns are those of QuadEnergy.
class OrderEnergy
{
public:
  OrderEnergy() = default; ///< Zero.
  /// Zero if edges are not in order at the start; without t where an edge is too long there. Edges of
  /// images are left out.
  OrderEnergy(const QuadMesh& mesh, const BoundaryCurves& curves, const std::vector<bool>& isFixed,
    const std::vector<bool>& isImage);

  /// Returns the energy, infinite if edges are not in order, and adds its gradient if requested.
  double Value(const Eigen::VectorXd& unknowns, Eigen::VectorXd* gradient) const;

private:
  /// d = inverse (s_to − s_from + offset), s the lengths along the loop; −1 instead of the unknown
  /// of a fixed point, whose length is part of the offset.
  struct Term
  {
    Eigen::Index from;
    Eigen::Index to;
    double offset;
    double inverse;
    double inverseLoop; ///< 1 / (length of the loop); 0 if the edge is longer.
  };

  std::vector<Term> Terms;
};
}
