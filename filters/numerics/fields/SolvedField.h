#pragma once

#include "CrossField.h"
#include "FieldReading.h"

#include <functional>

namespace crossfield
{
/// Seconds spent in the stages of a solve.
struct StageSeconds
{
  double assemble = 0.0;
  double factor = 0.0;
  double solve = 0.0;
  double newton = 0.0; ///< The part of solve that is iterations on the hole edges.
};

/// How a field was found.
struct SolveReport
{
  double energy = 0.0;  ///< ½ ∫ |∇u|², summed over triangles; with a penalty, that as well.
  double epsilon = 0.0; ///< Of the penalty 1/(4ε²) ∫ (|u|² − f²)²; 0: there is none.
  double gradientEnergy = 0.0; ///< With a penalty: ½ ∫ w |∇u|²,
  double penaltyEnergy = 0.0;  ///< and the penalty.
  int iterations = 0;
  double residual = 0.0; ///< Of the optimality conditions, relative.
  bool converged = false;
  /// Constrained method: the field was started from the unit-norm field, not the harmonic one.
  bool startedFromUnitNorm = false;
  bool unitHoles = false;          ///< Constrained method: |u| = 1 was forced on holes.
  bool globalConstraint = false;   ///< Only the sum of the degrees was prescribed.
  std::vector<double> multipliers; ///< One per hole, for the constraint C of DegreeConstraint.
  /// Per inner loop, radians; unit-norm method only (UnitNormField.h).
  std::vector<double> holonomyDefect;
  StageSeconds seconds;
};

/// What every solve returns: the field, how it was found, and what it shows.
struct SolvedField : CrossField, SolveReport, FieldReading
{
  /// Reads the field; `count` and globalConstraint of what is here are the question.
  void Read(const Configuration& points = {});
};

/// Which of two fields is the better answer: converged, with fewer wrong degrees, fewer unwanted
/// singularities, less energy; the first that differs decides.
bool IsBetter(const SolvedField& field, const SolvedField& other);

/// The first answer if it is flawless: converged, with all degrees and no unwanted singularity; else the better of it and the second.
SolvedField BestOfTwo(
  const std::function<SolvedField()>& first, const std::function<SolvedField()>& second);
}
