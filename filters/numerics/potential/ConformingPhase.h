#pragma once

#include "PotentialSolver.h"

#include <map>
#include <utility>
#include <vector>

namespace crossfield
{
/// Boundary values of a continuous piecewise linear phase with periods, written like a potential as Ψ + Σ q_k η_k: zero at
/// the vertices inside, rows of PotentialSolver (docs/method.md §5.2).
class ConformingPhase
{
public:
  /// `growth`: of the phase along every entry of mesh.boundary, in its direction; that along a hole is −2π times its
  /// quarter index. The phase is 0 at the first vertex of every loop.
  ConformingPhase(const PotentialSolver& potential, const Eigen::VectorXd& growth);

  /// Shifts every inner loop so that φ at the strip's first edge minus φ at its last is as given.
  void ShiftInnerLoops(const Eigen::VectorXd& differences);

  const Eigen::VectorXd& Get() const { return this->Value; }

private:
  /// Going counter-clockwise around a loop one crosses its strip from the left to the right, which
  /// takes q away: q is minus the growth.
  void SetPeriods(const Eigen::VectorXd& growth);
  /// Σ q_k η_k in a triangle at one of its vertices.
  double Jump(int triangle, int vertex) const;
  /// The values at a loop's vertices, from 0 at its first one.
  void SetLoop(const BoundaryLoop& loop, const Eigen::VectorXd& growth);
  /// φ at the midpoint of the strip's last edge minus that of its first, along the strip.
  double Transport(Eigen::Index k) const;

  const PotentialSolver& Potential;
  std::map<int, std::vector<std::pair<Eigen::Index, const LoopStrip::Step*>>> StepsOf;
  Eigen::VectorXd Value;
};
}
