#include "SymmetricAssembly.h"

#include <gtest/gtest.h>

#include <random>

namespace crossfield::test
{
namespace
{
TEST(SymmetricAssembly, AddsUpRepeatedEntries)
{
  constexpr int Size = 12;
  std::mt19937 random(5);
  std::uniform_int_distribution<int> index(0, Size - 1);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(Size, Size);
  Eigen::VectorXd diagonal(Size);
  for (int j = 0; j < Size; ++j)
  {
    diagonal[j] = value(random);
    expected(j, j) = diagonal[j];
  }
  std::vector<SymmetricEntry> entries;
  while (entries.size() < 200) // of 66 distinct pairs
  {
    const SymmetricEntry entry{ index(random), index(random), value(random) };
    if (entry.row != entry.column)
    {
      entries.push_back(entry);
      expected(entry.row, entry.column) += entry.value;
      expected(entry.column, entry.row) += entry.value;
    }
  }
  const Eigen::SparseMatrix<double> matrix = AssembleSymmetric(diagonal, entries);
  EXPECT_LE((Eigen::MatrixXd(matrix) - expected).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_TRUE(matrix.isCompressed());
  for (int column = 0; column < Size; ++column)
  {
    int before = -1;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
    {
      EXPECT_LT(before, entry.row());
      before = static_cast<int>(entry.row());
    }
  }
}

TEST(SymmetricAssembly, AcceptsEmptyInput)
{
  EXPECT_EQ(AssembleSymmetric(Eigen::VectorXd(), {}).nonZeros(), 0);
  const Eigen::SparseMatrix<double> matrix = AssembleSymmetric(Eigen::VectorXd::Ones(3), {});
  EXPECT_EQ(matrix.nonZeros(), 3);
  EXPECT_EQ(Eigen::MatrixXd(matrix), Eigen::MatrixXd::Identity(3, 3));
}
}
}
