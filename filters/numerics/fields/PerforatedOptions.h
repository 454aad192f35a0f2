#pragma once

#include "BoundaryCorners.h"
#include "Minimisation.h"

namespace crossfield
{
/// How the field on a perforated domain is computed.
enum class PerforatedMethod
{
  Constrained, ///< PotentialReduction.h: |u| free, one quadratic degree constraint per hole.
  UnitNorm     ///< UnitNormField.h: |u| = 1, from one linear system.
};

/// Where the iteration of the constrained method starts.
enum class PerforatedStart
{
  /// Harmonic. Where its field has a wrong degree or an unwanted singularity, unit-norm as well,
  /// and the better of the two; where a degree is still wrong, |u| = 1 is forced on the holes.
  Best,
  Harmonic, ///< The field without constraints: leads to the global minimum of the energy.
  UnitNorm  ///< The unit-norm field: leads to a local minimum near it.
};

struct PerforatedOptions
{
  PerforatedMethod method = PerforatedMethod::Constrained;
  PerforatedStart start = PerforatedStart::Best;
  bool unitHoles = false; ///< Constrained method: force |u| = 1 on the holes (UnitSolve.h).
  /// The same on some holes only, by their rows in the configuration.
  std::vector<int> unitHoleRows;
  /// Constrained method: one constraint, Σ_i C_i = Σ_i t_i, in place of one per hole.
  bool globalConstraint = false;
  /// Constrained method: ε of the penalty 1/(4ε²) ∫ (|u|² − 1)², a length; 0 for none.
  double epsilon = 0.0;
  MinimiserOptions reduced; ///< Of the constrained method.
  /// Quarter indices chosen for vertices of outer and inner loops instead of the smallest rotations.
  /// The unit-norm field takes them; the constrained one is only held to the sum that they leave to
  /// the holes.
  std::vector<CornerChoice> corners;
};
}
