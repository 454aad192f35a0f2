#pragma once

#include "Progress.h"
#include "QuadEnergy.h"

#include <deque>

namespace crossfield
{
/// Stopping criteria of a descent.
struct DescentLimits
{
  int steps = 0;
  /// Predicted decrease of a step relative to the energy above IdealValue, and relative to the
  /// energy: the descent ends when it is not above both.
  double partOfExcess = 0.0;
  double partOfValue = 0.0;
};

/// Minimises a QuadEnergy by L-BFGS with the Armijo rule. Long vectors are processed in two
/// threads; the result is bitwise the same for any number of threads.
class QuadDescent
{
public:
  explicit QuadDescent(QuadEnergy& energy);

  /// Descends from `unknowns`, which receive the result. Returns the number of steps.
  int Descend(double epsilon, const DescentLimits& limits, Eigen::VectorXd& unknowns,
    const Progress& progress = {});

private:
  struct Correction
  {
    Eigen::VectorXd step;
    Eigen::VectorXd change;
    double inverse = 0.0; ///< 1 / step · change
    double scale = 0.0;   ///< step · change over change · change / curvature
  };

  /// Sets Direction and returns its product with the gradient.
  double ComputeDirection(const Eigen::VectorXd& curvature);
  void AddCorrection(const Eigen::VectorXd& curvature, const Eigen::VectorXd& unknowns);
  void ClearCorrections();
  template <typename Function>
  double Sum(const Function& function) const;

  QuadEnergy& Energy;
  const Eigen::Index Size;
  // Reused between steps and descents, because large vectors are slow to allocate.
  std::deque<Correction> Memory;
  std::deque<Correction> Spare;
  Eigen::VectorXd Gradient;
  Eigen::VectorXd Direction;
  Eigen::VectorXd Next;
  Eigen::VectorXd NextGradient;
};
}
