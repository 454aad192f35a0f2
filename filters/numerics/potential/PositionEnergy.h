#pragma once

#include "BoundarySamples.h"
#include "EdgePotential.h"
#include "RenormalizedEnergy.h"

#include <memory>

namespace crossfield
{
/// W of many configurations on one mesh, which differ in the positions of their singularities
/// (docs/method.md §5.4). The value is that of EvaluateRenormalizedEnergy up to rounding. What does
/// not depend on the positions is computed once, sums are arranged by the points of the boundary,
/// and several singularities share one logarithm and one arctangent.
///
/// Each evaluation costs two back-substitutions, one at the vertices and one of the inner vertices.
class PositionEnergy
{
public:
  explicit PositionEnergy(std::shared_ptr<const PointPotential> potential);

  /// Sums of all logarithms on the halves of boundary edges.
  struct Flows
  {
    Eigen::VectorXd flux; ///< Flux through each half.
    Eigen::VectorXd mean; ///< Mean over each half.
  };

  struct Value
  {
    PointPotential::Solution solution;
    RenormalizedEnergyValue renormalized;
    Flows flows;
    Eigen::VectorXd regular; ///< R on every half: the mean of both solutions.
  };

  /// Solves for a configuration, which must fulfil PointPotential::RequireSolvable, and evaluates W.
  /// Without `derivatives` all gradients are empty.
  Value Evaluate(const Configuration& configuration, bool derivatives = true) const;

  const PointPotential& GetPotential() const { return *this->Potential; }
  /// Returns the number of points of the boundary at which logarithms are evaluated.
  Eigen::Index PointCount() const { return this->Samples.points.rows(); }

  const EdgePotential& GetEdgePotential() const { return this->OnEdges; }

private:
  friend struct PositionCurvature Differentiate(
    const PositionEnergy&, const Configuration&, const Eigen::VectorXd&);

  /// Factors of the derivatives of arg|x − b| and log|x − b| at the points of the boundary.
  struct PointFactors
  {
    Eigen::ArrayXd ofTurns;
    Eigen::ArrayXd ofLogs;
  };

  /// Returns MidpointInfluence.
  const Eigen::MatrixXd& GetMidpointInfluence() const;
  /// Solves for the regular part and its value on every half, and sums up the logarithms.
  Flows Solve(const Configuration& configuration, PointPotential::Solution& solution,
    Eigen::VectorXd& regular) const;
  PointFactors FindFactors(const Flows& flows, const Eigen::VectorXd& regular) const;
  /// Adds the interaction of the logarithms to the energy and the gradient.
  void AddInteraction(
    const std::vector<LogSource>& logs, std::size_t inside, RenormalizedEnergyValue& value) const;
  /// Adds the derivatives of the boundary integrals and of the holonomy defects. `regular` has the
  /// value of R on every half.
  void AddDerivatives(const PointPotential::Solution& solution, std::size_t inside,
    const Flows& flows, const Eigen::VectorXd& regular, RenormalizedEnergyValue& value) const;

  std::shared_ptr<const PointPotential> Potential;
  EdgePotential OnEdges;
  BoundarySamples Samples;
  std::vector<std::vector<Point>> Paths; ///< PointPotential::StripPath on the polygon.
  Eigen::VectorXd BoundaryTurns; ///< Turns of the logarithms at the boundary along each strip.
  double BoundaryInteraction = 0.0;
  double BoundaryCoefficient = 0.0; ///< Logarithm coefficient of the boundary.
  /// Change of each holonomy defect by the angle at which a singularity sees a midpoint; a column
  /// per inner loop. Only derivatives need it.
  Lazy<Eigen::MatrixXd> MidpointInfluence;
};
}
