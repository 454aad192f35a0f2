#include "DenseCholesky.h"
#include "DenseParts.h"
#include "Support.h"

#include <omp.h>

#include <array>

namespace crossfield::test
{
namespace
{
template <typename Scalar>
using Matrix = typename DenseCholesky<Scalar>::Matrix;

/// Returns a Hermitian matrix with eigenvalues of about one.
template <typename Scalar>
Matrix<Scalar> RandomDefinite(Random& random, Eigen::Index size)
{
  const Matrix<Scalar> root = Matrix<Scalar>::NullaryExpr(size, size,
    [&]
    {
      if constexpr (std::is_same_v<Scalar, double>)
      {
        return random.Uniform(-1.0, 1.0);
      }
      else
      {
        return random.Square();
      }
    });
  Matrix<Scalar> matrix = root * root.adjoint() / static_cast<double>(size);
  matrix.diagonal().array() += 0.5;
  return matrix;
}

template <typename Scalar>
class DensePartsOf : public testing::Test
{
};
using Scalars = testing::Types<double, Complex>;
TYPED_TEST_SUITE(DensePartsOf, Scalars);

// Sizes near multiples of the panel width, with remainders of one and odd remainders, and above the
// size from which DenseCholesky uses these functions.
constexpr std::array<Eigen::Index, 7> Sizes = { 1, 2, 191, 193, 385, 512, 601 };

TYPED_TEST(DensePartsOf, FactorAndInverseMatchTheMatrix)
{
  Random random(620);
  for (const Eigen::Index size : Sizes)
  {
    SCOPED_TRACE(size);
    const Matrix<TypeParam> matrix = RandomDefinite<TypeParam>(random, size);
    Matrix<TypeParam> lower = matrix.template triangularView<Eigen::Lower>();
    ASSERT_TRUE(FactorInParts<TypeParam>(lower, lower.cols()));
    lower.template triangularView<Eigen::StrictlyUpper>().setZero();
    EXPECT_LE((lower * lower.adjoint() - matrix).norm(), 1e-13 * matrix.norm());
    if (size > 1)
    {
      InvertInParts<TypeParam>(lower);
      const Matrix<TypeParam> inverse = lower.template selfadjointView<Eigen::Lower>();
      EXPECT_LE((inverse * matrix - Matrix<TypeParam>::Identity(size, size)).norm(),
        1e-13 * static_cast<double>(size));
    }
  }
}

TYPED_TEST(DensePartsOf, DetectsIndefiniteMatrices)
{
  Random random(621);
  const Matrix<TypeParam> matrix = RandomDefinite<TypeParam>(random, 601);
  for (const Eigen::Index row : { 0, 191, 192, 400, 600 })
  {
    SCOPED_TRACE(row);
    Matrix<TypeParam> indefinite = matrix;
    indefinite(row, row) -= 10.0;
    EXPECT_FALSE(FactorInParts<TypeParam>(indefinite, indefinite.cols()));
  }
}

TYPED_TEST(DensePartsOf, IsIdenticalInOneThread)
{
  Random random(622);
  const Matrix<TypeParam> matrix = RandomDefinite<TypeParam>(random, 700);
  const Matrix<TypeParam> columns = RandomDefinite<TypeParam>(random, 700).leftCols(31);
  const DenseCholesky<TypeParam> two(matrix);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const DenseCholesky<TypeParam> one(matrix);
  const Matrix<TypeParam> inverse = one.Inverse();
  const Matrix<TypeParam> form = one.Form(columns);
  omp_set_num_threads(threads);
  EXPECT_EQ(two.GetLower(), one.GetLower());
  EXPECT_EQ(two.Inverse(), inverse);
  EXPECT_EQ(two.Form(columns), form);
}
}
}
