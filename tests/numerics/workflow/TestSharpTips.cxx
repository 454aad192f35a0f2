// Sharp tips without valid quads are cut off.

#include "BoundaryCorners.h"
#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "SharpTips.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the inside of a profile with a cusp at (1, 0): y² = x (1 − x)³ / 50, vertices dense
/// there.
PlanarDomain Cusp()
{
  constexpr int Count = 80;
  Loop loop;
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * Pi * i / Count;
    const double x = 0.5 * (1.0 + std::cos(angle));
    const double y = std::sqrt(x * std::pow(1.0 - x, 3.0) / 50.0);
    loop.emplace_back(x, i < Count / 2 ? y : -y);
  }
  return MakePlanarDomain({ loop });
}

TEST(SharpTips, AreReplacedByAnEdge)
{
  const PlanarDomain domain = Cusp();
  QuadRequest request;
  request.sides = NameSides(domain);
  const std::vector<SideStart>& starts = request.sides.starts;
  const auto tip = std::find_if(
    starts.begin(), starts.end(), [](const SideStart& start) { return start.place.x() > 0.999; });
  ASSERT_NE(tip, starts.end());
  const std::optional<CutDomain> cut = CutSharpTips(domain, request, 0.01);
  ASSERT_TRUE(cut.has_value());
  EXPECT_NEAR(cut->domain.Area(), domain.Area(), 0.01 * 0.01);
  EXPECT_NE(cut->warning.find("(1, 0) was cut off"), std::string::npos) << cut->warning;
  const Loop& loop = cut->domain.loops[0];
  const SideStart& moved =
    cut->request.sides.starts[static_cast<std::size_t>(tip - starts.begin())];
  EXPECT_NE(std::find(loop.begin(), loop.end(), moved.place), loop.end());
  EXPECT_EQ(
    FindCorners(cut->domain.loops).size(), FindCorners(domain.loops).size() + 1); // two for one

  request.corners = { { { 1.0, 0.0 }, 2 } }; // a prescribed corner stays
  EXPECT_FALSE(CutSharpTips(domain, request, 0.01).has_value());
}

TEST(SharpTips, BetweenLongSegmentsAreCutOff)
{
  const PlanarDomain wedge = MakePlanarDomain({ { { 0.0, -0.05 }, { 1.0, 0.0 }, { 0.0, 0.05 } } });
  const std::optional<CutDomain> cut = CutSharpTips(wedge, {}, 0.1);
  ASSERT_TRUE(cut.has_value());
  const double cosine = 1.0 / std::sqrt(1.0 + 0.05 * 0.05);
  EXPECT_NEAR(cut->domain.Area(), wedge.Area() - 0.05 * 0.1 * 0.1 * cosine * cosine, 1e-15);
  EXPECT_FALSE(CutSharpTips(wedge, {}, 0.6).has_value()); // longer than a quarter of the boundary
}

TEST(SharpTips, LeaveValidQuads)
{
  QuadRequest request;
  request.quadCount = 300;
  const QuadWorkflowResult result = MakeQuadMesh(Cusp(), request);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.2);
}
}
}
