#include "DissectedCholesky.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "P1Laplacian.h"
#include "Support.h"

#include <Eigen/Cholesky>

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

System Laplacian(const TriangleMesh& mesh)
{
  return { P1Stiffness(PlanarTopology(mesh)), InSpace(mesh.points) };
}

System RandomLaplacian(Random& random, double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  return Laplacian(DrillHoles(RandomSmoothDomain(random), {}, options));
}

std::vector<int> RandomUnknowns(Random& random, Eigen::Index size, int count, int except)
{
  std::vector<int> all(static_cast<std::size_t>(size));
  std::iota(all.begin(), all.end(), 0);
  all.erase(all.begin() + except);
  random.Shuffle(all);
  all.resize(static_cast<std::size_t>(count));
  return all;
}

/// Returns the matrix with the row and column of `ground` replaced by those of the identity.
Eigen::MatrixXd Grounded(const SparseMatrix& matrix, int ground)
{
  Eigen::MatrixXd dense = matrix;
  dense.row(ground).setZero();
  dense.col(ground).setZero();
  dense(ground, ground) = 1.0;
  return dense;
}

/// Compares solutions and the Schur complement with dense linear algebra.
void ExpectEqualsDense(
  const System& system, const std::vector<int>& last, int ground, Random& random)
{
  const DissectedCholesky factor(system.matrix, system.places, last, { ground });
  const Eigen::MatrixXd dense = Grounded(system.matrix, ground);
  const Eigen::MatrixXd inverse =
    dense.llt().solve(Eigen::MatrixXd::Identity(dense.rows(), dense.cols()));
  Eigen::MatrixXd load = RandomMatrix(random, dense.rows(), 3);
  const DissectedCholesky::Eliminated eliminated = factor.Eliminate(load);
  load.row(ground).setZero();
  const Eigen::MatrixXd expected = inverse * load;
  const Eigen::MatrixXd solution = factor.Substitute(eliminated);
  EXPECT_LE((solution - expected).norm(), 1e-11 * expected.norm());
  EXPECT_EQ(solution.row(ground).norm(), 0.0);

  // The Schur complement on the trailing unknowns is the inverse of their block of the inverse.
  const auto count = static_cast<Eigen::Index>(last.size());
  const Eigen::MatrixXd& lower = factor.GetTrailingFactor();
  ASSERT_EQ(lower.rows(), count);
  EXPECT_TRUE(lower.isLowerTriangular());
  Eigen::MatrixXd block(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j < count; ++j)
    {
      block(i, j) = inverse(last[static_cast<std::size_t>(i)], last[static_cast<std::size_t>(j)]);
    }
  }
  EXPECT_LE((lower * (lower.transpose() * block) - Eigen::MatrixXd::Identity(count, count)).norm(),
    1e-10 * (1.0 + static_cast<double>(count)));
}

TEST(DissectedCholesky, EqualsDenseLinearAlgebra)
{
  Random random(201);
  for (int trial = 0; trial < 12; ++trial)
  {
    const System system = RandomLaplacian(random, 0.15);
    const int ground = random.Integer(0, static_cast<int>(system.matrix.rows()) - 1);
    ExpectEqualsDense(system,
      RandomUnknowns(random, system.matrix.rows(), trial < 4 ? 0 : random.Integer(1, 40), ground),
      ground, random);
  }
}

TEST(DissectedCholesky, EqualsDenseLinearAlgebraOnTwoSheets)
{
  Random random(206);
  for (int trial = 0; trial < 4; ++trial)
  {
    // Two copies of a Laplacian, joined by springs at some points. Without springs each copy has
    // its own ground.
    const System sheet = RandomLaplacian(random, 0.15);
    const auto count = static_cast<int>(sheet.matrix.rows());
    System system;
    system.places = sheet.places;
    system.places.insert(system.places.end(), sheet.places.begin(), sheet.places.end());
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<int> partners;
    for (int i = 0; i < 2 * count; ++i)
    {
      partners.push_back((i + count) % (2 * count));
      for (SparseMatrix::InnerIterator entry(sheet.matrix, i % count); entry; ++entry)
      {
        entries.emplace_back(static_cast<int>(entry.row()) + i / count * count, i, entry.value());
      }
    }
    const auto spring = [&entries](int i, int j)
    {
      entries.insert(
        entries.end(), { { i, i, 1.0 }, { j, j, 1.0 }, { i, j, -1.0 }, { j, i, -1.0 } });
    };
    for (int k = 0; k < trial; ++k)
    {
      const int point = random.Integer(0, count - 1);
      spring(point, point + count);
    }
    entries.emplace_back(count, count, 1.0);
    system.matrix.resize(2 * count, 2 * count);
    system.matrix.setFromTriplets(entries.begin(), entries.end());
    const DissectedCholesky factor(system.matrix, system.places, {}, { 0 }, {}, partners);
    Eigen::MatrixXd load = RandomMatrix(random, 2 * count, 2);
    const Eigen::MatrixXd solution = factor.Substitute(factor.Eliminate(load));
    load.row(0).setZero();
    const Eigen::MatrixXd expected = Grounded(system.matrix, 0).llt().solve(load);
    EXPECT_LE((solution - expected).norm(), 1e-11 * expected.norm()) << trial;
  }
}

TEST(DissectedCholesky, HandlesSmallAndDisconnectedSystems)
{
  Random random(202);
  for (const int size : { 2, 3, 5, 17, 40 })
  {
    // Chains in which every second link is replaced by a spring to the ground.
    System system;
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i)
    {
      system.places.emplace_back(i, 0.1 * (i % 3), 0.0);
      entries.emplace_back(i, i, 3.0);
      if (i > 0 && i % 2 == 0)
      {
        entries.emplace_back(i, i - 1, -1.0);
        entries.emplace_back(i - 1, i, -1.0);
      }
    }
    system.matrix.resize(size, size);
    system.matrix.setFromTriplets(entries.begin(), entries.end());
    for (int count = 0; count < std::min(size, 6); ++count)
    {
      ExpectEqualsDense(system, RandomUnknowns(random, size, count, 0), 0, random);
    }
  }
}

TEST(DissectedCholesky, HandlesDisconnectedHalves)
{
  // A comb: each half of the cut is disconnected, and each of its parts has its own piece of the
  // separator.
  Loop comb;
  for (int tooth = 0; tooth < 4; ++tooth)
  {
    const double x = tooth;
    comb.insert(comb.end(), { { x, 0.0 }, { x, 4.0 }, { x + 0.5, 4.0 }, { x + 0.5, 0.0 } });
  }
  comb.insert(comb.end(), { { 3.5, -0.3 }, { 0.0, -0.3 } });
  DrillOptions options;
  options.meshSize = 0.2;
  Random random(203);
  const System system = Laplacian(DrillHoles(MakePlanarDomain({ comb }), {}, options));
  ExpectEqualsDense(system, RandomUnknowns(random, system.matrix.rows(), 25, 7), 7, random);
}

TEST(DissectedCholesky, RejectsSingularOrNonFiniteMatrices)
{
  Random random(204);
  const System system = RandomLaplacian(random, 0.2);
  const auto factor = [&](const SparseMatrix& matrix) {
    DissectedCholesky(matrix, system.places, { 3, 4 }, { 0 });
  };
  EXPECT_FALSE(Refuses([&] { factor(system.matrix); }, {}));
  for (const int unknown : { 1, 4, static_cast<int>(system.matrix.rows()) - 1 })
  {
    SparseMatrix matrix = system.matrix;
    matrix.coeffRef(unknown, unknown) *= -1.0;
    EXPECT_TRUE(Refuses([&] { factor(matrix); }, { "not positive definite" }));
    matrix.coeffRef(unknown, unknown) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(Refuses([&] { factor(matrix); }, { "not finite" }));
  }
}
}
}
