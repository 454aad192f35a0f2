#include "CleanBlocks.h"

#include "MeshGrade.h"
#include "QuadWorkflow.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// A smooth domain with threefold lobes that are not symmetric.
PlanarDomain Blob()
{
  Loop loop;
  for (int i = 0; i < 160; ++i)
  {
    const double t = 2.0 * Pi * i / 160;
    const double radius = 1.0 + 0.25 * std::cos(3.0 * t + 0.4) + 0.12 * std::cos(5.0 * t + 1.1);
    loop.push_back(radius * Point(std::cos(t), std::sin(t)));
  }
  return { { loop } };
}

TEST(CleanBlocks, BlobHasAThirdOfTheBlocks)
{
  QuadRequest request;
  request.sizing = Sizing::Conformal; // other sizes move the nodes
  const QuadWorkflowResult before = MakeQuadMesh(Blob(), request);
  EXPECT_EQ(before.blocks.none, static_cast<int>(before.quads.blocks.blocks.size()));
  EXPECT_FALSE(before.blocks.clean);
  request.merge = BlockMerge::Clean;
  const QuadWorkflowResult after = MakeQuadMesh(Blob(), request);
  EXPECT_EQ(after.blocks.none, before.blocks.none);
  EXPECT_EQ(after.blocks.clean, static_cast<int>(after.quads.blocks.blocks.size()));
  EXPECT_LE(3 * *after.blocks.clean, *after.blocks.none); // measured: 14 of 53
  EXPECT_TRUE(IsAsClean(after.quads, before.quads, request.quadSize, request.quadCount));
  EXPECT_EQ(after.singularities.size(), before.singularities.size());
  EXPECT_EQ(after.events.size(), before.events.size() + 1);
  // The irregular points of the mesh are the singularities of the result.
  for (const QuadPoint& point : after.quads.mesh.points)
  {
    if (point.cone >= 0 && point.curve.loop < 0)
    {
      double nearest = 1.0;
      for (const Singularity& singularity : after.singularities)
      {
        nearest = std::min(nearest, (singularity.position - point.InPlane()).norm());
      }
      EXPECT_LT(nearest, 1e-6);
    }
  }
}

TEST(CleanBlocks, NothingToMergeChangesNothing)
{
  QuadRequest request;
  request.quadSize = 0.1;
  const PlanarDomain domain = Builtin("l-shape", 0.25);
  const QuadWorkflowResult before = MakeQuadMesh(domain, request);
  request.merge = BlockMerge::Clean;
  const QuadWorkflowResult after = MakeQuadMesh(domain, request);
  EXPECT_EQ(after.blocks.clean, after.blocks.none);
  ASSERT_EQ(after.quads.mesh.points.size(), before.quads.mesh.points.size());
  for (std::size_t p = 0; p < after.quads.mesh.points.size(); ++p)
  {
    EXPECT_EQ(after.quads.mesh.points[p].place, before.quads.mesh.points[p].place);
  }
}

TEST(CleanBlocks, CoarseReportsAllNumbers)
{
  QuadRequest request;
  request.sizing = Sizing::Conformal; // others may move the nodes to where few blocks are left
  request.merge = BlockMerge::Coarse;
  const QuadWorkflowResult result = MakeQuadMesh(Blob(), request);
  ASSERT_TRUE(result.blocks.none && result.blocks.clean && result.blocks.coarse);
  EXPECT_LE(*result.blocks.coarse, *result.blocks.clean);
  EXPECT_LT(*result.blocks.coarse, *result.blocks.none);
}
}
}
