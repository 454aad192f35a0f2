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
  double newton = 0.0; ///< The part of `solve` spent in iterations on the hole edges.
};

/// Report on how a field was computed.
struct SolveReport
{
  double energy = 0.0; ///< ½ ∫ |∇u|², summed over triangles, plus the penalty if there is one.
  double epsilon = 0.0; ///< ε of the penalty 1/(4ε²) ∫ (|u|² − f²)²; 0 without penalty.
  double gradientEnergy = 0.0; ///< With a penalty: ½ ∫ w |∇u|².
  double penaltyEnergy = 0.0;  ///< The penalty.
  int iterations = 0;
  double residual = 0.0; ///< Relative residual of the optimality conditions.
  bool converged = false;
  /// Constrained method: whether the iteration started from the unit-norm field instead of the
  /// harmonic one.
  bool startedFromUnitNorm = false;
  bool unitHoles = false;          ///< Constrained method: whether |u| = 1 was enforced on holes.
  bool globalConstraint = false;   ///< Whether only the sum of the degrees was prescribed.
  std::vector<double> multipliers; ///< One per hole, for the constraint C of DegreeConstraint.
  /// One per inner loop, in radians; unit-norm method only (UnitNormField.h).
  std::vector<double> holonomyDefect;
  StageSeconds seconds;
};

/// Result of every solve: the field, its report, and its properties.
struct SolvedField : CrossField, SolveReport, FieldReading
{
  /// Reads the properties of the field; `count` and `globalConstraint` of this object are the
  /// request.
  void Read(const Configuration& points = {});
};

/// Returns whether the first field is the better one. Compares convergence, then the number of
/// wrong degrees, then the number of unwanted singularities, then the energy.
bool IsBetter(const SolvedField& field, const SolvedField& other);

/// Returns the first field if it is flawless: converged, with all degrees and no unwanted
/// singularity; otherwise the better of both.
SolvedField BestOfTwo(
  const std::function<SolvedField()>& first, const std::function<SolvedField()>& second);
}
