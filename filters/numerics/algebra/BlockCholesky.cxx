#include "BlockCholesky.h"

#include "DenseParts.h"
#include "Parts.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <complex>
#include <utility>

namespace crossfield
{
template <typename Scalar>
BlockCholesky<Scalar>::BlockCholesky(
  const std::vector<Matrix>& blocks, const std::vector<Eigen::Index>& coupled, Matrix coupling)
{
  Eigen::Index row = 0;
  Eigen::Index place = 0;
  this->Blocks.reserve(blocks.size());
  for (std::size_t i = 0; i < blocks.size() && this->PositiveDefinite; ++i)
  {
    const Eigen::Index last = coupled[i];
    const Eigen::Index first = blocks[i].rows() - last;
    Block block;
    block.row = row;
    block.place = place;
    const Eigen::LLT<Matrix> inner(blocks[i].topLeftCorner(first, first));
    this->PositiveDefinite = inner.info() == Eigen::Success;
    block.inner = inner.matrixL();
    block.across =
      inner.matrixL().solve(blocks[i].bottomLeftCorner(last, first).adjoint()).adjoint();
    coupling.block(place, place, last, last) =
      blocks[i].bottomRightCorner(last, last) - block.across * block.across.adjoint();
    row += blocks[i].rows();
    place += last;
    this->Blocks.push_back(std::move(block));
  }
  if (this->PositiveDefinite)
  {
    this->Coupled = DenseCholesky<Scalar>(std::move(coupling));
    this->PositiveDefinite = this->Coupled.IsPositiveDefinite();
  }
}

template <typename Scalar>
double BlockCholesky<Scalar>::LogDeterminant() const
{
  double sum = 2.0 * this->Coupled.GetLower().diagonal().real().array().log().sum();
  for (const Block& block : this->Blocks)
  {
    sum += 2.0 * block.inner.diagonal().real().array().log().sum();
  }
  return sum;
}

template <typename Scalar>
template <typename Columns>
Columns BlockCholesky<Scalar>::Eliminate(Columns& columns) const
{
  Columns ofCoupled(this->Coupled.GetLower().rows(), columns.cols());
  for (const Block& block : this->Blocks)
  {
    auto inner = columns.middleRows(block.row, block.inner.rows());
    block.inner.template triangularView<Eigen::Lower>().solveInPlace(inner);
    ofCoupled.middleRows(block.place, block.across.rows()) =
      columns.middleRows(block.row + block.inner.rows(), block.across.rows()) -
      block.across * inner;
  }
  return ofCoupled;
}

template <typename Scalar>
typename BlockCholesky<Scalar>::Matrix BlockCholesky<Scalar>::Solve(
  const Matrix& rightHandSides) const
{
  Matrix solution = rightHandSides;
  const Matrix ofCoupled = this->Coupled.Solve(this->Eliminate(solution));
  for (const Block& block : this->Blocks)
  {
    const auto last = ofCoupled.middleRows(block.place, block.across.rows());
    auto inner = solution.middleRows(block.row, block.inner.rows());
    inner -= block.across.adjoint() * last;
    block.inner.template triangularView<Eigen::Lower>().adjoint().solveInPlace(inner);
    solution.middleRows(block.row + block.inner.rows(), block.across.rows()) = last;
  }
  return solution;
}

template <typename Scalar>
typename BlockCholesky<Scalar>::Separate BlockCholesky<Scalar>::EliminateSeparately(
  const Vector& vector) const
{
  Vector inner = vector;
  Separate result{ this->Eliminate(inner), Eigen::VectorXd(this->Blocks.size()) };
  Eigen::Index i = 0;
  for (const Block& block : this->Blocks)
  {
    result.squares[i++] = inner.segment(block.row, block.inner.rows()).squaredNorm();
  }
  return result;
}

template <typename Scalar>
typename BlockCholesky<Scalar>::Matrix BlockCholesky<Scalar>::Forms(const Vector& vector) const
{
  const Separate separate = this->EliminateSeparately(vector);
  Matrix columns = Matrix::Zero(separate.ofCoupled.size(), separate.squares.size());
  Eigen::Index i = 0;
  for (const Block& block : this->Blocks)
  {
    columns.col(i++).segment(block.place, block.across.rows()) =
      separate.ofCoupled.segment(block.place, block.across.rows());
  }
  Matrix forms = this->Coupled.Form(std::move(columns));
  forms.diagonal() += separate.squares;
  return forms;
}

template <typename Scalar>
typename BlockCholesky<Scalar>::Traces BlockCholesky<Scalar>::ComputeTraces(
  const std::vector<Matrix>& changes, const Vector& vector) const
{
  // (M⁻¹)_ij = T_i G_ij T_jᴴ, where G is the inverse on the coupled unknowns and T_i = [ −L⁻ᴴ
  // acrossᴴ ; 1 ]. A diagonal block has the inverse on its inner unknowns in addition.
  const auto count = static_cast<Eigen::Index>(this->Blocks.size());
  const Matrix inverse = this->Coupled.Inverse();
  Matrix product(inverse.rows(), inverse.cols()); // G_ij Tᴴ A_j T
  const Separate separate = this->EliminateSeparately(vector);
  Traces traces{ Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Zero(count, count),
    Matrix(count, count) };
  const auto add = [&](Eigen::Index j)
  {
    const Block& block = this->Blocks[j];
    const Matrix& change = changes[j];
    const Eigen::Index first = block.inner.rows();
    const Eigen::Index last = block.across.rows();
    const auto lower = block.inner.template triangularView<Eigen::Lower>();
    Matrix extension(first + last, last);
    extension.topRows(first) = -lower.adjoint().solve(block.across.adjoint());
    extension.bottomRows(last).setIdentity();
    Matrix own =
      extension * inverse.block(block.place, block.place, last, last) * extension.adjoint();
    const Matrix root = lower.solve(Matrix::Identity(first, first));
    own.topLeftCorner(first, first) += root.adjoint() * root;
    const Matrix ofOwn = own * change;
    traces.first[j] = std::real(ofOwn.trace());
    traces.second(j, j) = std::real(ofOwn.cwiseProduct(ofOwn.transpose()).sum());
    product.middleCols(block.place, last) =
      inverse.middleCols(block.place, last) * (extension.adjoint() * change * extension);
    const Vector response =
      inverse.middleCols(block.place, last) * separate.ofCoupled.segment(block.place, last);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const Block& other = this->Blocks[i];
      const Eigen::Index size = other.across.rows();
      traces.forms(i, j) =
        separate.ofCoupled.segment(other.place, size).dot(response.segment(other.place, size));
    }
    traces.forms(j, j) += separate.squares[j];
  };
  ForRanges(
    count,
    [&](int begin, int end)
    {
      for (Eigen::Index j = begin; j < end; ++j)
      {
        add(j);
      }
    },
    inverse.rows() >= MinimumRowsForParts ? 1 : count + 1);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    const Block& right = this->Blocks[j];
    for (Eigen::Index i = 0; i < j; ++i)
    {
      const Block& left = this->Blocks[i];
      const Eigen::Index rows = left.across.rows();
      const Eigen::Index columns = right.across.rows();
      traces.second(i, j) = traces.second(j, i) =
        std::real(product.block(left.place, right.place, rows, columns)
                    .cwiseProduct(product.block(right.place, left.place, columns, rows).transpose())
                    .sum());
    }
  }
  return traces;
}

template class BlockCholesky<double>;
template class BlockCholesky<std::complex<double>>;
}
