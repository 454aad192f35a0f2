#pragma once

#include "ClearanceBarrier.h"
#include "OptimizerSymmetry.h"
#include "SizeUniformity.h"

namespace crossfield
{
/// W, or W + μ J, the holonomy defects, the barrier and their derivatives at one place; lengths in units of
/// the domain's diagonal.
struct OptimizerPlace
{
  Eigen::VectorXd place;    ///< Two coordinates per singularity.
  double energy = 0.0;      ///< Single-valued W + μ J.
  double fullEnergy = 0.0;  ///< W with the harmonic field of the defects.
  double sizeSpread = 0.0;  ///< √(2J), 0 where it is not asked for.
  Eigen::VectorXd gradient; ///< Of the energy.
  ClearanceBarrier::Value barrier;
  Eigen::VectorXd defects;
  Eigen::MatrixXd defectGradient; ///< One row per defect.

  /// What is minimised.
  double Objective() const { return this->energy + this->barrier.energy; }
  Eigen::VectorXd ObjectiveGradient() const { return this->gradient + this->barrier.gradient; }
};

/// What is minimised besides the barrier: W, or W + μ J with μ = 10,000. Then W is worth 1e-4 of J, and the
/// barrier's κ 1e-5 of it (docs/method.md §5.7).
enum class OptimizerGoal
{
  Energy,
  UniformSizes
};

struct ObjectiveOptions
{
  double clearance = 0.0; ///< A length, positive.
  /// Whether places are as symmetric as those of the start (OptimizerSymmetry.h).
  bool keepSymmetry = true;
  OptimizerGoal goal = OptimizerGoal::Energy;
  /// Target sizes for UniformSizes. Symmetries of the domain that they do not have are not kept.
  TargetSizes sizes;
};

/// What the optimiser minimises on one mesh, as a function of the places of interior singularities.
class OptimizerObjective
{
public:
  /// `domain`: its own polygons, coarser than those of the mesh.
  OptimizerObjective(std::shared_ptr<const PointPotential> potential, const PlanarDomain& domain,
    const Configuration& configuration, const ObjectiveOptions& options);

  Eigen::VectorXd Start() const;
  Configuration At(const Eigen::VectorXd& place) const;
  /// At the projection of a place to those that keep the symmetries, so that no step leaves them.
  OptimizerPlace Evaluate(const Eigen::VectorXd& asked) const;
  ClearanceBarrier::Value EvaluateBarrier(const Eigen::VectorXd& place) const;
  /// By places that keep the symmetries.
  Eigen::VectorXd ProjectDirections(const Eigen::VectorXd& directions) const
  {
    return this->Symmetry.places.ProjectDirections(directions);
  }
  OptimizerObjective WithoutSymmetry() const;
  bool KeepsSymmetry() const { return !this->Symmetry.IsTrivial(); }

  /// Distance of singularity i to the boundary, negative outside the domain, in units of the diagonal.
  double BoundaryDistance(const Eigen::VectorXd& place, std::size_t i) const;
  /// The part of a step, 1, 1/2, 1/4, …, in which no singularity comes nearer to the boundary than half
  /// its distance, where W may tend to infinity, leaves the domain on the way, or goes farther than half
  /// of the way to another one, or than both half of its distance to the boundary and 1/20 of the diagonal.
  double LongestPart(const Eigen::VectorXd& place, const Eigen::VectorXd& step) const;
  /// Whether an edge of the boundary next to a singularity is longer than its distance, below which the
  /// mesh does not see its image (docs/method.md §5.5).
  bool OutgrowsMesh(const Eigen::VectorXd& place) const;

  std::size_t Count() const { return this->Started.size(); }
  double Unit() const { return this->Length; }
  /// In units of the diagonal.
  double Clearance() const { return this->Barrier.GetDistance() / this->Length; }
  const PointPotential& Potential() const { return *this->Points; }
  /// J, if it is minimised.
  const std::shared_ptr<const SizeUniformity>& Evenness() const { return this->Sizes; }
  /// Whether what is minimised is the same under a symmetry of the domain.
  IsometryTest SymmetryTest() const;

private:
  Eigen::VectorXd PlaceOfAll(const Configuration& configuration) const;

  std::shared_ptr<const PointPotential> Points;
  PlanarDomain Domain;
  Configuration Started;
  double Length;
  ClearanceBarrier Barrier;
  std::shared_ptr<const SizeUniformity> Sizes; ///< Null if only W is minimised.
  OptimizerSymmetry Symmetry;
};
}
