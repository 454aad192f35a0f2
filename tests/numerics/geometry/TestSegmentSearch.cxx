#include "SegmentSearch.h"

#include "DomainQueries.h"
#include "MakePlanarDomain.h"
#include "Segment.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns a square with six round holes, whose loops have more sides than one group.
PlanarDomain Perforated()
{
  std::vector<Loop> loops = { { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 0, 2 } } };
  for (int hole = 0; hole < 6; ++hole)
  {
    Loop circle;
    for (int i = 0; i < 37; ++i)
    {
      const double angle = 2.0 * Pi * i / 37.0;
      circle.push_back(
        Point(0.5 + hole % 3, 0.5 + hole / 3) + 0.3 * Point(std::cos(angle), std::sin(angle)));
    }
    loops.push_back(circle);
  }
  return MakePlanarDomain(loops);
}

TEST(SegmentSearch, FindsTheNearestSegmentAndTheSignedDistance)
{
  Random random(7301);
  const PlanarDomain domain = Perforated();
  std::vector<SegmentSearch::Segment> sides;
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      sides.push_back({ loop[i], loop[(i + 1) % loop.size()] });
    }
  }
  const SegmentSearch search(domain);
  int inside = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    const Point point(random.Uniform(-0.5, 3.5), random.Uniform(-0.5, 2.5));
    EXPECT_EQ(search.SignedDistance(point), SignedDistance(point, domain));
    inside += search.SignedDistance(point) > 0.0 ? 1 : 0;
    std::size_t nearest = 0;
    const auto distance = [&](std::size_t i)
    { return OffsetFromSegment(point, sides[i][0], sides[i][1]).squaredNorm(); };
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      nearest = distance(i) < distance(nearest) ? i : nearest;
    }
    EXPECT_EQ(search.Find(point).segment, nearest);
    EXPECT_EQ(search.At(nearest), sides[nearest]);
  }
  EXPECT_GT(inside, 200);
  EXPECT_LT(inside, 1800);
}

TEST(SegmentSearch, ReturnsTheFirstOfSeveralNearestSegments)
{
  const SegmentSearch search(PlanarDomain{ { { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } } });
  EXPECT_EQ(search.Find({ 0.5, 0.5 }).segment, 0U);
  EXPECT_EQ(search.Find({ 2.0, 0.0 }).segment, 0U); // at the vertex of two sides
  EXPECT_EQ(search.Find({ 0.5, 0.75 }).segment, 2U);
}
}
}
