#pragma once

#include "DenseCholesky.h"

#include <vector>

namespace crossfield
{
/// Cholesky factorisation M = L Lᴴ of a Hermitian block matrix whose blocks are coupled through
/// their last unknowns only (BlockMatrix). The inner unknowns of each block are eliminated
/// separately, which leaves a dense Schur complement on the coupled unknowns. The cost is the cube
/// of the number of coupled unknowns, not of the number of rows.
///
/// Scalar is double or std::complex<double>.
template <typename Scalar>
class BlockCholesky
{
public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /// Constructs the factor of an empty matrix.
  BlockCholesky() = default;

  /// Factors the matrix. `blocks` are Hermitian. The last `coupled[i]` unknowns of block i are
  /// coupled through `coupling`; only its lower triangle is read.
  BlockCholesky(
    const std::vector<Matrix>& blocks, const std::vector<Eigen::Index>& coupled, Matrix coupling);

  /// Returns whether M is positive definite; all other functions require it.
  bool IsPositiveDefinite() const { return this->PositiveDefinite; }

  /// Returns log det M.
  double LogDeterminant() const;

  /// Returns M⁻¹ B.
  Matrix Solve(const Matrix& rightHandSides) const;

  /// Returns v_iᴴ (M⁻¹)_ij v_j for all blocks i and j, where v_i is the part of v in block i.
  Matrix Forms(const Vector& vector) const;

  /// Derivatives of log det M with respect to t_i when t_i A_i is added to every block i: the first
  /// ones, tr((M⁻¹)_ii A_i), and minus the second ones, tr((M⁻¹)_ij A_j (M⁻¹)_ji A_i). `forms` are
  /// the Forms of a vector, which come at no extra cost.
  struct Traces
  {
    Eigen::VectorXd first;
    Eigen::MatrixXd second;
    Matrix forms;
  };
  Traces ComputeTraces(const std::vector<Matrix>& changes, const Vector& vector) const;

private:
  /// Factor of one block, [ inner 0 ; across . ]. The coupled unknowns of all blocks are factored
  /// together.
  struct Block
  {
    Matrix inner;
    Matrix across;
    Eigen::Index row = 0;   ///< Row of the first inner unknown in M.
    Eigen::Index place = 0; ///< Index of the first coupled unknown among all coupled unknowns.
  };

  /// Eliminates the inner unknowns. Replaces their rows of `columns` by those of L⁻¹ B and returns
  /// the reduced right-hand side on the coupled unknowns, to which their factor is not yet applied.
  template <typename Columns>
  Columns Eliminate(Columns& columns) const;

  /// Result of eliminating the part of a vector in each block separately: the reduced vector on the
  /// coupled unknowns of the block, and the sum of squares on its inner unknowns.
  struct Separate
  {
    Vector ofCoupled;
    Eigen::VectorXd squares;
  };
  Separate EliminateSeparately(const Vector& vector) const;

  std::vector<Block> Blocks;
  DenseCholesky<Scalar> Coupled;
  bool PositiveDefinite = true;
};

extern template class BlockCholesky<double>;
extern template class BlockCholesky<std::complex<double>>;
}
