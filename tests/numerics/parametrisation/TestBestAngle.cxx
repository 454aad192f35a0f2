#include "BestAngle.h"
#include "ConeVectors.h"
#include "Support.h"
#include "SurfaceMap.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"
#include "TMeshPatches.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// The same triangles in another order, each beginning with another corner: other crosses without BestAngle.
SurfaceMesh Shuffled(SurfaceMesh surface, unsigned seed)
{
  Random random(seed);
  random.Shuffle(surface.triangles);
  for (auto& triangle : surface.triangles)
  {
    std::rotate(triangle.begin(), triangle.begin() + random.Integer(0, 2), triangle.end());
  }
  return surface;
}

/// Turns a map by an angle.
SeamlessMap Turned(SeamlessMap map, double angle)
{
  const Eigen::Rotation2Dd turn(angle);
  for (Point& point : map.points)
  {
    point = turn * point;
  }
  for (SeamTransition& transition : map.transitions)
  {
    transition.translation = turn * transition.translation;
  }
  return map;
}

TEST(BestAngle, LeadsLinesOfTheSphereToSingularities)
{
  for (const unsigned seed : { 1u, 2u, 3u, 4u, 5u })
  {
    const SurfaceMesh sphere = Shuffled(CubedSphere(8), seed);
    const SeamlessMap map =
      SolveSurfaceMap(std::make_shared<const SurfaceTopology>(sphere), ConesOfCube(sphere));
    EXPECT_NEAR(BestAngle(map), 0.0, 1e-9);
    EXPECT_EQ(MakeTMesh(map, TraceSeparatrices(map)).patches.size(), 6u);
  }
}

TEST(BestAngle, FollowsTheMap)
{
  const SurfaceMesh sphere = CubedSphere(8);
  const auto torus = std::make_shared<const SurfaceTopology>(Shuffled(Torus(2.5, 30, 12), 7));
  const SeamlessMap ofSphere =
    SolveSurfaceMap(std::make_shared<const SurfaceTopology>(sphere), ConesOfCube(sphere));
  const SeamlessMap ofTorus = SolveSurfaceMap(torus, {});
  EXPECT_NEAR(BestAngle(ofTorus), 0.0, 1e-9);
  for (const double angle : { -0.7, -0.2, 0.1, 0.6 })
  {
    EXPECT_NEAR(BestAngle(Turned(ofSphere, angle)), angle, 1e-9);
    EXPECT_NEAR(BestAngle(Turned(ofTorus, angle)), angle, 1e-9);
  }
}

TEST(ConeVectors, OfTheSphereAreTheEdgesAndDiagonalsOfACube)
{
  const SurfaceMesh sphere = CubedSphere(8);
  const SeamlessMap map =
    SolveSurfaceMap(std::make_shared<const SurfaceTopology>(sphere), ConesOfCube(sphere));
  const double edge = std::sqrt(map.topology->Area() / 6.0);
  int edges = 0;
  int diagonals = 0;
  for (const Point& vector : VectorsBetweenCones(map))
  {
    const bool isEdge = std::abs(vector.norm() - edge) < 1e-9;
    const bool isDiagonal = std::abs(vector.norm() - std::sqrt(2.0) * edge) < 1e-9;
    EXPECT_TRUE(isEdge || isDiagonal) << vector.norm() / edge;
    edges += isEdge ? 1 : 0;
    diagonals += isDiagonal ? 1 : 0;
  }
  EXPECT_EQ(edges, 12);
  EXPECT_LE(diagonals, 12); // cells of opposite corners of a face touch in a point
}

TEST(ConeVectors, OfTheTorusGoAroundBothCircles)
{
  constexpr double R = 2.5;
  const SeamlessMap map =
    SolveSurfaceMap(std::make_shared<const SurfaceTopology>(Torus(R, 60, 24)), {});
  std::vector<double> lengths;
  for (const Point& vector : VectorsBetweenCones(map))
  {
    lengths.push_back(vector.norm());
  }
  std::sort(lengths.begin(), lengths.end());
  ASSERT_GE(lengths.size(), 2u);
  EXPECT_NEAR(lengths[1] / lengths[0], std::sqrt(R * R - 1.0), 0.02);
}
}
}
