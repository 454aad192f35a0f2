#pragma once

#include "PotentialOperator.h"

#include <unordered_map>
#include <utility>
#include <vector>

namespace crossfield
{
/// Boundary values of a continuous piecewise linear phase with periods, written like a potential as
/// Ψ + Σ q_k η_k: rows of PotentialOperator, zero at the vertices inside (docs/method.md §5.2).
class ConformingPhase
{
public:
  /// Steps of the strips of all periods through each triangle, which are the same for all phases.
  class Steps
  {
  public:
    explicit Steps(const PotentialOperator& laplacian);

  private:
    friend class ConformingPhase;
    std::unordered_map<int, std::vector<std::pair<Eigen::Index, const Cycle::Step*>>> OfTriangle;
  };

  /// Sets the boundary values from `growth`, the growth of the phase along every entry of
  /// mesh.boundary, in its direction. On holes it is not read: the growth around a hole is −2π
  /// times its quarter index. The phase is 0 at the first vertex of every loop.
  ConformingPhase(
    const PotentialOperator& laplacian, const Steps& steps, const Eigen::VectorXd& growth);

  /// Shifts every inner loop so that φ at the strip's first edge minus φ at its last is as given.
  void ShiftInnerLoops(const Eigen::VectorXd& differences);

  const Eigen::VectorXd& Get() const { return this->Value; }

private:
  /// Sets q_k from the growth around every inner loop and hole. A counter-clockwise path around a
  /// loop crosses its strip from left to right, which subtracts q: q is minus the growth.
  void SetPeriods(const Eigen::VectorXd& growth);
  /// Returns Σ q_k η_k in a triangle at one of its vertices.
  double Jump(int triangle, int vertex) const;
  /// Sets the values at a loop's vertices, starting from 0 at its first one.
  void SetLoop(const BoundaryLoop& loop, const Eigen::VectorXd& growth);
  /// Returns φ at the midpoint of the strip's last edge minus φ at that of its first, by following
  /// the strip.
  double Transport(Eigen::Index k) const;

  const PotentialOperator& Laplacian;
  const Steps& StepsOf;
  Eigen::VectorXd Value;
};
}
