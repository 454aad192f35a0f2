#include "Error.h"
#include "GramMatrix.h"
#include "GramSolve.h"
#include "Support.h"

#include <Eigen/Cholesky>

namespace crossfield::test
{
namespace
{
/// Three blocks of 4, 2 and 3 rows. V has rows with entries in one, two and all three of them.
struct Known
{
  GramMatrix matrix;
  Eigen::MatrixXd dense;
};

Known RandomMatrixOfBlocks(Random& random)
{
  const std::vector<Eigen::Index> sizes = { 4, 2, 3 };
  const std::vector<Eigen::Index> firsts = { 0, 4, 6 };
  Known known;
  known.dense = Eigen::MatrixXd::Zero(9, 9);
  std::vector<GramNode> nodes;
  for (const std::vector<int>& blocks :
    std::vector<std::vector<int>>{ { 0 }, { 1 }, { 2 }, { 0, 2 }, { 1, 2 }, { 0, 1, 2 } })
  {
    GramNode node;
    node.blocks = blocks;
    node.rows.resize(5, 0);
    Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(5, 9);
    for (const int block : blocks)
    {
      const Eigen::MatrixXd part = RandomMatrix(random, 5, sizes[block]);
      padded.middleCols(firsts[block], sizes[block]) = part;
      node.rows.conservativeResize(Eigen::NoChange, node.rows.cols() + part.cols());
      node.rows.rightCols(part.cols()) = part;
    }
    known.dense += padded.transpose() * padded;
    nodes.push_back(std::move(node));
  }
  known.matrix = GramMatrix(sizes, std::move(nodes));
  const Eigen::MatrixXd added = Eigen::MatrixXd::Identity(2, 2);
  known.matrix.AddToBlock(1, added);
  known.dense.block(4, 4, 2, 2) += added;
  return known;
}

TEST(GramMatrix, EqualsTheSumOfItsParts)
{
  Random random(700);
  const auto [matrix, dense] = RandomMatrixOfBlocks(random);
  EXPECT_EQ(matrix.BlockCount(), 3);
  EXPECT_EQ(matrix.Rows(), 9);
  // Rows with entries in a single block are stored in its diagonal block.
  EXPECT_EQ(matrix.Entries(), 16 + 4 + 9 + 5 * (7 + 5 + 9));
  EXPECT_LE((matrix.Dense() - dense).norm(), 1e-13 * dense.norm());
  EXPECT_NEAR(matrix.Trace(), dense.trace(), 1e-13 * dense.trace());
  EXPECT_LE((matrix.Block(2) - dense.bottomRightCorner(3, 3)).norm(), 1e-13 * dense.norm());
  const Eigen::MatrixXd columns = RandomMatrix(random, 9, 3);
  EXPECT_LE((matrix * columns - dense * columns).norm(), 1e-13 * (dense * columns).norm());
  Eigen::VectorXcd complex(9);
  complex.real() = columns.col(0);
  complex.imag() = columns.col(1);
  EXPECT_LE((matrix * complex - dense.cast<std::complex<double>>() * complex).norm(), 1e-12);

  Eigen::VectorXd couplings(9);
  for (Eigen::Index column = 0; column < 9; ++column)
  {
    const Eigen::Index first = column < 4 ? 0 : column < 6 ? 4 : 6;
    const Eigen::Index size = column < 4 ? 4 : column < 6 ? 2 : 3;
    couplings[column] =
      dense.col(column).squaredNorm() - dense.col(column).segment(first, size).squaredNorm();
  }
  EXPECT_LE((matrix.SquaredCouplings() - couplings).norm(), 1e-12 * couplings.norm());
}

TEST(GramMatrix, CongruenceMatchesTheDenseMatrix)
{
  Random random(701);
  const auto [matrix, dense] = RandomMatrixOfBlocks(random);
  const std::vector<Eigen::MatrixXd> bases = { RandomMatrix(random, 4, 2),
    RandomMatrix(random, 2, 0), RandomMatrix(random, 3, 3) };
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(9, 5);
  basis.topLeftCorner(4, 2) = bases[0];
  basis.bottomRightCorner(3, 3) = bases[2];
  const Eigen::MatrixXd expected = basis.transpose() * dense * basis;
  EXPECT_LE((matrix.Congruence(bases).Dense() - expected).norm(), 1e-13 * expected.norm());
}

TEST(GramMatrix, SquaresADenseRoot)
{
  Random random(702);
  const Eigen::MatrixXd root = RandomMatrix(random, 5, 5);
  const GramMatrix matrix({ 2, 3 }, root);
  EXPECT_LE((matrix.Dense() - root * root.transpose()).norm(), 1e-13);
  EXPECT_EQ(GramMatrix().Rows(), 0);
}

TEST(GramMatrix, ConjugateGradientsSolveToRounding)
{
  Random random(703);
  const auto [matrix, dense] = RandomMatrixOfBlocks(random);
  Eigen::MatrixXd loads = RandomMatrix(random, 9, 4);
  loads.col(2).setZero();
  const Eigen::MatrixXd solution = SolveGram(matrix, loads);
  EXPECT_LE((dense * solution - loads).norm(), 1e-11 * loads.norm());
  EXPECT_EQ(solution.col(2).norm(), 0.0);
  EXPECT_EQ(SolveGram({}, Eigen::MatrixXd(0, 3)).cols(), 3);
  // A matrix of rank one.
  const GramMatrix singular({ 2 }, Eigen::MatrixXd::Ones(2, 1));
  EXPECT_TRUE(
    Refuses([&] { SolveGram(singular, Eigen::MatrixXd::Identity(2, 2)); }, { "edges of holes" }));
}
}
}
