#pragma once

#include "BoundaryCorners.h"
#include "Minimisation.h"

namespace crossfield
{
/// Method that computes the field on a perforated domain.
enum class PerforatedMethod
{
  Constrained, ///< PotentialReduction.h: |u| free, one quadratic degree constraint per hole.
  UnitNorm     ///< UnitNormField.h: |u| = 1, from one linear system.
};

/// Start of the iteration of the constrained method.
enum class PerforatedStart
{
  /// Harmonic. If its field has a wrong degree or an unwanted singularity, unit-norm as well, and
  /// the better of the two; if a degree is still wrong, |u| = 1 is enforced on the holes.
  Best,
  Harmonic, ///< The field without constraints; leads to the global minimum of the energy.
  UnitNorm  ///< The unit-norm field; leads to a local minimum near it.
};

struct PerforatedOptions
{
  PerforatedMethod method = PerforatedMethod::Constrained;
  PerforatedStart start = PerforatedStart::Best;
  bool unitHoles = false; ///< Constrained method: enforces |u| = 1 on all holes (UnitSolve.h).
  /// Constrained method: enforces |u| = 1 on the holes in these rows of the configuration.
  std::vector<int> unitHoleRows;
  /// Constrained method: one constraint, Σ_i C_i = Σ_i t_i, instead of one per hole.
  bool globalConstraint = false;
  /// Constrained method: ε of the penalty 1/(4ε²) ∫ (|u|² − 1)², a length; 0 for no penalty.
  double epsilon = 0.0;
  MinimiserOptions reduced; ///< Options of the minimiser of the constrained method.
  /// Quarter indices chosen for vertices of outer and inner loops instead of the smallest
  /// rotations. The unit-norm field has exactly these indices; for the constrained field they only
  /// determine the sum that remains for the holes.
  std::vector<CornerChoice> corners;
};
}
