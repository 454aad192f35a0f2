#include "QuarterTurns.h"

#include "Plane.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace crossfield
{
namespace
{
/// Changes of one or two numbers by ±1.
std::vector<Eigen::VectorXi> Neighbours(Eigen::Index count)
{
  std::vector<Eigen::VectorXi> changes;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (const int first : { -1, 1 })
    {
      Eigen::VectorXi one = Eigen::VectorXi::Zero(count);
      one[i] = first;
      changes.push_back(one);
      for (Eigen::Index j = i + 1; j < count; ++j)
      {
        for (const int second : { -1, 1 })
        {
          one[j] = second;
          changes.push_back(one);
        }
        one[j] = 0;
      }
    }
  }
  return changes;
}

/// A gain below this part does not pay for another layout.
constexpr double Gain = 0.02;
}

double LeastStrain(
  const DifferentialSample& sample, const Eigen::VectorXd& angles, Eigen::VectorXd& coefficients)
{
  // Weighted least squares: with weights 1 / |q| of the previous pass it is the problem itself.
  constexpr int Passes = 6;
  // Part of the mean of |q| below which weights do not grow, so that matrices stay regular.
  constexpr double Floor = 0.05;
  const Eigen::Index count = angles.size();
  const Eigen::VectorXd& areas = sample.areas;
  Eigen::VectorXd magnitude = Eigen::VectorXd::Ones(areas.size());
  const auto magnitudes = [&](const Eigen::VectorXd& c) -> Eigen::VectorXd
  { return (sample.quadratic * c).cwiseAbs(); };
  if (coefficients.size() == count)
  {
    magnitude = magnitudes(coefficients);
  }
  double strain = 0.0;
  for (int pass = 0; pass < Passes; ++pass)
  {
    const double floor = Floor * magnitude.dot(areas) / areas.sum();
    const Eigen::VectorXd weights = areas.cwiseQuotient(magnitude.cwiseMax(floor));
    const Eigen::MatrixXd gram =
      (sample.quadratic.adjoint() * weights.asDiagonal() * sample.quadratic).real();
    coefficients = gram.fullPivLu().solve(angles);
    magnitude = magnitudes(coefficients);
    strain = std::max(strain, coefficients.dot(angles) / magnitude.dot(areas));
  }
  return strain;
}

namespace
{
/// Turns those of many loops with the largest defects, one after the other, as far as that reduces the strain.
/// At most `count` are tried.
Eigen::VectorXi TurnLargestDefects(const DifferentialSample& sample, const Eigen::VectorXd& defects,
  std::size_t count, const Progress& progress)
{
  std::vector<Eigen::Index> loops(static_cast<std::size_t>(defects.size()));
  std::iota(loops.begin(), loops.end(), 0);
  std::stable_sort(loops.begin(), loops.end(),
    [&](Eigen::Index a, Eigen::Index b) { return std::abs(defects[a]) > std::abs(defects[b]); });
  loops.resize(std::min(loops.size(), count));
  Eigen::VectorXi turns = Eigen::VectorXi::Zero(defects.size());
  Eigen::VectorXd coefficients;
  double least = LeastStrain(sample, defects, coefficients);
  for (const Eigen::Index loop : loops)
  {
    progress.Report(0.0);
    Eigen::VectorXi next = turns;
    next[loop] += defects[loop] > 0.0 ? 1 : -1;
    Eigen::VectorXd candidate = coefficients;
    const double strain = LeastStrain(sample, defects - 0.5 * Pi * next.cast<double>(), candidate);
    if (strain < (1.0 - Gain) * least)
    {
      least = strain;
      turns = next;
      coefficients = candidate;
    }
  }
  return turns;
}
}

Eigen::VectorXi ChooseQuarterTurns(
  const DifferentialSample& sample, const Eigen::VectorXd& defects, const Progress& progress)
{
  // Entries of Gram matrices and of their factors, for a few seconds.
  constexpr double MaximumWork = 6e8;
  const auto count = static_cast<double>(defects.size());
  const double affordable =
    MaximumWork / (count * count * (static_cast<double>(sample.areas.size()) + count));
  if (2.0 * count * count > affordable) // the number of changes
  {
    return TurnLargestDefects(sample, defects, static_cast<std::size_t>(affordable), progress);
  }
  const std::vector<Eigen::VectorXi> changes = Neighbours(defects.size());
  Eigen::VectorXi turns = Eigen::VectorXi::Zero(defects.size());
  Eigen::VectorXd coefficients;
  double least = LeastStrain(sample, defects, coefficients);
  for (bool improved = true; improved;)
  {
    improved = false;
    const Eigen::VectorXi centre = turns;
    const Eigen::VectorXd start = coefficients;
    for (const Eigen::VectorXi& change : changes)
    {
      progress.Report(0.0);
      Eigen::VectorXd candidate = start;
      const double strain =
        LeastStrain(sample, defects - 0.5 * Pi * (centre + change).cast<double>(), candidate);
      if (strain < (1.0 - Gain) * least)
      {
        least = strain;
        turns = centre + change;
        coefficients = candidate;
        improved = true;
      }
    }
  }
  return turns;
}
}
