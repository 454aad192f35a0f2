#include "QuadDescent.h"

#include "Parts.h"

#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// Number of corrections that L-BFGS stores.
constexpr std::size_t MaximumCorrections = 8;
}

QuadDescent::QuadDescent(QuadEnergy& energy)
  : Energy(energy)
  , Size(energy.Curvature().size())
{
}

/// Returns the sum of function(begin, count) over ranges of the unknowns.
template <typename Function>
double QuadDescent::Sum(const Function& function) const
{
  return SumOfRanges(
    this->Size, [&](Eigen::Index begin, Eigen::Index end) { return function(begin, end - begin); },
    MinimumUnknowns);
}

double QuadDescent::ComputeDirection(const Eigen::VectorXd& curvature)
{
  // The two-loop recursion, with the inverse curvature as initial Hessian. Every pass over the
  // vectors ends with the product that the next one needs.
  const std::size_t count = this->Memory.size();
  std::vector<double> factors(count);
  Eigen::VectorXd& direction = this->Direction;
  direction.resize(this->Size);
  double product = this->Sum(
    [&](Eigen::Index begin, Eigen::Index size)
    {
      direction.segment(begin, size) = -this->Gradient.segment(begin, size);
      return count == 0
        ? 0.0
        : this->Memory.back().step.segment(begin, size).dot(direction.segment(begin, size));
    });
  for (std::size_t i = count; i-- > 0;)
  {
    const Correction& correction = this->Memory[i];
    factors[i] = correction.inverse * product;
    product = this->Sum(
      [&](Eigen::Index begin, Eigen::Index size)
      {
        auto part = direction.segment(begin, size);
        part -= factors[i] * correction.change.segment(begin, size);
        return i == 0 ? 0.0 : this->Memory[i - 1].step.segment(begin, size).dot(part);
      });
  }
  const double scale = count == 0 ? 1.0 : this->Memory.back().scale;
  product = this->Sum(
    [&](Eigen::Index begin, Eigen::Index size)
    {
      auto part = direction.segment(begin, size);
      part.array() *= scale / curvature.segment(begin, size).array();
      return (count == 0 ? this->Gradient : this->Memory.front().change)
        .segment(begin, size)
        .dot(part);
    });
  for (std::size_t i = 0; i < count; ++i)
  {
    const Correction& correction = this->Memory[i];
    const double factor = factors[i] - correction.inverse * product;
    product = this->Sum(
      [&](Eigen::Index begin, Eigen::Index size)
      {
        auto part = direction.segment(begin, size);
        part += factor * correction.step.segment(begin, size);
        return (i + 1 == count ? this->Gradient : this->Memory[i + 1].change)
          .segment(begin, size)
          .dot(part);
      });
  }
  return product;
}

void QuadDescent::AddCorrection(const Eigen::VectorXd& curvature, const Eigen::VectorXd& unknowns)
{
  if (this->Memory.size() == MaximumCorrections)
  {
    this->Spare.push_back(std::move(this->Memory.front()));
    this->Memory.pop_front();
  }
  Correction correction;
  if (!this->Spare.empty())
  {
    correction = std::move(this->Spare.back());
    this->Spare.pop_back();
  }
  correction.step.resize(this->Size);
  correction.change.resize(this->Size);
  const double product = this->Sum(
    [&](Eigen::Index begin, Eigen::Index size)
    {
      auto step = correction.step.segment(begin, size);
      auto change = correction.change.segment(begin, size);
      step = this->Next.segment(begin, size) - unknowns.segment(begin, size);
      change = this->NextGradient.segment(begin, size) - this->Gradient.segment(begin, size);
      return step.dot(change);
    });
  if (!(product > 0.0))
  {
    this->Spare.push_back(std::move(correction));
    return;
  }
  correction.inverse = 1.0 / product;
  correction.scale = product /
    this->Sum(
      [&](Eigen::Index begin, Eigen::Index size)
      {
        const auto change = correction.change.segment(begin, size);
        return change.dot(change.cwiseQuotient(curvature.segment(begin, size)));
      });
  this->Memory.push_back(std::move(correction));
}

void QuadDescent::ClearCorrections()
{
  for (Correction& correction : this->Memory)
  {
    this->Spare.push_back(std::move(correction));
  }
  this->Memory.clear();
}

int QuadDescent::Descend(
  double epsilon, const DescentLimits& limits, Eigen::VectorXd& unknowns, const Progress& progress)
{
  this->ClearCorrections();
  const Eigen::VectorXd& curvature = this->Energy.Curvature();
  double value = this->Energy.Value(unknowns, epsilon, &this->Gradient);
  int step = 0;
  for (; step<limits.steps&& this->Size> 0; ++step)
  {
    progress.Report(static_cast<double>(step) / limits.steps);
    double slope = this->ComputeDirection(curvature);
    if (!(slope < 0.0))
    {
      this->ClearCorrections();
      slope = this->ComputeDirection(curvature);
    }
    if (!(-slope > limits.partOfValue * value) ||
      !(-slope > limits.partOfExcess * (value - this->Energy.IdealValue())))
    {
      break;
    }
    // Armijo rule by halving. The energy is infinite if a corner would be inverted.
    double length = 1.0;
    double nextValue = value;
    const auto decreases = [&] { return nextValue <= value + 1e-4 * length * slope; };
    for (int halving = 0; halving < 30; ++halving, length *= 0.5)
    {
      this->Next.resize(this->Size);
      ForRanges(
        this->Size,
        [&](int begin, int end)
        {
          const int size = end - begin;
          this->Next.segment(begin, size) =
            unknowns.segment(begin, size) + length * this->Direction.segment(begin, size);
        },
        MinimumUnknowns);
      nextValue = this->Energy.Value(this->Next, epsilon, &this->NextGradient);
      if (decreases())
      {
        break;
      }
    }
    if (!decreases())
    {
      if (this->Memory.empty())
      {
        break;
      }
      this->ClearCorrections();
      continue;
    }
    this->AddCorrection(curvature, unknowns);
    unknowns.swap(this->Next);
    this->Gradient.swap(this->NextGradient);
    value = nextValue;
  }
  return step;
}
}
