#pragma once

#include "CrossField.h"
#include "ReducedProblem.h"

namespace crossfield
{
/// Minimiser of ½ ∫ |∇u|² over Crouzeix-Raviart fields with aligned outer and inner loops and given
/// values on the constrained edges.
struct RecoveredField
{
  ComplexVector u; ///< One value per edge; exactly aligned.
  double energy = 0.0;
  /// Largest |u − e^{4iτ}| over the aligned edges before their values were set.
  double alignmentResidual = 0.0;
};

/// Constrained problem after elimination of all unknowns except the values on the edges with
/// constraints, those of holes and imprinted circles (docs/method.md §3).
class ConstraintReduction
{
public:
  virtual ~ConstraintReduction() = default;

  const ReducedProblem& GetReducedProblem() const { return this->Reduced; }

  /// Returns the values of a field on the constrained edges, in the form of the reduced problem.
  virtual ComplexVector ValuesOf(const ComplexVector& u) const = 0;

  /// Returns the field of minimum energy with these values.
  virtual RecoveredField Recover(const ComplexVector& x) const = 0;

protected:
  ReducedProblem Reduced;
};

/// Builds the degree constraint of a loop whose edges are consecutive unknowns starting at `first`.
/// Throws Error when the loop has too few edges for its degree.
DegreeConstraint ConstrainLoop(const PlanarTopology& topology, const BoundaryLoop& loop, int first);
}
