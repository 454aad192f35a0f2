#include "LoopGap.h"

#include "MakePlanarDomain.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
TEST(LoopGap, IsTheDistanceToTheNearestLoop)
{
  const Loop box = { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 3.0 }, { 0.0, 3.0 } };
  const Loop square = { { 1.0, 1.0 }, { 1.5, 1.0 }, { 1.5, 1.5 }, { 1.0, 1.5 } };
  const Loop diamond = { { 2.5, 1.25 }, { 2.9, 0.85 }, { 3.3, 1.25 }, { 2.9, 1.65 } };
  const PlanarDomain domain = MakePlanarDomain({ box, square, diamond });
  EXPECT_NEAR(GapAround(domain, 0), 0.7, 1e-12);
  for (const std::size_t hole : { 1U, 2U })
  {
    // the square is as near to the box as to the corner of the diamond
    EXPECT_NEAR(GapAround(domain, hole), domain.loops[hole][0].x() < 2.0 ? 1.0 : 0.7, 1e-12);
  }
  EXPECT_TRUE(std::isinf(GapAround(MakePlanarDomain({ box }), 0)));
}
}
