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
  EXPECT_LE(automatic.quads.quality.variation, conformal.quads.quality.variation);
  EXPECT_GE(automatic.quads.quality.jacobian.min, 0.8 * automatic.quads.quality.bound);
  // Of several meshes, one with more uniform sizes may be worse by what is not seen.
  EXPECT_GE(automatic.quads.quality.jacobian.min, conformal.quads.quality.jacobian.min - 0.03);
  EXPECT_LE(automatic.quads.blocks.blocks.size(), conformal.quads.blocks.blocks.size());
  EXPECT_EQ(automatic.singularities.size(), conformal.singularities.size());
}

TEST(SizingChoice, ArcsWithoutEdgesAreThoseOfOneLayout)
{
  // Blocks that are merged in place belong to another layout, whose arcs have other numbers.
  for (const BlockMerge merge : { BlockMerge::Clean, BlockMerge::Coarse })
  {
    QuadRequest request;
    request.quadCount = 600;
    request.merge = merge;
    const QuadWorkflowResult merged = MakeQuadMesh(Plate(), request);
    EXPECT_EQ(merged.quads.quality.inverted, 0);
    EXPECT_LE(static_cast<int>(merged.quads.blocks.blocks.size()), *merged.blocks.none);
  }
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

/// Returns a ring with singularities at places whose conformal sizes vary by a factor of hundreds.
QuadRequest WildRing()
{
  QuadRequest request;
  request.quadCount = 800;
  request.singularities = Configuration{ { { 0.7, 0.1 }, 1 }, { { -0.7, 0.0 }, -1 },
    { { 0.1, 0.72 }, 1 }, { { 0.05, -0.75 }, -1 } };
  return request;
}

PlanarDomain Ring()
{
  return MakePlanarDomain({ RegularPolygon(96, 1.0), RegularPolygon(64, 0.4) });
}

TEST(SizingChoice, MakesSizesUniformAroundGivenSingularities)
{
  QuadRequest request = WildRing();
  request.sizing = Sizing::Conformal;
  const QuadWorkflowResult conformal = MakeQuadMesh(Ring(), request);
  EXPECT_TRUE(std::any_of(conformal.warnings.begin(), conformal.warnings.end(),
    [](const std::string& warning)
    { return warning.find("area of the quads") != std::string::npos; }));
  request.sizing.reset();
  const QuadWorkflowResult result = MakeQuadMesh(Ring(), request);
  EXPECT_LT(result.quads.quality.variation, 0.5 * conformal.quads.quality.variation);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.6);
  EXPECT_LT(AreaError(result.quads), AcceptableAreaError);
  EXPECT_TRUE(HasEvent(result));
  EXPECT_TRUE(result.warnings.empty());
  // Shapes and sizes are good without moves.
  ASSERT_TRUE(result.moves);
  EXPECT_TRUE(result.moves->empty());
}

TEST(SizingChoice, HoldsSingularitiesOnRequest)
{
  QuadRequest request = WildRing();
  request.sizing = Sizing::Uniform;
  const QuadWorkflowResult released = MakeQuadMesh(Ring(), request);
  ASSERT_TRUE(released.moves);
  ASSERT_FALSE(released.moves->empty());
  for (const SingularityMove& move : *released.moves)
  {
    EXPECT_EQ(move.from, (*request.singularities)[move.row].position);
    EXPECT_EQ(move.to, released.singularities[move.row].position);
  }
  request.hold = true;
  request.merge = BlockMerge::Clean;
  const QuadWorkflowResult held = MakeQuadMesh(Ring(), request);
  EXPECT_TRUE(held.moves->empty());
  EXPECT_LT(held.moved, 1e-9);
  EXPECT_EQ(held.quads.quality.inverted, 0);
  request.repairHolonomy = true;
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(Ring(), request); }, { "--hold", "--repair-holonomy" }));
}
}
}
