// Nodes at requested places.

#include "HeldNodes.h"

#include "Error.h"
#include "QuadWorkflow.h"
#include "Support.h"

#include <algorithm>
#include <random>

namespace crossfield::test
{
namespace
{
const PlanarDomain Square{ { { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } } };

TEST(HeldNodes, AreAtRandomPlacesInsideAndOnTheBoundary)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0.02, 0.98);
  for (int i = 0; i < 20; ++i)
  {
    QuadRequest request;
    request.quadCount = 200;
    request.nodes = { { coordinate(random), coordinate(random) }, { coordinate(random), 0.0 } };
    const QuadWorkflowResult result = MakeQuadMesh(Square, request);
    for (const Point& place : request.nodes)
    {
      EXPECT_TRUE(std::any_of(result.quads.mesh.points.begin(), result.quads.mesh.points.end(),
        [&place](const QuadPoint& point) { return (point.InPlane() - place).norm() < 1e-9; }))
        << place.transpose();
    }
    EXPECT_EQ(result.quads.quality.inverted, 0);
    EXPECT_GT(result.quads.quality.jacobian.min, 0.5);
    EXPECT_EQ(DescribeMissedPlaces(request.nodes, result.quads.mesh), "");
  }
}

TEST(HeldNodes, SingularitiesStayWherePointsOfSidesMove)
{
  const PlanarDomain disk = MakePlanarDomain({ RegularPolygon(64) });
  QuadRequest request;
  request.quadCount = 300;
  request.hold = true;
  request.singularities = Configuration{ { { 0.5, 0.5 }, 1 }, { { -0.5, 0.5 }, 1 },
    { { -0.5, -0.5 }, 1 }, { { 0.5, -0.5 }, 1 } };
  request.sideRequests.resize(1);
  request.sideRequests[0].side = "outer0";
  request.sideRequests[0].size = 0.05;
  const QuadWorkflowResult result = MakeQuadMesh(disk, request);
  EXPECT_LT(result.moved, 1e-12);
  EXPECT_EQ(result.quads.quality.inverted, 0);
}

TEST(HeldNodes, PlacesOutsideAreRefused)
{
  QuadRequest request;
  request.quadCount = 200;
  request.nodes = { { 3.0, 0.5 } };
  EXPECT_THROW(MakeQuadMesh(Square, request), Error);
}
}
}
