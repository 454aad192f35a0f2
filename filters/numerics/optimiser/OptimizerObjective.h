#pragma once

#include "ClearanceBarrier.h"
#include "OptimizerSymmetry.h"
#include "PositionEnergy.h"
#include "SegmentSearch.h"
#include "SizeUniformity.h"
#include "SolveBudget.h"

namespace crossfield
{
/// W or W + μ J, the holonomy defects, the barrier and their derivatives at given positions.
/// Lengths are in units of the domain's diagonal.
struct OptimizerState
{
  Eigen::VectorXd positions; ///< Two coordinates per singularity.
  double energy = 0.0;       ///< Single-valued W + μ J.
  double fullEnergy = 0.0;   ///< W with the harmonic field of the defects.
  double sizeSpread = 0.0;   ///< √(2J), 0 if only W is minimised.
  Eigen::VectorXd gradient;  ///< Gradient of the energy.
  ClearanceBarrier::Value barrier;
  Eigen::VectorXd defects;
  Eigen::MatrixXd defectGradient; ///< One row per defect.

  /// Returns the function that is minimised: energy and barrier.
  double Objective() const { return this->energy + this->barrier.energy; }
  /// Returns the position of singularity i.
  Point PositionOf(std::size_t i) const
  {
    return this->positions.segment<2>(2 * static_cast<Eigen::Index>(i));
  }
  Eigen::VectorXd ObjectiveGradient() const { return this->gradient + this->barrier.gradient; }
};

/// Function that is minimised, apart from the barrier: W, or W + μ J with μ = 10,000. In the
/// latter, W has a weight of 1e-4 relative to J, and the κ of the barrier one of 1e-5
/// (docs/method.md §5.7).
enum class OptimizerGoal
{
  Energy,
  UniformSizes
};

struct ObjectiveOptions
{
  double clearance = 0.0; ///< A length, positive.
  ClearanceFactors clearanceFactors;
  /// Keeps the symmetries of the start (OptimizerSymmetry.h).
  bool keepSymmetry = true;
  OptimizerGoal goal = OptimizerGoal::Energy;
  /// Target sizes for UniformSizes. Symmetries of the domain that the target sizes do not have are
  /// not kept.
  TargetSizes sizes;
  /// Counts the solves; shared by all stages of a run.
  std::shared_ptr<SolveBudget> budget = std::make_shared<SolveBudget>();
};

/// Objective of the optimiser on one mesh, as a function of the positions of interior
/// singularities.
class OptimizerObjective
{
public:
  /// Constructs the objective. `domain` has the original polygons, coarser than those of the mesh.
  OptimizerObjective(std::shared_ptr<const PointPotential> potential, const PlanarDomain& domain,
    const Configuration& configuration, const ObjectiveOptions& options);

  Eigen::VectorXd Start() const;
  Configuration At(const Eigen::VectorXd& positions) const;
  /// Evaluates at the projection of the positions to symmetric ones, so that no step breaks the
  /// symmetries.
  OptimizerState Evaluate(const Eigen::VectorXd& unprojected) const;
  /// Returns the second derivatives of the energy plus those of the defects times multipliers, at
  /// the positions of a state. In directions that break the symmetry, in which no step goes, it is
  /// positive.
  Eigen::MatrixXd Hessian(const OptimizerState& current, const Eigen::VectorXd& multipliers) const;
  ClearanceBarrier::Value EvaluateBarrier(const Eigen::VectorXd& positions) const;
  /// Projects directions onto those that keep the symmetries.
  Eigen::VectorXd ProjectDirections(const Eigen::VectorXd& directions) const
  {
    return this->Symmetry.positions.ProjectDirections(directions);
  }
  OptimizerObjective WithoutSymmetry() const;
  bool KeepsSymmetry() const { return !this->Symmetry.IsTrivial(); }
  /// Returns the number of symmetries that are kept, with the identity.
  std::size_t CountSymmetries() const { return this->Symmetry.positions.elements.size(); }

  /// Returns the distance of singularity i from the boundary, negative outside the domain, in units
  /// of the diagonal.
  double BoundaryDistance(const Eigen::VectorXd& positions, std::size_t i) const;
  /// Returns the clearance of each singularity, for both of its coordinates: its distance from the
  /// boundary or half of that to the next singularity, in units of the diagonal.
  Eigen::VectorXd Clearances(const Eigen::VectorXd& positions) const;
  /// Returns the largest fraction 1, 1/2, 1/4, … of a step for which every singularity
  /// - keeps at least half of its distance from the boundary, where W may tend to infinity,
  /// - does not leave the domain on its path,
  /// - moves by at most half of the distance to any other singularity, and
  /// - moves by at most half of its distance from the boundary or 1/20 of the diagonal, whichever
  ///   is larger.
  double LargestFraction(const Eigen::VectorXd& positions, const Eigen::VectorXd& step) const;
  /// Returns whether the boundary edge nearest to some singularity is longer than the singularity's
  /// distance from the boundary: the mesh then does not resolve its mirror image (docs/method.md
  /// §5.5).
  bool NeedsFinerMesh(const Eigen::VectorXd& positions) const;

  /// Returns the number of interior singularities.
  std::size_t Count() const { return this->Started.size(); }
  /// Returns the length of the diagonal, the unit of the coordinates.
  double LengthUnit() const { return this->Length; }
  /// Returns the clearance in units of the diagonal.
  double Clearance() const { return this->Barrier.GetDistance() / this->Length; }
  const PointPotential& Potential() const { return *this->Points; }
  const std::shared_ptr<const PositionEnergy>& Energy() const { return this->Positions; }
  SolveBudget& Budget() const { return *this->Solves; }
  /// Returns what an evaluation costs.
  std::size_t EvaluationCost() const;
  /// Returns what Hessian costs.
  std::size_t HessianCost() const;
  /// Returns J if it is minimised, null otherwise.
  const std::shared_ptr<const SizeUniformity>& Uniformity() const { return this->Sizes; }
  /// Returns the test whether a symmetry of the domain preserves the objective.
  IsometryTest SymmetryTest() const;

private:
  Eigen::VectorXd PositionsOf(const Configuration& configuration) const;

  std::shared_ptr<const PointPotential> Points;
  std::shared_ptr<const PositionEnergy> Positions;
  PlanarDomain Domain;
  SegmentSearch Sides; ///< Sides of the domain.
  SegmentSearch Edges; ///< Edges of the mesh on the boundary.
  Configuration Started;
  double Length;
  std::shared_ptr<SolveBudget> Solves;
  ClearanceBarrier Barrier;
  std::shared_ptr<const SizeUniformity> Sizes; ///< Null if only W is minimised.
  OptimizerSymmetry Symmetry;
};
}
