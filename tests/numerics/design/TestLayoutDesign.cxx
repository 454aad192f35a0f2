#include "LayoutDesign.h"

#include "DomainQueries.h"
#include "Error.h"
#include "FactorisationCount.h"
#include "Layouts.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
Configuration Four(double radius, double turn)
{
  Configuration configuration;
  for (int i = 0; i < 4; ++i)
  {
    const double angle = turn + 0.5 * Pi * i;
    configuration.push_back({ radius * Point(std::cos(angle), std::sin(angle)), 1 });
  }
  return configuration;
}

TEST(LayoutDesign, MatchesLayoutOnSeparateMesh)
{
  const PlanarDomain disk = Builtin("disk", 0.05);
  const FactoredDomain factored(disk, {}, 0.05);
  Random random(8);
  for (int i = 0; i < 40; ++i)
  {
    Configuration configuration = Four(random.Uniform(0.35, 0.75), random.Uniform(-Pi, Pi));
    for (Singularity& singularity : configuration)
    {
      singularity.position += Point(random.Uniform(-0.1, 0.1), random.Uniform(-0.1, 0.1));
    }
    const LayoutDesign live = DesignLayout(factored, configuration);
    const TMesh& tMesh = live.layouts.Single().tMesh;
    const TMesh separate = LayOutOn(disk, configuration, {}, 0.05).tMesh;
    EXPECT_EQ(tMesh.patches.size(), separate.patches.size()) << i;
    EXPECT_NEAR(tMesh.longest, separate.longest, 0.02) << i;
    EXPECT_LT(tMesh.Mismatch(), 1e-12);
  }
}

TEST(LayoutDesign, LiveMeshSizeLimitsTriangles)
{
  const PlanarDomain disk = Builtin("disk", 0.05);
  EXPECT_EQ(LiveMeshSize(disk, 0.1), 0.1) << "a coarse mesh size is kept";
  const double live = LiveMeshSize(disk, 0.001);
  EXPECT_EQ(LiveMeshSize(disk, 0.002), live);
  EXPECT_EQ(LiveMeshSize(disk, live), live);
  const FactoredDomain factored(disk, {}, live);
  EXPECT_GT(factored.GetPotential()->GetTopology().mesh.triangles.size(), 3000u);
  EXPECT_LT(factored.GetPotential()->GetTopology().mesh.triangles.size(), 6000u);
  PlanarDomain large = disk;
  for (Point& point : large.loops[0])
  {
    point *= 1e6;
  }
  EXPECT_NEAR(LiveMeshSize(large, 1e-3), 1e6 * live, 1e-6 * live);
}

TEST(LayoutDesign, ReusesMeshAndFactors)
{
  const FactoredDomain factored(Builtin("disk", 0.07), {}, 0.07);
  const PlanarTopology& base = factored.GetPotential()->GetTopology();
  DesignLayout(
    // The first energy also factors the Laplacian of the inner vertices.
    factored, Four(0.45, 0.3));
  for (int i = 0; i < 10; ++i)
  {
    const Configuration configuration = Four(0.5 + 0.02 * i, 0.3);
    const TriangleMesh mesh = factored.MeshOn(configuration);
    // The mesh differs by local changes only.
    EXPECT_LE(mesh.points.size(), base.mesh.points.size() + 4);
    const long before = FactorisationCount();
    const LayoutDesign design = DesignLayout(factored, configuration);
    const long factorisations = FactorisationCount() - before;
    EXPECT_EQ(factorisations, 2); // the map and its potential
  }
}

TEST(LayoutDesign, MeshesAgainIfSingularitiesAreClose)
{
  const FactoredDomain factored(Builtin("disk", 0.07), {}, 0.07);
  Configuration configuration = Four(0.5, 0.3);
  configuration[1].position = configuration[0].position + Point(0.03, 0.01);
  const PlanarTopology& base = factored.GetPotential()->GetTopology();
  EXPECT_GT(factored.MeshOn(configuration).points.size(), base.mesh.points.size() + 10);
  EXPECT_NO_THROW(DesignLayout(factored, configuration));
}

TEST(LayoutDesign, ThrowsForInvalidConfigurations)
{
  const FactoredDomain factored(Builtin("disk", 0.07), {}, 0.07);
  Configuration three = Four(0.5, 0.3);
  three.pop_back();
  try
  {
    DesignLayout(factored, three);
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.GetKind(), Error::Kind::Inconsistent);
  }
  Configuration outside = Four(0.5, 0.3);
  outside[2].position = Point(3.0, 0.0);
  EXPECT_THROW(DesignLayout(factored, outside), Error);
}
}
}
