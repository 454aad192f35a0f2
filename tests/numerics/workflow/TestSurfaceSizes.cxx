#include "Support.h"
#include "SurfaceQuadWorkflow.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
double MeanSize(const QuadWorkflowResult& result, double area)
{
  return std::sqrt(area / static_cast<double>(result.quads.mesh.quads.size()));
}

TEST(SurfaceSizes, FollowTheChordErrorOnASphere)
{
  const SurfaceMesh sphere = CubedSphere(32);
  for (const double error : { 0.01, 0.0025 })
  {
    SurfaceRequest request;
    request.quadCount = 0;
    request.sizes.chordError = error;
    const QuadWorkflowResult result = MakeQuadsOfSurface(sphere, request);
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_NEAR(MeanSize(result, 4.0 * Pi), std::sqrt(4.0 * error), 0.1 * std::sqrt(4.0 * error));
    EXPECT_LE(result.quads.quality.surface->maximumDistance, 1.1 * error);
    EXPECT_GT(result.quads.quality.surface->maximumDistance, 0.7 * error);
    ASSERT_TRUE(result.sizes);
    EXPECT_GT(result.sizes->AreaShare(), 0.9);
  }
}

TEST(SurfaceSizes, GrowAwayFromAPlace)
{
  SurfaceRequest request;
  request.quadSize = 0.2;
  request.sizes.near = { { { 0.0, 0.0, 1.0 }, 0.05, 0.1 } };
  const QuadWorkflowResult result = MakeQuadsOfSurface(CubedSphere(16), request);
  ASSERT_TRUE(result.sizes);
  ASSERT_EQ(result.sizes->sets.size(), 1u);
  EXPECT_NEAR(result.sizes->sets.front().Median(), 1.0, 0.35);
  SurfaceRequest plain = request;
  plain.sizes = {};
  const QuadWorkflowResult without = MakeQuadsOfSurface(CubedSphere(16), plain);
  EXPECT_GT(result.quads.mesh.quads.size(), without.quads.mesh.quads.size());
}

TEST(SurfaceSizes, MayBeEqualAndGiveANumber)
{
  SurfaceRequest request;
  request.quadCount = 700;
  const QuadWorkflowResult conformal = MakeQuadsOfSurface(Can(8), request);
  request.sizes.isUniform = true;
  const QuadWorkflowResult uniform = MakeQuadsOfSurface(Can(8), request);
  EXPECT_NEAR(static_cast<double>(uniform.quads.mesh.quads.size()), 700.0, 35.0);
  EXPECT_EQ(uniform.quads.mesh.EulerCharacteristic(), 2);
  EXPECT_LE(uniform.quads.quality.variation, conformal.quads.quality.variation);
  EXPECT_GT(uniform.quads.quality.jacobian.min, 0.5);
}

TEST(SurfaceSizes, AreThoseOfAFunction)
{
  SurfaceRequest request;
  request.quadSize = 1.0;
  request.sizes.length = [](const SpacePoint& place) { return place.z() > 0.0 ? 0.1 : 0.2; };
  const QuadWorkflowResult result = MakeQuadsOfSurface(Can(16), request);
  double above = 0.0;
  double below = 0.0;
  for (const auto& quad : result.quads.mesh.quads)
  {
    double z = 0.0;
    for (const int point : quad)
    {
      z += result.quads.mesh.points[static_cast<std::size_t>(point)].place.z();
    }
    (z > 0.0 ? above : below) += 1.0;
  }
  EXPECT_GT(above, 1.4 * below); // around the wall there are equally many
}

TEST(SurfaceSizes, AreEqualOnBothSidesOfLines)
{
  // Sizes of the wall of the can are limited by those of its lid.
  const SurfaceMesh can = Can(8);
  SurfaceSizes sizes;
  sizes.near = { { { 0.0, 0.0, 1.0 }, 0.02, 0.0 } };
  const SurfaceTopology whole(can);
  const SurfaceTargets targets = ResolveSizes(whole, {}, {}, {}, sizes, 10.0, 0);
  for (int vertex = 0; vertex < whole.VertexCount(); ++vertex)
  {
    const SpacePoint place = whole.PositionOf(vertex);
    const double along = std::abs(place.z()) > 1.0 - 1e-9
      ? place.head<2>().norm() + (place.z() > 0.0 ? 0.0 : 4.0 - 2.0 * place.head<2>().norm())
      : 1.0 + 1.0 - place.z();
    EXPECT_NEAR(targets.sizes[vertex], 0.02 + std::log(1.25) * along, 0.03);
  }
}

TEST(SurfaceSizes, MayBePrescribedForSides)
{
  SurfaceRequest request;
  request.quadCount = 300;
  request.sides = { { "outer0", 40, 0.0 } };
  const auto edgesOf = [](const QuadWorkflowResult& result, const std::string& name)
  {
    int edges = 0;
    for (const QuadBoundaryEdge& edge : result.quads.mesh.boundary)
    {
      edges += result.quads.mesh.sideNames[static_cast<std::size_t>(edge.side)] == name ? 1 : 0;
    }
    return edges;
  };
  const SurfaceMesh half = Hemisphere(16);
  QuadWorkflowResult result = MakeQuadsOfSurface(half, request);
  EXPECT_EQ(edgesOf(result, "outer0"), 40);
  EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), 1);
  // Both circles of the can together.
  request.sides = { { "features", 80, 0.0 } };
  result = MakeQuadsOfSurface(Can(16), request);
  EXPECT_EQ(edgesOf(result, "features"), 80);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.4);
  // Sizes at the boundary, from which they grow.
  request = {};
  request.quadSize = 0.2;
  request.sides = { { "outer0", 0, 0.1 } };
  result = MakeQuadsOfSurface(half, request);
  EXPECT_NEAR(edgesOf(result, "outer0"), 2.0 * Pi / 0.1, 0.2 * 2.0 * Pi / 0.1);
  request.sides = { { "rim", 0, 0.1 } };
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(half, request); }, { "rim", "outer0" }));
  request = {};
  request.sides = { { "outer0", 41, 0.0 } }; // odd
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(half, request); }, { "outer0:41" }));
}

TEST(SurfaceSizes, AreRefused)
{
  const SurfaceMesh sphere = CubedSphere(4);
  SurfaceRequest request;
  request.sizes.chordError = -1.0;
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(sphere, request); }, { "chord error must be" }));
  request.sizes = {};
  request.sizes.near = { { SpacePoint::Zero(), -2.0, 0.0 } };
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(sphere, request); }, { "The size near (0, 0, 0)" }));
  request.sizes = {};
  request.sizes.isUniform = true;
  request.sizes.growth = 0.9;
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(sphere, request); }, { "growth", "above 1" }));
}
}
}
