#pragma once

#include <limits>
#include <string>
#include <vector>

namespace crossfield
{
/// Report of FlattenMetric.
struct FlatteningReport
{
  bool converged = false;
  int iterations = 0;
  int flips = 0;
  int splits = 0;
  /// Angles by which the crosses along inner loops miss the directions chosen for them, radians,
  /// before strains turn them.
  std::vector<double> loopDefects;
  /// Least maximum of |μ|, μ the Beltrami coefficient, that a map without these defects has, to
  /// first order (LeastStrain); 0 if all loops are aligned by conformal changes.
  double predictedStrain = 0.0;
  double angleDefect = 0.0;     ///< Largest remaining error of an angle sum, radians.
  double alignmentDefect = 0.0; ///< Largest remaining error of the direction of a loop, radians.

  /// Returns the ratio of the singular values of a map with that strain, (1 + |μ|) / (1 − |μ|): a
  /// square becomes a rectangle, or rhombus, of this ratio.
  double PredictedStretch() const
  {
    return this->predictedStrain < 1.0
      ? (1.0 + this->predictedStrain) / (1.0 - this->predictedStrain)
      : std::numeric_limits<double>::infinity();
  }
};

/// Predicted stretch above which users are warned, |μ| = 1/3. Of 54 random rings 3 of the 9 above it
/// have a minimum scaled Jacobian below 0.3, and 10 of the 45 below it.
constexpr double NoticeableStretch = 2.0;

/// Returns a sentence about the predicted stretch and the inner loop with the largest defect, with a
/// clause that offers a remedy unless it is empty; an empty one if no inner loop had to be turned.
std::string DescribeStretch(const FlatteningReport& report, const std::string& remedy = {});
}
