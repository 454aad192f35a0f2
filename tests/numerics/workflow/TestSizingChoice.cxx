// Sizes of quads if none are requested: uniform as far as shapes stay good.

#include "SizingChoice.h"

#include "MakePlanarDomain.h"
#include "MeshGrade.h"
#include "QuadWorkflow.h"
#include "Support.h"

#include <algorithm>

namespace crossfield::test
{
namespace
{
/// Returns a plate with two holes of different size.
PlanarDomain Plate()
{
  return MakePlanarDomain({ { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 2.0 }, { 0.0, 2.0 } },
    RegularPolygon(32, 0.6, Point(1.0, 1.0)), RegularPolygon(32, 0.2, Point(3.0, 1.2)) });
}

bool HasEvent(const QuadWorkflowResult& result)
{
  return std::any_of(result.events.begin(), result.events.end(),
    [](const std::string& event) { return event.find("uniform sizes: the") != std::string::npos; });
}

QuadWorkflowResult Mesh(const PlanarDomain& domain, std::optional<Sizing> sizing, int count = 600)
{
  QuadRequest request;
  request.quadCount = count;
  request.sizing = sizing;
  return MakeQuadMesh(domain, request);
}

TEST(SizingChoice, MakesSizesUniformWhereShapesStayGood)
{
  const QuadWorkflowResult conformal = Mesh(Plate(), Sizing::Conformal);
  ASSERT_GT(conformal.quads.quality.variation, GoodVariation);
  const QuadWorkflowResult automatic = Mesh(Plate(), std::nullopt);
  EXPECT_LE(automatic.quads.quality.variation, GoodVariation);
  EXPECT_GE(automatic.quads.quality.jacobian.min, 0.8 * automatic.quads.quality.bound);
  EXPECT_TRUE(HasEvent(automatic));
  EXPECT_EQ(automatic.singularities.size(), conformal.singularities.size());
}

TEST(SizingChoice, RetainsAGoodConformalMesh)
{
  const PlanarDomain shape = Builtin("l-shape");
  const QuadWorkflowResult conformal = Mesh(shape, Sizing::Conformal);
  const QuadWorkflowResult automatic = Mesh(shape, std::nullopt);
  EXPECT_FALSE(HasEvent(automatic));
  ASSERT_EQ(automatic.quads.mesh.points.size(), conformal.quads.mesh.points.size());
  for (std::size_t p = 0; p < conformal.quads.mesh.points.size(); ++p)
  {
    EXPECT_EQ(automatic.quads.mesh.points[p].place, conformal.quads.mesh.points[p].place);
  }
}

TEST(SizingChoice, DoesNotMoveGivenSingularities)
{
  QuadRequest request;
  request.singularities = Mesh(Plate(), Sizing::Conformal).singularities;
  request.quadCount = 600;
  const QuadWorkflowResult result = MakeQuadMesh(Plate(), request);
  EXPECT_GT(result.quads.quality.variation, GoodVariation);
  EXPECT_LT(result.moved, 1e-9);
  EXPECT_FALSE(HasEvent(result));
}
}
}
