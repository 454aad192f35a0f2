#include "CanonicalFrame.h"
#include "PlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
std::vector<Loop> InFrame(const std::vector<Loop>& loops)
{
  return CanonicalFrame(loops).ToFrame(loops);
}

/// Expects that both domains have the same coordinates in their frames, relative to the first vertex.
void ExpectSameInFrames(const std::vector<Loop>& one, const std::vector<Loop>& other)
{
  const std::vector<Loop> a = InFrame(one);
  const std::vector<Loop> b = InFrame(other);
  const double tolerance = 1e-8 * PlanarDomain{ one }.Diagonal();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t l = 0; l < a.size(); ++l)
  {
    ASSERT_EQ(a[l].size(), b[l].size());
    for (std::size_t i = 0; i < a[l].size(); ++i)
    {
      EXPECT_LT(((a[l][i] - a[0][0]) - (b[l][i] - b[0][0])).norm(), tolerance);
    }
  }
}

const std::vector<Loop> LongBox = { { { 0.0, 0.0 }, { 5.0, 0.0 }, { 5.0, 3.0 }, { 0.0, 3.0 } } };
const std::vector<Loop> LShape = { { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 1.0 }, { 1.0, 1.0 },
  { 1.0, 2.0 }, { 0.0, 2.0 } } };

TEST(CanonicalFrame, MovesWithTheDomain)
{
  Random random(711);
  std::vector<std::vector<Loop>> domains = { LShape,
    { RegularPolygon(3), RegularPolygon(12, 0.1, Point(0.1, 0.2)) },
    { RegularPolygon(64), RegularPolygon(16, 0.1, Point(0.3, 0.0)) } };
  for (int i = 0; i < 20; ++i)
  {
    domains.push_back(RandomSmoothDomain(random).loops);
  }
  for (const std::vector<Loop>& loops : domains)
  {
    for (const double angle : { 0.3, 0.5 * Pi, 0.25 * Pi, 2.0, Pi, 4.4 })
    {
      const Similarity motion{ angle, 1.0, Point(random.Uniform(-9.0, 9.0), 3.0) };
      ExpectSameInFrames(loops, motion(loops));
      EXPECT_NEAR(PlanarDomain{ motion(loops) }.Diagonal(), PlanarDomain{ loops }.Diagonal(), 1e-8);
    }
  }
}

TEST(CanonicalFrame, DoesNotDependOnTheFirstVertex)
{
  Random random(712);
  for (int i = 0; i < 10; ++i)
  {
    std::vector<Loop> loops = RandomSmoothDomain(random).loops;
    const CanonicalFrame frame(loops);
    std::rotate(loops[0].begin(), loops[0].begin() + random.Integer(1, 60), loops[0].end());
    EXPECT_NEAR(WrapAngle(CanonicalFrame(loops).GetAngle() - frame.GetAngle()), 0.0, 1e-9);
  }
}

TEST(CanonicalFrame, HasTheAxesOfDomainsWithAxisParallelSides)
{
  for (const std::vector<Loop>& loops : { LongBox, LShape })
  {
    // Coordinates of quarter turns are exact.
    for (const Loop& loop : InFrame(loops))
    {
      for (const Point& point : loop)
      {
        EXPECT_EQ(point.x(), std::round(point.x()));
        EXPECT_EQ(point.y(), std::round(point.y()));
      }
    }
    EXPECT_EQ(PlanarDomain{ loops }.Diagonal(), BoundingDiagonal(loops));
  }
}

TEST(CanonicalFrame, InvertsItsCoordinates)
{
  const CanonicalFrame frame(Similarity{ 0.7, 3.0, Point(5.0, -2.0) }(LongBox));
  const Point point(1.25, 0.5);
  EXPECT_LT((frame.FromFrame(frame.ToFrame(point)) - point).norm(), 1e-12);
  EXPECT_FALSE(frame.IsIdentity());
  EXPECT_TRUE(CanonicalFrame().IsIdentity());
  EXPECT_EQ(CanonicalFrame().ToFrame(point), point);
}

TEST(CanonicalFrame, GivesTurnedSymmetricDomainsTheCoordinatesOfUnturnedOnes)
{
  // A square turned by any angle has four equal coordinates, up to the sign, despite rounding.
  const std::vector<Loop> square = { RegularPolygon(4, std::sqrt(2.0)) };
  for (const double angle : { 0.1, 0.2, 0.9 })
  {
    const std::vector<Loop> loops = InFrame(Similarity{ angle }(square));
    for (const Point& point : loops[0])
    {
      EXPECT_EQ(std::abs(point.x()), 1.0);
      EXPECT_EQ(std::abs(point.y()), 1.0);
    }
  }
}
}
}
