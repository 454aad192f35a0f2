#include "BlockCholesky.h"
#include "BlockMatrix.h"
#include "Support.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
template <typename Scalar>
Scalar RandomScalar(Random& random);
template <>
double RandomScalar<double>(Random& random)
{
  return random.Uniform(-1.0, 1.0);
}
template <>
Complex RandomScalar<Complex>(Random& random)
{
  return random.Square();
}

/// Blocks of 1 to 6 unknowns, of which none, some or all are coupled, and the equivalent dense
/// matrix.
template <typename Scalar>
struct BlockProblem
{
  using Matrix = typename BlockCholesky<Scalar>::Matrix;
  std::vector<Matrix> blocks;
  std::vector<Matrix> changes; ///< Hermitian matrices of the size of the blocks.
  std::vector<Eigen::Index> coupled;
  std::vector<Eigen::Index> rows;
  Matrix coupling;
  Matrix dense;

  BlockProblem(Random& random, double diagonal)
  {
    Eigen::Index size = 0;
    std::vector<Eigen::Index> coupledRows;
    for (int block = 0; block < 5; ++block)
    {
      const Eigen::Index count = random.Integer(1, 6);
      this->coupled.push_back(random.Integer(0, static_cast<int>(count)));
      this->rows.push_back(size);
      size += count;
      const auto hermitian = [&]
      {
        const Matrix any =
          Matrix::NullaryExpr(count, count, [&] { return RandomScalar<Scalar>(random); });
        return Matrix(any + any.adjoint());
      };
      this->blocks.push_back(hermitian());
      this->blocks.back().diagonal().array() += diagonal;
      this->changes.push_back(hermitian());
      for (Eigen::Index j = count - this->coupled.back(); j < count; ++j)
      {
        coupledRows.push_back(this->rows.back() + j);
      }
    }
    this->dense = Matrix::Zero(size, size);
    const auto total = static_cast<Eigen::Index>(coupledRows.size());
    this->coupling = Matrix::Zero(total, total);
    for (Eigen::Index j = 0; j < total; ++j)
    {
      for (Eigen::Index i = 0; i < j; ++i)
      {
        const Eigen::Index row = coupledRows[static_cast<std::size_t>(i)];
        const Eigen::Index column = coupledRows[static_cast<std::size_t>(j)];
        const auto blockOf = [&](Eigen::Index at)
        { return std::upper_bound(this->rows.begin(), this->rows.end(), at); };
        if (blockOf(row) != blockOf(column))
        {
          const Scalar value = RandomScalar<Scalar>(random);
          this->dense(row, column) = this->coupling(i, j) = value;
          this->dense(column, row) = this->coupling(j, i) = Eigen::numext::conj(value);
        }
      }
    }
    for (std::size_t i = 0; i < this->blocks.size(); ++i)
    {
      this->Part(this->dense, i, i) = this->blocks[i];
    }
  }

  auto Part(Matrix& of, std::size_t i, std::size_t j) const
  {
    return of.block(this->rows[i], this->rows[j], this->blocks[i].rows(), this->blocks[j].rows());
  }
};

template <typename Scalar>
class BlockCholeskyOf : public testing::Test
{
};
using Scalars = testing::Types<double, Complex>;
TYPED_TEST_SUITE(BlockCholeskyOf, Scalars);

TYPED_TEST(BlockCholeskyOf, MatchesTheDenseMatrix)
{
  using Problem = BlockProblem<TypeParam>;
  using Matrix = typename Problem::Matrix;
  Random random(610);
  for (int trial = 0; trial < 50; ++trial)
  {
    SCOPED_TRACE(trial);
    Problem problem(random, 20.0);
    const BlockCholesky<TypeParam> factor(problem.blocks, problem.coupled, problem.coupling);
    ASSERT_TRUE(factor.IsPositiveDefinite());
    const Eigen::Index size = problem.dense.rows();
    const Matrix columns =
      Matrix::NullaryExpr(size, 3, [&] { return RandomScalar<TypeParam>(random); });
    EXPECT_LE((problem.dense * factor.Solve(columns) - columns).norm(), 1e-13 * columns.norm());
    EXPECT_NEAR(factor.LogDeterminant(), std::log(std::real(problem.dense.determinant())), 1e-11);

    Matrix inverse = problem.dense.inverse();
    const Matrix forms = factor.Forms(columns.col(0));
    const auto traces = factor.ComputeTraces(problem.changes, columns.col(0));
    for (std::size_t i = 0; i < problem.blocks.size(); ++i)
    {
      const auto part = [&](std::size_t k)
      { return columns.col(0).segment(problem.rows[k], problem.blocks[k].rows()); };
      const auto row = static_cast<Eigen::Index>(i);
      EXPECT_NEAR(traces.first[row],
        std::real((problem.Part(inverse, i, i) * problem.changes[i]).trace()), 1e-13);
      for (std::size_t j = 0; j < problem.blocks.size(); ++j)
      {
        const auto column = static_cast<Eigen::Index>(j);
        EXPECT_NEAR(
          std::abs(forms(row, column) - part(i).dot(problem.Part(inverse, i, j) * part(j))), 0.0,
          1e-13);
        EXPECT_NEAR(std::abs(traces.forms(row, column) - forms(row, column)), 0.0, 1e-13);
        EXPECT_NEAR(traces.second(row, column),
          std::real((problem.Part(inverse, i, j) * problem.changes[j] *
            problem.Part(inverse, j, i) * problem.changes[i])
                      .trace()),
          1e-13);
      }
    }
  }
}

TYPED_TEST(BlockCholeskyOf, DetectsIndefiniteMatrices)
{
  Random random(611);
  int definite = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    SCOPED_TRACE(trial);
    const BlockProblem<TypeParam> problem(random, random.Uniform(0.0, 12.0));
    const bool expected =
      Eigen::LLT<typename BlockProblem<TypeParam>::Matrix>(problem.dense).info() == Eigen::Success;
    EXPECT_EQ(BlockCholesky<TypeParam>(problem.blocks, problem.coupled, problem.coupling)
                .IsPositiveDefinite(),
      expected);
    definite += expected ? 1 : 0;
  }
  EXPECT_GT(definite, 20);
  EXPECT_LT(definite, 180);
}

TEST(BlockMatrix, MultipliesLikeTheDenseMatrix)
{
  Random random(612);
  const BlockProblem<double> problem(random, 1.0);
  const BlockMatrix matrix{ problem.blocks, problem.coupled, problem.coupling };
  ASSERT_EQ(matrix.Rows(), problem.dense.rows());
  EXPECT_NEAR(matrix.Trace(), problem.dense.trace(), 1e-13);
  const Eigen::MatrixXcd columns =
    Eigen::MatrixXcd::NullaryExpr(matrix.Rows(), 2, [&] { return random.Square(); });
  EXPECT_LE((matrix * columns - problem.dense * columns).norm(), 1e-13);
}
}
}
