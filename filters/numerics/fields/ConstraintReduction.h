#pragma once

#include "CrossField.h"
#include "ReducedProblem.h"

namespace crossfield
{
/// A minimiser of ½ ∫ |∇u|² over Crouzeix-Raviart fields with aligned outer and inner loops and given
/// values on the constrained edges.
struct RecoveredField
{
  ComplexVector u; ///< Per edge; exactly aligned.
  double energy = 0.0;
  /// Largest |u − e^{4iτ}| over the aligned edges before they were set.
  double alignmentResidual = 0.0;
};

/// The constrained problem with every unknown eliminated but the values on the edges that carry
/// constraints, those of holes and imprinted circles (docs/method.md §3).
class ConstraintReduction
{
public:
  virtual ~ConstraintReduction() = default;

  const ReducedProblem& GetReducedProblem() const { return this->Reduced; }

  /// Values of a field on the constrained edges, as the reduced problem has them.
  virtual ComplexVector ValuesOf(const ComplexVector& u) const = 0;

  /// The field of least energy with these values.
  virtual RecoveredField Recover(const ComplexVector& x) const = 0;

protected:
  ReducedProblem Reduced;
};

/// The degree constraint of a loop whose edges are the next unknowns from `first` on. Throws Error when
/// it has too few edges for its degree.
DegreeConstraint ConstrainLoop(const MeshTopology& topology, const BoundaryLoop& loop, int first);
}
