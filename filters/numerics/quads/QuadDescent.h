#pragma once

#include "Progress.h"
#include "QuadEnergy.h"

#include <deque>

namespace crossfield
{
/// When a descent ends.
struct DescentLimits
{
  int steps = 0;
  /// The decrease that a step promises, over the energy above IdealValue or over the energy.
  double partOfExcess = 0.0;
  double partOfValue = 0.0;
};

/// L-BFGS with Armijo's rule for an energy. Long vectors in two threads, the same to the last bit however many there are.
class QuadDescent
{
public:
  explicit QuadDescent(QuadEnergy& energy);

  /// From `unknowns`, which become the result. Returns the number of steps.
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

  /// Sets Direction; returns its product with the gradient.
  double Direct(const Eigen::VectorXd& curvature);
  void Remember(const Eigen::VectorXd& curvature, const Eigen::VectorXd& unknowns);
  void Forget();
  template <typename Function>
  double Sum(const Function& function) const;

  QuadEnergy& Energy;
  const Eigen::Index Size;
  // Kept between steps and descents: large vectors are slow to allocate.
  std::deque<Correction> Memory;
  std::deque<Correction> Spare;
  Eigen::VectorXd Gradient;
  Eigen::VectorXd Direction;
  Eigen::VectorXd Next;
  Eigen::VectorXd NextGradient;
};
}
