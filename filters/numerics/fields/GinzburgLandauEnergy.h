#pragma once

#include "AlignedProblem.h"

namespace crossfield
{
/// Where and how strongly the Ginzburg-Landau functional is modified to pin singularities (paper,
/// "Pinning strategy"). Singularities prefer places where either of the two is small.
struct GinzburgLandauPinning
{
  /// f ≥ 0, the norm that the penalty asks for: one value per triangle or one per edge. Empty: 1.
  Eigen::VectorXd norm;
  /// w > 0, the weight of the gradient term: one value per triangle. Empty: 1.
  Eigen::VectorXd gradientWeight;
};

/// The functional E(u) = ½ ∫ w |∇u|² + 1/(4ε²) ∫ (|u|² − f²)² over Crouzeix-Raviart fields with
/// u = e^{4iτ} on every edge of the outer and inner loops (docs/method.md §4.1).
///
/// The gradient term is integrated exactly, triangle by triangle. The penalty is integrated by the
/// midpoints of edges, |T|/3 each: exact for quadratic functions on a triangle, so the error is of
/// second order in the mesh size, and every edge has a term of its own. With f per edge the same f
/// counts in both of its triangles.
class GinzburgLandauEnergy
{
public:
  /// `epsilon` is a length. Throws Error when it is not positive, or the pinning has the wrong
  /// number of values or one out of range.
  GinzburgLandauEnergy(
    const MeshTopology& topology, double epsilon, const GinzburgLandauPinning& pinning = {});

  /// Edges whose value is not prescribed, in increasing order: the unknowns.
  const std::vector<int>& FreeEdges() const { return this->Aligned.free; }
  /// Sets the values on the aligned edges.
  void Align(ComplexVector& u) const { this->Aligned.Align(u); }

  /// ½ ∫ w |∇u|².
  double GradientPart(const ComplexVector& u) const;
  /// 1/(4ε²) ∫ (|u|² − f²)².
  double PenaltyPart(const ComplexVector& u) const;
  double Value(const ComplexVector& u) const
  {
    return this->GradientPart(u) + this->PenaltyPart(u);
  }

  /// ∂E/∂(Re u, Im u) on the free edges: entries 2i and 2i + 1 belong to the i-th free edge.
  Eigen::VectorXd Gradient(const ComplexVector& u) const;

  /// Sum of the norms of the terms that cancel in the gradient, to measure it by.
  double ResidualScale(const ComplexVector& u) const;

  /// Second derivatives, in the numbering of Gradient, plus `shift` × D with the diagonal matrix
  /// D = 1/ε² ∫ f² of Metric(). Symmetric, both halves stored, compressed. Positive definite for
  /// shift ≥ 1 whatever u is; for shift 0 it has negative eigenvalues where |u| is too small.
  Eigen::SparseMatrix<double> Hessian(const ComplexVector& u, double shift = 0.0) const;

  /// The diagonal of D, in the numbering of Gradient.
  Eigen::VectorXd Metric() const;

  /// Fill-reducing elimination order of the unknowns of the Hessian, with those of the free edges at
  /// the positions `trailing` at the end.
  std::vector<int> UnknownOrder(const std::vector<int>& trailing = {}) const;

  /// The field without penalty: least ½ ∫ w |∇u|².
  ComplexVector HarmonicField() const { return this->Aligned.HarmonicField(); }

private:
  double InverseSquare; ///< 1/ε².
  AlignedProblem Aligned;
  // Per edge: the penalty is InverseSquare / 4 × (Mass |u|⁴ − 2 Pull |u|² + Offset).
  Eigen::VectorXd Mass;
  Eigen::VectorXd Pull;
  Eigen::VectorXd Offset;
  SparseMatrix Pattern; ///< The Hessian of the gradient term, with room for that of the penalty.
  std::vector<std::array<std::ptrdiff_t, 4>> Blocks; ///< Where in it each edge's own block is.
};
}
