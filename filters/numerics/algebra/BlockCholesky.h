#pragma once

#include "DenseCholesky.h"

#include <vector>

namespace crossfield
{
/// Cholesky factorisation M = L Lᴴ of a Hermitian matrix of blocks that are coupled by their last unknowns only
/// (BlockMatrix): the others of every block are eliminated by themselves, and a dense matrix is left on those that
/// are coupled. So it costs the cube of their number, not of the number of rows.
///
/// Scalar is double or std::complex<double>.
template <typename Scalar>
class BlockCholesky
{
public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /// Of an empty matrix.
  BlockCholesky() = default;

  /// `blocks` are Hermitian, the last `coupled[i]` unknowns of block i are coupled, by `coupling`, of which the lower
  /// half is read.
  BlockCholesky(
    const std::vector<Matrix>& blocks, const std::vector<Eigen::Index>& coupled, Matrix coupling);

  /// Without this the rest is undefined.
  bool IsPositiveDefinite() const { return this->PositiveDefinite; }

  /// log det M.
  double LogDeterminant() const;

  /// M⁻¹ B.
  Matrix Solve(const Matrix& rightHandSides) const;

  /// v_iᴴ (M⁻¹)_ij v_j for all blocks i and j, v_i the part of v in block i.
  Matrix Forms(const Vector& vector) const;

  /// What a change of M by t_i A_i in every block i does to log det M: its first derivatives tr((M⁻¹)_ii A_i), and
  /// minus its second ones, tr((M⁻¹)_ij A_j (M⁻¹)_ji A_i). And the forms of a vector, which cost nothing beside them.
  struct Traces
  {
    Eigen::VectorXd first;
    Eigen::MatrixXd second;
    Matrix forms;
  };
  Traces TracesOf(const std::vector<Matrix>& changes, const Vector& vector) const;

private:
  /// L of one block: [ inner 0 ; across . ]; the coupled unknowns come with those of the others.
  struct Block
  {
    Matrix inner;
    Matrix across;
    Eigen::Index row = 0;   ///< Of the first inner unknown in M,
    Eigen::Index place = 0; ///< and of the first coupled one among all that are coupled.
  };

  /// The part of the columns that belongs to the coupled unknowns after the others are eliminated, and in `inner` what
  /// is left of these: L⁻¹ B without its last step.
  template <typename Columns>
  Columns Eliminate(Columns& columns) const;

  /// The parts of a vector, each as if it were alone: what is left of it on the coupled unknowns of its block, and the sum
  /// of the squares on the others.
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
