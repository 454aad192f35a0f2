#pragma once

#include "AlignedProblem.h"
#include "ConstraintReduction.h"

#include <memory>

namespace crossfield
{
class SparseCholesky;

/// Problem on the edges of holes and imprinted circles, after elimination of every other
/// Crouzeix-Raviart unknown (docs/method.md §3.2, direct form). The constrained edges come last in
/// the factorisation of the stiffness matrix, so that the trailing block of the factor is that of
/// the Schur complement.
///
/// It applies to edges anywhere in the mesh, whereas PotentialReduction.h requires holes: at an
/// imprinted circle the constraint acts inside the domain, where the conjugate potential would
/// jump.
class DirectReduction final : public ConstraintReduction
{
public:
  /// Reduces the problem. `loops` are holes and imprinted circles, with one degree constraint each.
  /// Throws Error when a loop has too few edges for its degree.
  DirectReduction(const PlanarTopology& topology, const std::vector<BoundaryLoop>& loops);
  ~DirectReduction() override;

  const AlignedProblem& GetAligned() const { return this->Aligned; }
  /// Returns the position in AlignedProblem::free of every reduced unknown.
  const std::vector<int>& FreePositions() const { return this->Constrained; }

  /// Returns the values on the reduced unknowns of the field without constraints.
  const ComplexVector& HarmonicValues() const { return this->Harmonic; }

  ComplexVector ValuesOf(const ComplexVector& u) const override;
  RecoveredField Recover(const ComplexVector& x) const override;

private:
  AlignedProblem Aligned;
  std::vector<int> Constrained;
  std::unique_ptr<SparseCholesky> Factor;
  ComplexVector Harmonic;
};
}
