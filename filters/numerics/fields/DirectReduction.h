#pragma once

#include "AlignedProblem.h"
#include "ConstraintReduction.h"

#include <memory>

namespace crossfield
{
class SparseCholesky;

/// The problem on the edges of holes and imprinted circles, with every other Crouzeix-Raviart unknown
/// eliminated (docs/method.md §3.2, direct form). The constrained edges come last in the factorisation of the
/// stiffness matrix, so that the trailing block of the factor is the Schur complement.
///
/// It holds for edges anywhere in the mesh, where that of PotentialReduction.h needs holes: an
/// imprinted circle carries forces inside the domain, and the conjugate potential would jump there.
class DirectReduction final : public ConstraintReduction
{
public:
  /// `loops`: holes and imprinted circles, one degree constraint each. Throws Error when one has too
  /// few edges for its degree.
  DirectReduction(const MeshTopology& topology, const std::vector<BoundaryLoop>& loops);
  ~DirectReduction() override;

  const AlignedProblem& GetAligned() const { return this->Aligned; }
  /// Position in AlignedProblem::free of every reduced unknown.
  const std::vector<int>& FreePositions() const { return this->Constrained; }

  /// Values of the field without constraints on the reduced unknowns.
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
