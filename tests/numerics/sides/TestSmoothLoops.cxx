// Loops without corners keep enough edges to show their shape.

#include "SmoothLoops.h"

#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>

namespace crossfield::test
{
namespace
{
int EdgesAround(const QuadMesh& mesh, int loop)
{
  return static_cast<int>(std::count_if(mesh.boundary.begin(), mesh.boundary.end(),
    [loop](const QuadBoundaryEdge& edge) { return edge.id == loop; }));
}

QuadWorkflowResult Mesh(const PlanarDomain& domain, std::optional<Sizing> sizing)
{
  QuadRequest request;
  request.quadCount = 1000;
  request.sizing = sizing;
  return MakeQuadMesh(domain, request);
}

TEST(SmoothLoops, ASmallCircleInAFarFieldHasAnOGrid)
{
  const PlanarDomain domain =
    MakePlanarDomain({ RegularPolygon(96, 20.0), RegularPolygon(64, 0.5) });
  for (const std::optional<Sizing> sizing : { std::optional<Sizing>(), { Sizing::Conformal } })
  {
    const QuadWorkflowResult result = Mesh(domain, sizing);
    EXPECT_TRUE(result.singularities.empty());
    EXPECT_GT(result.quads.quality.jacobian.min, 0.98);
    EXPECT_GE(EdgesAround(result.quads.mesh, 1), 12);
  }
}

TEST(SmoothLoops, ASmallCircleInAPlateHasTwelveEdges)
{
  const PlanarDomain domain =
    MakePlanarDomain({ { { -10.0, -10.0 }, { 10.0, -10.0 }, { 10.0, 10.0 }, { -10.0, 10.0 } },
      RegularPolygon(64, 0.5, Point(1.0, 0.5)) });
  for (const std::optional<Sizing> sizing : { std::optional<Sizing>(), { Sizing::Conformal } })
  {
    const QuadWorkflowResult result = Mesh(domain, sizing);
    EXPECT_EQ(result.quads.quality.inverted, 0);
    EXPECT_GT(result.quads.quality.jacobian.min, 0.7);
    EXPECT_GE(EdgesAround(result.quads.mesh, 1), 12);
  }
}

TEST(SmoothLoops, PrescribedNumbersAreMet)
{
  QuadRequest request;
  const PlanarDomain domain =
    MakePlanarDomain({ { { -10.0, -10.0 }, { 10.0, -10.0 }, { 10.0, 10.0 }, { -10.0, 10.0 } },
      RegularPolygon(64, 1.0) });
  request.sideRequests = { CountOf("hole0", 8) };
  EXPECT_EQ(EdgesAround(MakeQuadMesh(domain, request).quads.mesh, 1), 8);
}
}
}
