#pragma once

#include "MeshTopology.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace crossfield
{
/// The P1 Laplacian of potentials with periods (docs/method.md §2.3).
///
/// Unknowns are the values of a potential Ψ at the vertices, and one period q_k per cycle of the mesh,
/// that is, per inner loop, handle (two) and hole: at a loop, the amount by which Ψ grows along a closed
/// path around it with the domain on the left. Ψ
/// with periods is Ψ + Σ q_k η_k with the cut functions η_k of the cycles of the
/// mesh, whose gradients vanish outside their strips. The matrix is
///   [ K  r ; rᵀ R ],  r_k = Σ_T K_T η_k|T,  R_kl = Σ_T η_k|Tᵀ K_T η_l|T,
/// that of the energy ½ ∫ |∇Ψ + Σ q_k ∇η_k|², positive semidefinite with the constants as kernel.
///
/// Vectors have a row per vertex of the mesh, then a row per period, those of holes last: a surface has
/// handles or holes, not both. With φ the conjugate of Ψ, ∇φ = rot ∇Ψ, rot = +90°, φ at the midpoints of edges
/// (Crouzeix-Raviart), the entries of a right-hand side ("sources") mean:
/// - at a boundary vertex: φ on the boundary edge after it minus φ on the one before, with the
///   domain on the left; at an interior vertex: −2π times the number of turns of φ around it;
/// - at a period: φ on the strip's first edge minus φ on its last edge.
///
/// Immutable: every member function may be called from several threads at once.
class PotentialOperator
{
public:
  /// The cycles around which a potential has a period; the periods around the others are zero.
  /// A hole needs one only where its edges are not free to shift by a common constant.
  enum class Periods
  {
    Islands,        ///< Inner loops and handles.
    IslandsAndHoles ///< All cycles.
  };

  explicit PotentialOperator(SharedTopology topology);

  const MeshTopology& GetTopology() const { return *this->Topology; }

  /// Returns the number of rows: vertices of the mesh plus all periods.
  Eigen::Index Rows() const { return this->VertexCount() + this->PeriodCount(); }
  Eigen::Index VertexCount() const
  {
    return static_cast<Eigen::Index>(this->Topology->mesh.points.size());
  }
  Eigen::Index PeriodCount(Periods periods = Periods::IslandsAndHoles) const
  {
    return periods == Periods::Islands ? this->IslandCount
                                       : static_cast<Eigen::Index>(this->Topology->cycles.size());
  }
  /// Returns the row of the k-th period.
  Eigen::Index PeriodRow(Eigen::Index k) const { return this->VertexCount() + k; }

  /// Assembles the matrix. Throws Error when the mesh has degenerate triangles.
  Eigen::SparseMatrix<double> Assemble() const;

  /// Returns the gradient ∇Ψ + Σ q_k ∇η_k on every triangle: a column per triangle, two rows per
  /// column of `potentials`.
  Eigen::MatrixXd Gradient(const Eigen::MatrixXd& potentials) const;

  /// Returns the matrix times (Ψ, q): the sources of a potential.
  Eigen::VectorXd Apply(const Eigen::VectorXd& potential) const;

private:
  SharedTopology Topology;
  Eigen::Index IslandCount;
};
}
