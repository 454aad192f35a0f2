#pragma once

#include "AlignedProblem.h"

namespace crossfield
{
/// Modification of the Ginzburg-Landau functional that pins singularities (paper, "Pinning
/// strategy"). Singularities prefer positions where either of the two values is small.
struct GinzburgLandauPinning
{
  /// f ≥ 0, the target norm of the penalty: one value per triangle or one per edge. Empty: 1.
  Eigen::VectorXd norm;
  /// w > 0, the weight of the gradient term: one value per triangle. Empty: 1.
  Eigen::VectorXd gradientWeight;
};

/// Functional E(u) = ½ ∫ w |∇u|² + 1/(4ε²) ∫ (|u|² − f²)² over Crouzeix-Raviart fields with u =
/// e^{4iτ} on every edge of the outer and inner loops (docs/method.md §4.1).
///
/// The gradient term is integrated exactly, triangle by triangle. The penalty is integrated with
/// the midpoints of edges, weighted by |T|/3 each. This rule is exact for quadratic functions on a
/// triangle, so the error is of second order in the mesh size, and every edge has a term of its
/// own. If f is given per edge, the same value counts in both triangles of the edge.
class GinzburgLandauEnergy
{
public:
  /// Assembles the functional. `epsilon` is a length. Throws Error when it is not positive, or the
  /// pinning has the wrong number of values or one out of range.
  GinzburgLandauEnergy(
    const PlanarTopology& topology, double epsilon, const GinzburgLandauPinning& pinning = {});

  /// Returns the edges whose value is not prescribed, in increasing order: the unknowns.
  const std::vector<int>& FreeEdges() const { return this->Aligned.free; }
  /// Sets the values on the aligned edges.
  void Align(ComplexVector& u) const { this->Aligned.Align(u); }

  /// Returns ½ ∫ w |∇u|².
  double GradientPart(const ComplexVector& u) const;
  /// Returns 1/(4ε²) ∫ (|u|² − f²)².
  double PenaltyPart(const ComplexVector& u) const;
  double Value(const ComplexVector& u) const
  {
    return this->GradientPart(u) + this->PenaltyPart(u);
  }

  /// Returns ∂E/∂(Re u, Im u) on the free edges; entries 2i and 2i + 1 belong to the i-th free
  /// edge.
  Eigen::VectorXd Gradient(const ComplexVector& u) const;

  /// Returns the sum of the norms of the terms that cancel in the gradient, the scale for
  /// residuals.
  double ResidualScale(const ComplexVector& u) const;

  /// Returns the second derivatives, in the numbering of Gradient, plus `shift` × D with the
  /// diagonal matrix D = 1/ε² ∫ f² of Metric(). The matrix is symmetric, compressed, and has both
  /// triangles stored. It is positive definite for shift ≥ 1 and any u; for shift 0 it has negative
  /// eigenvalues where |u| is too small.
  Eigen::SparseMatrix<double> Hessian(const ComplexVector& u, double shift = 0.0) const;

  /// Returns the diagonal of D, in the numbering of Gradient.
  Eigen::VectorXd Metric() const;

  /// Returns a fill-reducing elimination order of the unknowns of the Hessian. The unknowns of the
  /// free edges at the positions `trailing` come last.
  std::vector<int> UnknownOrder(const std::vector<int>& trailing = {}) const;

  /// Returns the field without penalty, the minimiser of ½ ∫ w |∇u|².
  ComplexVector HarmonicField() const { return this->Aligned.HarmonicField(); }

private:
  double InverseSquare; ///< 1/ε².
  AlignedProblem Aligned;
  // Coefficients per edge: the penalty is InverseSquare / 4 × (Mass |u|⁴ − 2 Pull |u|² + Offset).
  Eigen::VectorXd Mass;
  Eigen::VectorXd Pull;
  Eigen::VectorXd Offset;
  /// Hessian of the gradient term, with storage for the entries of the penalty.
  SparseMatrix Pattern;
  /// Positions in Pattern of each edge's diagonal block.
  std::vector<std::array<std::ptrdiff_t, 4>> Blocks;
};
}
