#include "QuarterTurns.h"

#include "Plane.h"

#include <Eigen/LU>

#include <algorithm>
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

Eigen::VectorXi ChooseQuarterTurns(
  const DifferentialSample& sample, const Eigen::VectorXd& defects, const Progress& progress)
{
  const std::vector<Eigen::VectorXi> changes = Neighbours(defects.size());
  // A gain below this part does not pay for another layout.
  constexpr double Gain = 0.02;
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
