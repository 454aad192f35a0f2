#include "DenseCholesky.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
template <typename Scalar>
class DenseCholeskyTest : public testing::Test
{
public:
  using Matrix = typename DenseCholesky<Scalar>::Matrix;

  Scalar Entry()
  {
    if constexpr (std::is_same_v<Scalar, Complex>)
    {
      return this->Numbers.Square();
    }
    else
    {
      return this->Numbers.Uniform(-1.0, 1.0);
    }
  }
  Matrix Dense(Eigen::Index rows, Eigen::Index columns)
  {
    return Matrix::NullaryExpr(rows, columns, [this] { return this->Entry(); });
  }

private:
  Random Numbers{ 211 };
};

using Scalars = testing::Types<double, Complex>;
TYPED_TEST_SUITE(DenseCholeskyTest, Scalars, ); // ISO C++ requires the last comma

TYPED_TEST(DenseCholeskyTest, FactorsAndSolves)
{
  for (const Eigen::Index size : { 0, 1, 2, 17, 130 })
  {
    const auto root = this->Dense(size, size);
    const typename TestFixture::Matrix matrix =
      root * root.adjoint() + TestFixture::Matrix::Identity(size, size);
    // Only the lower triangle is read.
    typename TestFixture::Matrix lowerHalf = matrix;
    lowerHalf.template triangularView<Eigen::StrictlyUpper>().setConstant(1e3);
    const DenseCholesky<TypeParam> factor(lowerHalf);
    ASSERT_TRUE(factor.IsPositiveDefinite());
    const auto& lower = factor.GetLower();
    EXPECT_TRUE(lower.isLowerTriangular());
    EXPECT_LE((lower * lower.adjoint() - matrix).norm(), 1e-13 * (1.0 + matrix.norm()));
    EXPECT_LE((factor.Inverse() * matrix - TestFixture::Matrix::Identity(size, size)).norm(),
      1e-11 * (1.0 + matrix.norm()));
    const typename TestFixture::Matrix expected = this->Dense(size, 3);
    EXPECT_LE((factor.Form(matrix * expected) - expected.adjoint() * matrix * expected).norm(),
      1e-12 * (1.0 + matrix.norm() * expected.squaredNorm()));
    EXPECT_LE((factor.Solve(matrix * expected) - expected).norm(), 1e-10 * (1.0 + expected.norm()));
  }
}

TYPED_TEST(DenseCholeskyTest, DetectsIndefiniteMatrices)
{
  for (const double last : { 0.0, -1e-3 })
  {
    typename TestFixture::Matrix matrix = TestFixture::Matrix::Identity(30, 30);
    matrix(29, 29) = last;
    EXPECT_FALSE(DenseCholesky<TypeParam>(matrix).IsPositiveDefinite());
  }
}
}
}
