#pragma once

#include "AlignedProblem.h"
#include "ReducedProblem.h"

#include <memory>

namespace crossfield
{
class SparseCholesky;

/// The problem on the edges of holes and imprinted circles, with every other Crouzeix-Raviart unknown
/// eliminated (docs/method.md §3, direct form). The constrained edges come last in the factorisation of the
/// stiffness matrix, so that the trailing block of the factor is the Schur complement.
///
/// It holds for edges anywhere in the mesh, where that of ConstrainedField.h needs holes: an
/// imprinted circle carries forces inside the domain, and the conjugate potential would jump there.
class EdgeReduction
{
public:
  /// `loops`: holes and imprinted circles, one degree constraint each. Throws Error when one has too
  /// few edges for its degree.
  EdgeReduction(
    const TriangleMesh& mesh, const EdgeNumbering& edges, const std::vector<BoundaryLoop>& loops);
  ~EdgeReduction();

  const AlignedProblem& GetAligned() const { return this->Aligned; }
  const ReducedProblem& GetReducedProblem() const { return this->Reduced; }
  /// Position in AlignedProblem::free of every reduced unknown.
  const std::vector<int>& FreePositions() const { return this->Constrained; }

  /// Values of the field without constraints on the reduced unknowns.
  const ComplexVector& HarmonicValues() const { return this->Harmonic; }

  /// Values of a field on the reduced unknowns.
  ComplexVector ValuesOf(const ComplexVector& u) const;

  /// The field of least energy with these values on the reduced unknowns.
  ComplexVector Recover(const ComplexVector& x) const;

private:
  AlignedProblem Aligned;
  std::vector<int> Constrained;
  std::unique_ptr<SparseCholesky> Factor;
  ReducedProblem Reduced;
  ComplexVector Harmonic;
};
}
