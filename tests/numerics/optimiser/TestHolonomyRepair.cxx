#include "HolonomyRepair.h"

#include "HolonomyCheck.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
Configuration TurnedRing(double turn)
{
  return Join(OnCircle(4, 0.8, 0.1, 1, 0.0), OnCircle(4, 0.55, 0.1 + turn, -1, 0.0));
}

double Largest(const std::vector<double>& defects)
{
  double largest = 0.0;
  for (const double defect : defects)
  {
    largest = std::max(largest, std::abs(defect));
  }
  return largest;
}

/// Returns the defect of a ring, Σ k_j arg b_j modulo 2π (docs/method.md §7.3).
double RingDefect(const Configuration& configuration)
{
  double sum = 0.0;
  for (const Singularity& singularity : configuration)
  {
    sum +=
      singularity.quarterIndex * std::atan2(singularity.position.y(), singularity.position.x());
  }
  return std::remainder(sum, 2.0 * Pi);
}
}

TEST(HolonomyRepair, FindsSmallestMoveOnRing)
{
  const PlanarDomain ring = RingOfEdges(0.05);
  for (const double turn : { 0.03, 0.1, -0.2 })
  {
    SCOPED_TRACE(turn);
    const Configuration given = TurnedRing(turn);
    const HolonomyRepair repair = RepairHolonomy(ring, given, {}, 0.1);
    EXPECT_GT(Largest(repair.before), 0.1);
    EXPECT_LE(Largest(repair.after), 1e-6);
    EXPECT_NEAR(RingDefect(repair.singularities), 0.0, 2e-3); // error of the mesh
    // The gradient of the defect at b_j is k_j e_θ / r_j, so to first order the smallest move is −d
    // (k_j / r_j) / Σ 1/r² along e_θ.
    const double defect = RingDefect(given);
    double squares = 0.0;
    for (const Singularity& singularity : given)
    {
      squares += 1.0 / singularity.position.squaredNorm();
    }
    double largest = 0.0;
    for (std::size_t j = 0; j < given.size(); ++j)
    {
      const Point& position = given[j].position;
      const Point tangent = Point(-position.y(), position.x()) / position.norm();
      const Point expected = -defect * given[j].quarterIndex / position.norm() / squares * tangent;
      const Point moved = repair.singularities[j].position - position;
      // The tolerance covers second-order terms of the move and the error of the mesh.
      EXPECT_LT((moved - expected).norm(), 2.0 * expected.squaredNorm() + 0.03 * expected.norm());
      EXPECT_EQ(repair.singularities[j].quarterIndex, given[j].quarterIndex);
      largest = std::max(largest, moved.norm());
    }
    EXPECT_EQ(repair.largestMove, largest);
  }
}

TEST(HolonomyRepair, RemovesDefectsOfTwoInnerLoops)
{
  const auto square = [](double x, double size)
  {
    return Loop{ { x - size, -size }, { x - size, size }, { x + size, size }, { x + size, -size } };
  };
  PlanarDomain plate;
  plate.loops = { { { -1.0, -0.5 }, { 1.0, -0.5 }, { 1.0, 0.5 }, { -1.0, 0.5 } },
    square(-0.5, 0.12), square(0.5, 0.12) };
  // Positions on the axis would have no defects, by symmetry.
  const Configuration given = { { { -0.8, 0.05 }, 1 }, { { -0.2, -0.04 }, -1 },
    { { 0.2, 0.06 }, -1 }, { { 0.8, 0.07 }, 1 } };
  const HolonomyRepair repair = RepairHolonomy(plate, given, {}, 0.06);
  ASSERT_EQ(repair.before.size(), 2U);
  EXPECT_GT(Largest(repair.before), 0.1);
  EXPECT_LE(Largest(repair.after), 1e-6);
  EXPECT_GT(repair.largestMove, 0.0);
  // The defect is small on another mesh as well.
  EXPECT_LT(Largest(HolonomyDefects(plate, repair.singularities)), 0.02);
}

TEST(HolonomyRepair, MovesNothingOrThrowsIfImpossible)
{
  const Configuration four = OnCircle(4, 0.6, 0.3, 1, 0.0);
  const HolonomyRepair none = RepairHolonomy(Builtin("disk", 0.1), four);
  EXPECT_EQ(none.largestMove, 0.0);
  EXPECT_TRUE(none.after.empty());
  // A rotated hole without singularities has a defect that nothing can change.
  PlanarDomain twisted;
  twisted.loops = { { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } },
    { { 0.3, 0.1 }, { 0.1, -0.3 }, { -0.3, -0.1 }, { -0.1, 0.3 } } };
  EXPECT_TRUE(Refuses([&] { RepairHolonomy(twisted, {}, {}, 0.1); },
    { "inner loop 1", "do not close up by 26.6°", "add a pair" }));
}
}
