#include "PartialCholesky.h"
#include "SparseCholesky.h"
#include "Support.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
/// A sparse positive definite matrix with `size` rows of random entries.
Eigen::SparseMatrix<double> RandomDefinite(Random& random, int size)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i)
  {
    entries.emplace_back(i, i, 20.0);
    for (int k = 0; k < 3 && i > 0; ++k)
    {
      const int j = random.Integer(0, i - 1);
      const double value = random.Uniform(-1.0, 1.0);
      entries.emplace_back(i, j, value);
      entries.emplace_back(j, i, value);
    }
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(PartialCholesky, EqualsDenseElimination)
{
  Random random(710);
  for (const int size : { 1, 2, 30, 200 })
  {
    for (const int border : { 0, 1, 17 })
    {
      SCOPED_TRACE(std::to_string(size) + " and " + std::to_string(border));
      const Eigen::SparseMatrix<double> matrix = RandomDefinite(random, size + border);
      const Eigen::SparseMatrix<double> lower = matrix.triangularView<Eigen::Lower>();
      Eigen::MatrixXd update = Eigen::MatrixXd::Zero(border, border);
      const PartialCholesky factor(lower, size, update);

      // 1. The update of the border.
      const Eigen::MatrixXd dense = matrix;
      const Eigen::MatrixXd inner = dense.topLeftCorner(size, size);
      const Eigen::MatrixXd across = dense.bottomLeftCorner(border, size);
      const Eigen::MatrixXd l = inner.llt().matrixL();
      const Eigen::MatrixXd m =
        l.triangularView<Eigen::Lower>().solve(across.transpose()).transpose();
      const Eigen::MatrixXd expected = (-m * m.transpose()).eval().triangularView<Eigen::Lower>();
      const Eigen::MatrixXd found = update.triangularView<Eigen::Lower>();
      EXPECT_LE((found - expected).norm(), 1e-13 * (1.0 + expected.norm()));

      // 2. Both substitutions, for one column and for several.
      for (const int columns : { 1, 5 })
      {
        const Eigen::MatrixXd load = Eigen::MatrixXd::NullaryExpr(
          size + border, columns, [&] { return random.Uniform(-1.0, 1.0); });
        Eigen::MatrixXd down = load;
        factor.SolveLower(down);
        const Eigen::MatrixXd y = l.triangularView<Eigen::Lower>().solve(load.topRows(size));
        EXPECT_LE((down.topRows(size) - y).norm(), 1e-12);
        EXPECT_LE((down.bottomRows(border) - (load.bottomRows(border) - m * y)).norm(), 1e-12);
        Eigen::MatrixXd up = load;
        factor.SolveUpper(up);
        const Eigen::MatrixXd right = load.topRows(size) - m.transpose() * load.bottomRows(border);
        EXPECT_LE(
          (up.topRows(size) - l.transpose().triangularView<Eigen::Upper>().solve(right)).norm(),
          1e-12);
        EXPECT_EQ(up.bottomRows(border), load.bottomRows(border));
      }

      // 3. A sparse right-hand side.
      Eigen::SparseMatrix<double> sparse(size, 2);
      sparse.insert(size / 2, 0) = 1.0;
      sparse.insert(size - 1, 1) = -2.0;
      sparse.makeCompressed();
      Eigen::MatrixXd atBorder = Eigen::MatrixXd::Zero(border, 2);
      Eigen::MatrixXd solved = Eigen::MatrixXd::Zero(size, 2);
      for (const PartialCholesky::Rows& rows : factor.SolveLowerSparse(sparse, atBorder))
      {
        solved.middleRows(rows.first, rows.values.rows()) = rows.values;
      }
      const Eigen::MatrixXd all = l.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd(sparse));
      EXPECT_LE((solved - all).norm(), 1e-13);
      EXPECT_LE((atBorder + m * all).norm(), 1e-13);
    }
  }
}

TEST(PartialCholesky, RejectsIndefiniteAndNonFiniteMatrices)
{
  Random random(711);
  Eigen::SparseMatrix<double> lower = RandomDefinite(random, 50).triangularView<Eigen::Lower>();
  Eigen::MatrixXd update = Eigen::MatrixXd::Zero(10, 10);
  lower.coeffRef(45, 45) = -1.0; // in the border, which is not read
  EXPECT_NO_THROW(PartialCholesky(lower, 40, update));
  const double last = lower.coeff(39, 39);
  lower.coeffRef(39, 39) = -1.0; // the last inner unknown
  EXPECT_THROW(PartialCholesky(lower, 40, update), NotPositiveDefinite);
  lower.coeffRef(39, 39) = last;
  lower.coeffRef(30, 30) = -1.0;
  EXPECT_THROW(PartialCholesky(lower, 40, update), NotPositiveDefinite);
  lower.coeffRef(30, 30) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PartialCholesky(lower, 40, update), Error);
}
}
}
