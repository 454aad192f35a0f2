#include "Support.h"
#include "SurfaceMap.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"
#include "TMeshPatches.h"
#include "VertexPotential.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
std::shared_ptr<const SurfaceTopology> TopologyOf(const SurfaceMesh& surface)
{
  return std::make_shared<const SurfaceTopology>(surface);
}

TMesh TMeshOf(const SeamlessMap& map)
{
  return MakeTMesh(map, TraceSeparatrices(map));
}

/// Expects a T-mesh of rectangles on a torus.
void ExpectRectangles(const SeamlessMap& map)
{
  const TMesh mesh = TMeshOf(map);
  EXPECT_EQ(mesh.nodes.size() + mesh.patches.size(), mesh.arcs.size()); // χ = 0
  EXPECT_LT(mesh.Mismatch(), 1e-9 * map.Extent());
}

TEST(SurfaceMap, OfTheSphereHasTheFacesOfACube)
{
  for (const int n : { 4, 12 })
  {
    const SurfaceMesh sphere = CubedSphere(n);
    const SeamlessMap map = SolveSurfaceMap(TopologyOf(sphere), ConesOfCube(sphere));
    const TMesh mesh = TMeshOf(map);
    EXPECT_EQ(mesh.patches.size(), 6u);
    ASSERT_EQ(mesh.arcs.size(), 12u);
    for (const TArc& arc : mesh.arcs)
    {
      EXPECT_NEAR(arc.length, std::sqrt(map.topology->Area() / 6.0), 1e-9);
    }
  }
}

TEST(SurfaceMap, OfTheHemisphereHasFiveFaces)
{
  // The first four corners of the cube in the upper half; its boundary has no corners.
  const SurfaceMesh half = Hemisphere(12);
  const std::vector<Cone> cones = ConesOfCube(half);
  ASSERT_EQ(cones.size(), 4u);
  const auto topology = TopologyOf(half);
  const TMesh mesh = TMeshOf(SolveSurfaceMap(topology, cones));
  EXPECT_EQ(mesh.patches.size(), 5u);
  ASSERT_EQ(mesh.arcs.size(), 12u);
  // Half of a cube: four edges are halves.
  std::vector<double> lengths;
  for (const TArc& arc : mesh.arcs)
  {
    lengths.push_back(arc.length);
  }
  std::sort(lengths.begin(), lengths.end());
  const double side = std::sqrt(topology->Area() / 3.0);
  EXPECT_NEAR(lengths[0], 0.5 * side, 1e-9);
  EXPECT_NEAR(lengths[3], 0.5 * side, 1e-9);
  EXPECT_NEAR(lengths[4], side, 1e-9);
  EXPECT_NEAR(lengths[11], side, 1e-9);
}

TEST(SurfaceMap, OfATorusClosesUpAroundBothCircles)
{
  // e^H = R + cos v, so the map is a rectangle with sides in the ratio √(R² − 1).
  constexpr double R = 2.5;
  std::vector<double> errors;
  for (const int n : { 12, 24 })
  {
    const SeamlessMap map = SolveSurfaceMap(TopologyOf(Torus(R, 5 * n / 2, n)), {});
    EXPECT_FALSE(map.transitions.empty());
    Point sides = Point::Zero(); // crosses are along the circles
    for (const SeamTransition& transition : map.transitions)
    {
      EXPECT_EQ(transition.rotation, 0);
      sides = sides.cwiseMax(transition.translation.cwiseAbs());
    }
    errors.push_back(std::abs(sides.maxCoeff() / sides.minCoeff() - std::sqrt(R * R - 1.0)));
  }
  EXPECT_LT(errors[1], 0.3 * errors[0]);
  EXPECT_LT(errors[1], 0.02);
}

TEST(SurfaceMap, IsThatOfThePlaneWhenAMeshIsBent)
{
  constexpr int N = 12;
  const TriangleMesh mesh = GridOfSquare(N);
  const std::vector<Cone> cones = ConesOfSquare(N);
  const TMesh planar = TMeshOf(SolveSurfaceMap(ShareTopology(mesh), cones));
  const TMesh bent = TMeshOf(SolveSurfaceMap(TopologyOf(BentAtRandom(mesh, N, 555)), cones));
  EXPECT_EQ(planar.patches.size(), bent.patches.size());
  ASSERT_EQ(planar.arcs.size(), bent.arcs.size());
  const auto lengths = [](const TMesh& of)
  {
    std::vector<double> all;
    for (const TArc& arc : of.arcs)
    {
      all.push_back(arc.length);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  for (std::size_t a = 0; a < planar.arcs.size(); ++a)
  {
    EXPECT_NEAR(lengths(planar)[a], lengths(bent)[a], 1e-10);
  }
}

TEST(SurfaceMap, SharesOutWhatDoesNotCloseAroundHandles)
{
  // Random positions, of which those are taken whose crosses miss by 1 to 3 degrees.
  const auto topology = TopologyOf(Torus(2.5, 60, 24));
  const VertexPotential potential(topology);
  Random random(561);
  int solved = 0;
  for (int trial = 0; trial < 10000 && solved < 5; ++trial)
  {
    std::vector<Cone> cones;
    for (const int index : { 1, -1, 1, -1 })
    {
      cones.push_back({ random.Integer(0, topology->VertexCount() - 1), index, false,
        static_cast<int>(cones.size()) });
    }
    const std::vector<double> defect =
      potential.Solve(QuartersOfVertices(*topology, cones)).holonomyDefect;
    const double largest = std::max(std::abs(defect[0]), std::abs(defect[1]));
    if (largest < 0.07 || largest > 0.21)
    {
      continue;
    }
    ++solved;
    const SeamlessMap map = SolveSurfaceMap(topology, cones);
    EXPECT_EQ(map.holonomyDefect, defect);
    ExpectRectangles(map);
  }
  EXPECT_EQ(solved, 5);
}

TEST(SurfaceMap, LaysOutAFlatMetricWhereItWouldFold)
{
  // Random positions, most of whose crosses miss by tens of degrees around the handle.
  const auto topology = TopologyOf(Torus(2.5, 60, 24));
  int flattened = 0;
  for (const unsigned seed : { 571u, 572u, 573u, 574u, 575u, 576u })
  {
    Random random(seed);
    std::vector<Cone> cones;
    for (const int index : { 1, -1, 1, -1, 1, -1, 1, -1 })
    {
      cones.push_back({ random.Integer(0, topology->VertexCount() - 1), index, false,
        static_cast<int>(cones.size()) });
    }
    const SeamlessMap map = SolveSurfaceMap(topology, cones);
    ExpectRectangles(map);
    EXPECT_NEAR(map.topology->Area(), topology->Area(), 1e-9); // the same surface
    if (map.flattening)
    {
      ++flattened;
      EXPECT_TRUE(map.flattening->converged);
      EXPECT_LT(map.residual, 1e-6); // isometric to the metric
    }
  }
  EXPECT_GT(flattened, 0);
}

TEST(SurfaceMap, RefusesWhatNoMapHas)
{
  const SurfaceMesh sphere = CubedSphere(4);
  std::vector<Cone> cones = ConesOfCube(sphere);
  cones.pop_back();
  EXPECT_TRUE(
    Refuses([&] { SolveSurfaceMap(TopologyOf(sphere), cones); }, { "add up to 7", "4χ = 8" }));
  cones.pop_back();
  cones.front().quarterIndex = 3;
  EXPECT_TRUE(Refuses([&] { SolveSurfaceMap(TopologyOf(sphere), cones); },
    { "The singularity at (", "quarter index 3" }));
  const std::vector<Cone> sharp = { { 0, 2, true, -1 } };
  EXPECT_TRUE(Refuses([&] { SolveSurfaceMap(ShareTopology(GridOfSquare(4)), sharp); },
    { "The corner at (0, 0)", "quarter index 2", "choose index 1" }));
}
}
}
