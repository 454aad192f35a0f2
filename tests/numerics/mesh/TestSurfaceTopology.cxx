#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <algorithm>

namespace crossfield::test
{
namespace
{
/// Moves the points of a surface at random.
SurfaceMesh MovedAtRandom(SurfaceMesh surface, double by, Random& random)
{
  for (SpacePoint& point : surface.points)
  {
    for (double& coordinate : point)
    {
      coordinate += random.Uniform(-by, by);
    }
  }
  return surface;
}

/// Checks Σ K + Σ τ = 2πχ.
void ExpectGaussBonnet(const SurfaceTopology& topology, int genus, std::size_t loops)
{
  EXPECT_EQ(topology.loops.size(), loops);
  EXPECT_EQ(topology.cycles.size(), 2 * genus + std::max<std::size_t>(loops, 1) - 1);
  const int characteristic = topology.edges.EulerCharacteristic(topology.mesh);
  EXPECT_EQ(characteristic, 2 - 2 * genus - static_cast<int>(loops));
  EXPECT_NEAR(
    topology.charts->curvature.sum() + topology.turning.sum(), 2.0 * Pi * characteristic, 1e-11);
}

TEST(SurfaceTopology, CurvaturesAddUpToGaussBonnet)
{
  Random random(551);
  for (int trial = 0; trial < 5; ++trial)
  {
    ExpectGaussBonnet(SurfaceTopology(MovedAtRandom(CubedSphere(6), 0.03, random)), 0, 0);
    ExpectGaussBonnet(SurfaceTopology(MovedAtRandom(Hemisphere(6), 0.03, random)), 0, 1);
    ExpectGaussBonnet(SurfaceTopology(MovedAtRandom(Torus(2.5, 14, 9), 0.05, random)), 1, 0);
    // Without some of its triangles, it has loops.
    SurfaceMesh open = MovedAtRandom(Torus(2.5, 14, 9), 0.05, random);
    open.triangles.erase(open.triangles.begin() + 100, open.triangles.begin() + 102);
    open.triangles.pop_back();
    ExpectGaussBonnet(SurfaceTopology(open), 1, 2);
  }
}

TEST(SurfaceTopology, HingesTurnByTheCurvatureAroundAVertex)
{
  Random random(552);
  const SurfaceTopology topology(MovedAtRandom(CubedSphere(5), 0.03, random));
  std::vector<bool> isDone(topology.mesh.points.size(), false);
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int vertex = topology.mesh.triangles[t][i];
      if (isDone[vertex])
      {
        continue;
      }
      isDone[vertex] = true;
      // Counter-clockwise: each triangle is left through the side that ends at the vertex.
      double sum = 0.0;
      int here = t;
      int corner = i;
      do
      {
        const int side = (corner + 2) % 3;
        sum += topology.Hinge(here, side);
        const int next = topology.Neighbour(here, side);
        const int back = topology.SideOf(next, topology.EdgeOf(here, side));
        EXPECT_NEAR(WrapAngle(topology.Hinge(here, side) + topology.Hinge(next, back)), 0.0, 1e-12);
        here = next;
        const auto& v = topology.mesh.triangles[here];
        corner = static_cast<int>(std::find(v.begin(), v.end(), vertex) - v.begin());
      } while (here != t);
      EXPECT_NEAR(WrapAngle(sum - topology.CurvatureAt(vertex)), 0.0, 1e-12);
    }
  }
}

TEST(SurfaceTopology, HasTheNumbersOfAPlanarMeshThatIsBent)
{
  constexpr int N = 8;
  const TriangleMesh mesh = GridOfSquare(N);
  const PlanarTopology planar(mesh);
  const SurfaceTopology bent(BentAtRandom(mesh, N, 553));
  EXPECT_NEAR(bent.charts->curvature.lpNorm<Eigen::Infinity>(), 0.0, 1e-12);
  for (int e = 0; e < planar.edges.Count(); ++e)
  {
    EXPECT_NEAR(bent.Length(e), planar.Length(e), 1e-14);
  }
  for (int t = 0; t < planar.TriangleCount(); ++t)
  {
    EXPECT_NEAR(bent.AreaOf(t), planar.AreaOf(t), 1e-14);
  }
  // Loops may start elsewhere.
  ASSERT_EQ(bent.turning.size(), planar.turning.size());
  Eigen::VectorXd turning = Eigen::VectorXd::Zero(planar.VertexCount());
  for (int i = 0; i < static_cast<int>(planar.turning.size()); ++i)
  {
    turning[planar.BoundaryAt(i).vertices[0]] += planar.turning[i];
    turning[bent.BoundaryAt(i).vertices[0]] -= bent.turning[i];
  }
  EXPECT_NEAR(turning.lpNorm<Eigen::Infinity>(), 0.0, 1e-12);
  EXPECT_EQ(bent.corners, planar.corners);
}

TEST(SurfaceTopology, RefusesWhatIsNoManifold)
{
  const SurfaceMesh sphere = CubedSphere(2);
  const auto refuses = [](const SurfaceMesh& surface, const std::vector<std::string>& says)
  { return Refuses([&] { SurfaceTopology{ surface }; }, says); };

  SurfaceMesh fin = sphere;
  fin.points.emplace_back(2.0, 2.0, 2.0);
  fin.triangles.push_back(
    { fin.triangles[0][0], fin.triangles[0][1], static_cast<int>(fin.points.size()) - 1 });
  EXPECT_TRUE(refuses(fin, { "The edge from (", "3 triangles" }));

  SurfaceMesh reversed = sphere;
  std::swap(reversed.triangles[3][0], reversed.triangles[3][1]);
  EXPECT_TRUE(refuses(reversed, { "opposite orientation", "orient" }));

  SurfaceMesh pinched = sphere; // two of them, with a point in common
  const auto offset = static_cast<int>(sphere.points.size());
  for (const SpacePoint& point : sphere.points)
  {
    pinched.points.push_back(2.0 * sphere.points[0] - point);
  }
  for (auto triangle : sphere.triangles)
  {
    for (int& vertex : triangle)
    {
      vertex = vertex == 0 ? 0 : vertex + offset;
    }
    std::swap(triangle[1], triangle[2]);
    pinched.triangles.push_back(triangle);
  }
  SurfaceMesh apart = pinched;
  pinched.points.erase(pinched.points.begin() + offset);
  for (std::size_t t = sphere.triangles.size(); t < pinched.triangles.size(); ++t)
  {
    for (int& vertex : pinched.triangles[t])
    {
      vertex -= vertex == 0 ? 0 : 1;
    }
  }
  EXPECT_TRUE(refuses(pinched, { "meet only in the point (" }));

  for (std::size_t t = sphere.triangles.size(); t < apart.triangles.size(); ++t)
  {
    for (int& vertex : apart.triangles[t])
    {
      vertex = vertex == 0 ? offset : vertex;
    }
  }
  EXPECT_TRUE(refuses(apart, { "not connected", "one by one" }));

  SurfaceMesh unused = sphere;
  unused.points.emplace_back(0.0, 0.0, 0.0);
  EXPECT_TRUE(refuses(unused, { "(0, 0, 0)", "in no triangle" }));

  SurfaceMesh flat = sphere;
  flat.points[flat.triangles[0][0]] = flat.points[flat.triangles[0][1]];
  EXPECT_TRUE(refuses(flat, { "no area" }));
}
}
}
