#include "DenseProduct.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
TEST(DenseProduct, MatchesEigenForSubmatricesAndEmptyMatrices)
{
  Random random(77);
  for (const Eigen::Index inner : { 0, 1, 5, 40 })
  {
    for (const Eigen::Index rows : { 0, 1, 7, 33 })
    {
      const Eigen::MatrixXd real =
        Eigen::MatrixXd::NullaryExpr(50, 50, [&] { return random.Uniform(-1.0, 1.0); });
      const Eigen::MatrixXcd complex =
        Eigen::MatrixXcd::NullaryExpr(50, 50, [&] { return random.Square(); });
      const Eigen::MatrixXd product =
        DenseProduct(real.block(2, 3, rows, inner), real.block(4, 5, inner, 9));
      EXPECT_LE(
        (product - real.block(2, 3, rows, inner) * real.block(4, 5, inner, 9)).norm(), 1e-13);
      const Eigen::MatrixXd ofReal =
        AdjointProduct(real.block(2, 3, inner, rows), real.block(4, 5, inner, 9));
      EXPECT_LE(
        (ofReal - real.block(2, 3, inner, rows).transpose() * real.block(4, 5, inner, 9)).norm(),
        1e-13);
      const Eigen::MatrixXcd ofComplex =
        AdjointProduct(complex.block(2, 3, inner, rows), complex.block(4, 5, inner, 9));
      EXPECT_LE(
        (ofComplex - complex.block(2, 3, inner, rows).adjoint() * complex.block(4, 5, inner, 9))
          .norm(),
        1e-13);
    }
  }
}
}
}
