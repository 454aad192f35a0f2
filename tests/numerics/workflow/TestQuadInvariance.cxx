// A domain that is turned, scaled and shifted gives the same quads.

#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
/// A plate with two round holes, at none of whose angles the sides are parallel to the axes.
PlanarDomain Plate(Random& random)
{
  const double width = random.Uniform(2.0, 3.0);
  const Point second(random.Uniform(0.5, width - 0.5), 0.5);
  std::vector<Loop> loops = { { { 0.0, 0.0 }, { width, 0.0 }, { width, 2.0 }, { 0.0, 1.7 } },
    RegularPolygon(24, random.Uniform(0.15, 0.3), Point(0.6, 1.2)), RegularPolygon(24, 0.2, second) };
  return MakePlanarDomain(std::move(loops));
}

void ExpectSameQuads(const QuadWorkflowResult& result, const QuadWorkflowResult& expected)
{
  const QuadResult& quads = result.quads;
  EXPECT_EQ(quads.mesh.quads.size(), expected.quads.mesh.quads.size());
  EXPECT_EQ(quads.blocks.blocks.size(), expected.quads.blocks.blocks.size());
  EXPECT_EQ(result.singularities.size(), expected.singularities.size());
  EXPECT_NEAR(quads.quality.jacobian.min, expected.quads.quality.jacobian.min, 0.01);
  EXPECT_NEAR(quads.quality.variation, expected.quads.quality.variation, 0.01);
}

TEST(QuadInvariance, MotionsAndScalesGiveTheSameQuads)
{
  Random random(1010);
  for (int i = 0; i < 6; ++i)
  {
    const PlanarDomain domain = i % 2 == 0 ? Plate(random) : RandomSmoothDomain(random, 60);
    QuadRequest request;
    request.quadCount = 300;
    const QuadWorkflowResult expected = MakeQuadMesh(MakePlanarDomain(domain.loops), request);
    for (const double angle : { 0.4, 2.1 })
    {
      SCOPED_TRACE("domain " + std::to_string(i) + " turned by " + std::to_string(angle));
      const Similarity motion{ angle, 2.7, Point(3.0, -8.0) };
      ExpectSameQuads(MakeQuadMesh(MakePlanarDomain(motion(domain.loops)), request), expected);
    }
  }
}
}
}
