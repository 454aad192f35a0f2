#include "QuadDescent.h"

#include <deque>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// Corrections that the limited memory method remembers.
constexpr std::size_t Memory = 8;

struct Correction
{
  Eigen::VectorXd step;
  Eigen::VectorXd change;
  double inverse = 0.0;
};

/// The direction by the two-loop recursion, with the inverse of the curvature as first guess.
void Direct(const std::deque<Correction>& memory, const Eigen::VectorXd& curvature,
  const Eigen::VectorXd& gradient, Eigen::VectorXd& direction)
{
  direction = -gradient;
  std::vector<double> factors(memory.size());
  for (std::size_t i = memory.size(); i-- > 0;)
  {
    factors[i] = memory[i].inverse * memory[i].step.dot(direction);
    direction -= factors[i] * memory[i].change;
  }
  double scale = 1.0;
  if (!memory.empty())
  {
    const Correction& last = memory.back();
    scale = 1.0 / (last.inverse * last.change.dot(last.change.cwiseQuotient(curvature)));
  }
  direction.array() *= scale / curvature.array();
  for (std::size_t i = 0; i < memory.size(); ++i)
  {
    direction +=
      (factors[i] - memory[i].inverse * memory[i].change.dot(direction)) * memory[i].step;
  }
}
}

int Descend(QuadEnergy& energy, double epsilon, const DescentLimits& limits,
  Eigen::VectorXd& unknowns, const Progress& progress)
{
  const Eigen::VectorXd& curvature = energy.Curvature();
  Eigen::VectorXd gradient;
  double value = energy.Value(unknowns, epsilon, &gradient);
  std::deque<Correction> memory;
  // Kept between steps: large vectors are slow to allocate.
  Eigen::VectorXd direction;
  Eigen::VectorXd next;
  Eigen::VectorXd nextGradient;
  int step = 0;
  for (; step < limits.steps && unknowns.size() > 0; ++step)
  {
    progress.Report(static_cast<double>(step) / limits.steps);
    Direct(memory, curvature, gradient, direction);
    double slope = direction.dot(gradient);
    if (!(slope < 0.0))
    {
      memory.clear();
      direction = -gradient.cwiseQuotient(curvature);
      slope = direction.dot(gradient);
    }
    if (!(-slope > limits.partOfValue * value) ||
      !(-slope > limits.partOfExcess * (value - energy.IdealValue())))
    {
      break;
    }
    // Armijo's rule, halving. Infinite where a corner would turn over.
    double length = 1.0;
    double nextValue = value;
    const auto decreases = [&] { return nextValue <= value + 1e-4 * length * slope; };
    for (int halving = 0; halving < 30; ++halving, length *= 0.5)
    {
      next = unknowns + length * direction;
      nextValue = energy.Value(next, epsilon, &nextGradient);
      if (decreases())
      {
        break;
      }
    }
    if (!decreases())
    {
      if (memory.empty())
      {
        break;
      }
      memory.clear();
      continue;
    }
    Correction correction;
    if (memory.size() == Memory)
    {
      correction = std::move(memory.front());
      memory.pop_front();
    }
    correction.step = next - unknowns;
    correction.change = nextGradient - gradient;
    const double product = correction.step.dot(correction.change);
    if (product > 0.0)
    {
      correction.inverse = 1.0 / product;
      memory.push_back(std::move(correction));
    }
    unknowns.swap(next);
    gradient.swap(nextGradient);
    value = nextValue;
  }
  return step;
}
}
