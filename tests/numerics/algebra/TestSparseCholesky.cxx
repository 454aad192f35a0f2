#include "DrillHoles.h"
#include "NestedDissection.h"
#include "SparseCholesky.h"
#include "Support.h"

#include <Eigen/Cholesky>

#include <limits>
#include <numeric>

namespace crossfield::test
{
namespace
{
struct System
{
  SparseMatrix matrix;
  std::vector<SpacePoint> places;
};

/// Returns the stiffness matrix of a random mesh plus a random mass on some of its edges.
System RandomSystem(Random& random, double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  const int pointCount = static_cast<int>(6.0 / meshSize);
  const TriangleMesh mesh = DrillHoles(RandomSmoothDomain(random, pointCount), {}, options);
  const EdgeNumbering edges = NumberEdges(mesh);
  System system;
  system.matrix = CrouzeixRaviartStiffness(mesh, edges);
  for (int e = 0; e < edges.Count(); ++e)
  {
    system.places.push_back(InSpace(Midpoint(mesh, edges, e)));
    if (e % 5 == 0)
    {
      system.matrix.coeffRef(e, e) += random.Uniform(0.0, 3.0);
    }
  }
  system.matrix.makeCompressed();
  return system;
}

std::vector<int> Natural(Eigen::Index count)
{
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

Eigen::MatrixXd TrailingSchurComplement(const SparseCholesky& factor, int count)
{
  const Eigen::MatrixXd lower = factor.TrailingFactor(count);
  EXPECT_TRUE(lower.isLowerTriangular());
  return lower * lower.transpose();
}

TEST(SparseCholesky, SolvesInAnyOrder)
{
  Random random(14);
  for (int trial = 0; trial < 8; ++trial)
  {
    const System system = RandomSystem(random, 0.06);
    const Eigen::Index n = system.matrix.rows();
    std::vector<int> shuffled = Natural(n);
    random.Shuffle(shuffled);
    const Eigen::MatrixXd expected = RandomMatrix(random, n, 3);
    const Eigen::MatrixXd rightHandSides = system.matrix * expected;
    for (const std::vector<int>& order :
      { NestedDissection(system.matrix, system.places), Natural(n), shuffled })
    {
      const Eigen::MatrixXd solution = SparseCholesky(system.matrix, order).Solve(rightHandSides);
      EXPECT_LE((system.matrix * solution - rightHandSides).norm(), 1e-12 * rightHandSides.norm());
      EXPECT_LE((solution - expected).norm(), 1e-8 * expected.norm());
    }
  }
}

TEST(SparseCholesky, SchurComplementEqualsTheDenseComputation)
{
  Random random(15);
  for (int trial = 0; trial < 6; ++trial)
  {
    const System system = RandomSystem(random, 0.15);
    const int n = static_cast<int>(system.matrix.rows());
    for (const int count : { 0, 1, 7, 40 })
    {
      SCOPED_TRACE(count);
      std::vector<int> last = Natural(n);
      random.Shuffle(last);
      last.resize(static_cast<std::size_t>(count));
      const std::vector<int> order = NestedDissection(system.matrix, system.places, last);
      Eigen::MatrixXd dense(n, n);
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
        {
          dense(i, j) = system.matrix.coeff(order[i], order[j]);
        }
      }
      const int rest = n - count;
      const Eigen::MatrixXd coupling = dense.topRightCorner(rest, count);
      const Eigen::MatrixXd expected = dense.bottomRightCorner(count, count) -
        coupling.transpose() * dense.topLeftCorner(rest, rest).llt().solve(coupling);
      const Eigen::MatrixXd schur =
        TrailingSchurComplement(SparseCholesky(system.matrix, order), count);
      ASSERT_EQ(schur.rows(), count);
      ASSERT_EQ(schur.cols(), count);
      EXPECT_LE((schur - expected).norm(), 1e-11 * (1.0 + expected.norm()));
    }
  }
}

TEST(SparseCholesky, SchurComplementOfEverythingIsTheMatrixItself)
{
  Random random(16);
  const Eigen::MatrixXd root = RandomMatrix(random, 30, 30);
  const Eigen::MatrixXd dense = root * root.transpose() + Eigen::MatrixXd::Identity(30, 30);
  const SparseCholesky factor(dense.sparseView(), Natural(30));
  EXPECT_LE((TrailingSchurComplement(factor, 30) - dense).norm(), 1e-12 * dense.norm());
}

TEST(SparseCholesky, KeepsTheOrderOfADisconnectedMatrix)
{
  // Two disconnected chains: a postorder would move the last unknowns of both.
  constexpr int Half = 20;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < 2 * Half; ++i)
  {
    entries.emplace_back(i, i, 3.0 + 0.1 * i);
    if (i >= 2)
    {
      entries.emplace_back(i, i - 2, -1.0);
      entries.emplace_back(i - 2, i, -1.0);
    }
  }
  SparseMatrix matrix(2 * Half, 2 * Half);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd dense = matrix;
  for (const int count : { 2, 3, 8 })
  {
    const int rest = 2 * Half - count;
    const Eigen::MatrixXd coupling = dense.topRightCorner(rest, count);
    const Eigen::MatrixXd expected = dense.bottomRightCorner(count, count) -
      coupling.transpose() * dense.topLeftCorner(rest, rest).llt().solve(coupling);
    const Eigen::MatrixXd schur =
      TrailingSchurComplement(SparseCholesky(matrix, Natural(2 * Half)), count);
    EXPECT_LE((schur - expected).norm(), 1e-12) << count;
  }
}

TEST(SparseCholesky, RejectsIndefiniteMatrices)
{
  Random random(17);
  System system = RandomSystem(random, 0.3);
  const std::vector<int> order = NestedDissection(system.matrix, system.places);
  const int middle = order[order.size() / 2];
  const auto factor = [&] { SparseCholesky(system.matrix, order); };
  EXPECT_FALSE(Refuses(factor, {}));
  const double diagonal = system.matrix.coeff(middle, middle);
  // Matrices made indefinite by one entry, and one with a pivot that is exactly zero.
  system.matrix.coeffRef(middle, middle) = -diagonal;
  EXPECT_TRUE(Refuses(factor, { "not positive definite" }));
  SparseMatrix zero(3, 3);
  zero.insert(0, 0) = 1.0;
  zero.insert(1, 1) = 0.0;
  zero.insert(2, 2) = 1.0;
  zero.makeCompressed();
  EXPECT_TRUE(Refuses([&] { SparseCholesky(zero, Natural(3)); }, { "not positive definite" }));
}

TEST(SparseCholesky, RejectsNonFiniteEntries)
{
  Random random(18);
  const System system = RandomSystem(random, 0.3);
  const std::vector<int> order = NestedDissection(system.matrix, system.places);
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    SparseMatrix matrix = system.matrix;
    matrix.coeffRef(3, 3) = bad;
    EXPECT_TRUE(Refuses([&] { SparseCholesky(matrix, order); }, { "not finite" }));
    Eigen::VectorXd rightHandSide = Eigen::VectorXd::Ones(matrix.rows());
    rightHandSide[5] = bad;
    EXPECT_TRUE(Refuses(
      [&] { SparseCholesky(system.matrix, order).Solve(rightHandSide); }, { "not finite" }));
  }
}

TEST(SparseCholesky, RejectsOrdersOfTheWrongLength)
{
  Random random(19);
  const System system = RandomSystem(random, 0.3);
  std::vector<int> order = Natural(system.matrix.rows());
  order.pop_back();
  EXPECT_TRUE(Refuses([&] { SparseCholesky(system.matrix, order); }, { "order" }));
  EXPECT_TRUE(Refuses([&] { SparseCholesky(SparseMatrix(3, 4), Natural(3)); }, { "square" }));
}

TEST(SparseCholesky, RefactorEqualsAFirstFactorisation)
{
  Random random(11);
  const System system = RandomSystem(random, 0.2);
  const std::vector<int> order = NestedDissection(system.matrix, system.places);
  const Eigen::MatrixXd load = RandomMatrix(random, system.matrix.rows(), 3);
  SparseCholesky again(order);

  // The same places of entries, then more of them, and the first ones.
  SparseMatrix other = system.matrix;
  other.diagonal() *= 1.5;
  SparseMatrix more = other;
  more.coeffRef(0, other.rows() - 1) = 1e-3;
  more.coeffRef(other.rows() - 1, 0) = 1e-3;
  more.makeCompressed();
  for (const SparseMatrix& matrix : { other, more, system.matrix })
  {
    again.Refactor(matrix);
    EXPECT_EQ(again.Solve(load), SparseCholesky(matrix, order).Solve(load));
  }

  // An indefinite matrix leaves nothing behind.
  SparseMatrix indefinite = system.matrix;
  indefinite.diagonal() *= -1.0;
  EXPECT_THROW(again.Refactor(indefinite), NotPositiveDefinite);
  again.Refactor(other);
  EXPECT_EQ(again.Solve(load), SparseCholesky(other, order).Solve(load));
  other.coeffRef(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(again.Refactor(other), Error);
}
}
}
