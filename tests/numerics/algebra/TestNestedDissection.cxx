#include "DrillHoles.h"
#include "NestedDissection.h"
#include "Support.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <numeric>

namespace crossfield::test
{
namespace
{
std::vector<SpacePoint> Midpoints(const TriangleMesh& mesh, const EdgeNumbering& edges)
{
  std::vector<SpacePoint> places;
  for (int e = 0; e < edges.Count(); ++e)
  {
    places.push_back(InSpace(Midpoint(mesh, edges, e)));
  }
  return places;
}

bool IsPermutation(std::vector<int> order, std::size_t count)
{
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  std::sort(order.begin(), order.end());
  return order == all;
}

/// Returns the five-point Laplacian on a grid and stores the grid points in `places`.
SparseMatrix Grid(int side, std::vector<SpacePoint>& places)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < side * side; ++i)
  {
    places.emplace_back(i % side, i / side, 0.0);
    entries.emplace_back(i, i, 4.0);
    for (const int j : { (i + 1) % side != 0 ? i + 1 : -1, i + side < side * side ? i + side : -1 })
    {
      if (j >= 0)
      {
        entries.emplace_back(i, j, -1.0);
        entries.emplace_back(j, i, -1.0);
      }
    }
  }
  SparseMatrix matrix(side * side, side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::Index FactorEntries(const SparseMatrix& matrix, const std::vector<int>& order)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(matrix.rows());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    permutation.indices()[order[i]] = static_cast<int>(i);
  }
  SparseMatrix permuted;
  permuted = matrix.twistedBy(permutation);
  Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(permuted);
  return factor.matrixL().nestedExpression().nonZeros();
}

TEST(NestedDissection, ReturnsAPermutationWithTrailingUnknownsLast)
{
  Random random(12);
  for (int trial = 0; trial < 10; ++trial)
  {
    const PlanarDomain domain = RandomSmoothDomain(random);
    const TriangleMesh mesh = DrillHoles(domain, RandomHoles(random, domain, trial % 4));
    const EdgeNumbering edges = NumberEdges(mesh);
    const SparseMatrix matrix = CrouzeixRaviartStiffness(mesh, edges);
    std::vector<int> shuffled(edges.vertices.size());
    std::iota(shuffled.begin(), shuffled.end(), 0);
    random.Shuffle(shuffled);
    for (const int count : { 0, 1, 50, edges.Count() })
    {
      const std::vector<int> last(shuffled.begin(), shuffled.begin() + count);
      const std::vector<int> order = NestedDissection(matrix, Midpoints(mesh, edges), last);
      ASSERT_TRUE(IsPermutation(order, shuffled.size()));
      EXPECT_TRUE(std::equal(last.begin(), last.end(), order.end() - count));
    }
  }
}

TEST(NestedDissection, HandlesInseparableUnknowns)
{
  // All unknowns are at one position, and all are coupled to each other.
  const int count = 100;
  const SparseMatrix dense = Eigen::MatrixXd::Ones(count, count).sparseView();
  Random random(13);
  std::vector<SpacePoint> scattered;
  for (int i = 0; i < count; ++i)
  {
    scattered.emplace_back(random.Uniform(0.0, 1.0), random.Uniform(0.0, 1.0), 0.0);
  }
  EXPECT_TRUE(IsPermutation(NestedDissection(dense, scattered), count));
  const std::vector<SpacePoint> together(count, SpacePoint(1.0, 2.0, 0.0));
  EXPECT_TRUE(IsPermutation(NestedDissection(dense, together), count));
  SparseMatrix diagonal(count, count);
  diagonal.setIdentity();
  EXPECT_TRUE(IsPermutation(NestedDissection(diagonal, together), count));
  EXPECT_TRUE(NestedDissection(SparseMatrix(0, 0), {}).empty());
}

TEST(NestedDissection, KeepsTheFactorOfAGridSparse)
{
  // In row order the factor of a grid of n² points fills a band of n³ entries; nested dissection
  // needs about 8 n² log₂ n.
  constexpr int Side = 150;
  std::vector<SpacePoint> places;
  const SparseMatrix grid = Grid(Side, places);
  std::vector<int> rowByRow(places.size());
  std::iota(rowByRow.begin(), rowByRow.end(), 0);
  const auto band = static_cast<double>(FactorEntries(grid, rowByRow));
  EXPECT_GT(band, 0.9 * Side * Side * Side);
  const auto separated = static_cast<double>(FactorEntries(grid, NestedDissection(grid, places)));
  EXPECT_LT(separated, 8.0 * Side * Side * std::log2(Side));
  EXPECT_LT(separated, 0.4 * band);
}

/// Returns two copies of a sheet over the same points, where unknown i is below i + n, joined at
/// some points.
SparseMatrix TwoSheets(const SparseMatrix& sheet, const std::vector<int>& joined)
{
  const auto count = static_cast<int>(sheet.rows());
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < count; ++column)
  {
    for (SparseMatrix::InnerIterator entry(sheet, column); entry; ++entry)
    {
      const auto row = static_cast<int>(entry.row());
      entries.emplace_back(row, column, entry.value());
      entries.emplace_back(row + count, column + count, entry.value());
    }
  }
  for (const int point : joined)
  {
    entries.emplace_back(point, point + count, -1.0);
    entries.emplace_back(point + count, point, -1.0);
  }
  SparseMatrix matrix(2 * count, 2 * count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(NestedDissection, OrdersTheSheetsOfAMeshOneAfterTheOther)
{
  constexpr int Side = 60;
  std::vector<SpacePoint> places;
  const SparseMatrix grid = Grid(Side, places);
  const int count = Side * Side;
  places.insert(places.end(), places.begin(), places.begin() + count);
  std::vector<int> partners;
  for (int i = 0; i < 2 * count; ++i)
  {
    partners.push_back((i + count) % (2 * count));
  }
  // Two sheets that are not joined, and two that are joined at one corner.
  for (const std::vector<int>& joined : { std::vector<int>(), std::vector<int>{ 0, 1, Side } })
  {
    std::vector<int> order;
    int changes = 0; // between sheets, within leaves
    for (const DissectionPart& part : Dissect(TwoSheets(grid, joined), places, {}, {}, partners))
    {
      order.insert(order.end(), part.unknowns.begin(), part.unknowns.end());
      for (std::size_t i = 1; part.isLeaf && i < part.unknowns.size(); ++i)
      {
        changes += (part.unknowns[i] < count) != (part.unknowns[i - 1] < count) ? 1 : 0;
      }
    }
    EXPECT_TRUE(IsPermutation(order, 2 * static_cast<std::size_t>(count)));
    // Sheets that are not joined are leaves of their own; a disconnected part of joined ones changes
    // from one sheet to the other only once.
    EXPECT_LE(changes, joined.empty() ? 0 : 200);
    EXPECT_GE(changes, joined.empty() ? 0 : 2);
  }
}

TEST(NestedDissection, NumbersTheSeparatorAfterBothSides)
{
  // A chain of 101 points is split at its middle: the last unknown separates the two halves.
  constexpr int Count = 101;
  std::vector<SpacePoint> places;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < Count; ++i)
  {
    places.emplace_back(i, 0.0, 0.0);
    entries.emplace_back(i, i, 2.0);
    if (i > 0)
    {
      entries.emplace_back(i, i - 1, -1.0);
      entries.emplace_back(i - 1, i, -1.0);
    }
  }
  SparseMatrix chain(Count, Count);
  chain.setFromTriplets(entries.begin(), entries.end());
  const std::vector<int> order = NestedDissection(chain, places);
  EXPECT_NEAR(order.back(), 0.5 * (Count - 1), 1.0);
  // One side of the chain is ordered completely before the other side.
  const auto isLeft = [&](int unknown) { return unknown < order.back(); };
  EXPECT_TRUE(std::is_partitioned(order.begin(), order.end() - 1, isLeft) ||
    std::is_partitioned(order.begin(), order.end() - 1, [&](int u) { return !isLeft(u); }));
}
}
}
