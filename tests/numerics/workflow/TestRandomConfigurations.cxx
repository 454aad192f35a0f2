// Random rings and plates with singularities at random places: each has an injective map and a mesh
// with exactly the requested irregular nodes.

#include "RandomConfigurations.h"

#include "InjectivityCheck.h"
#include "MeshForPoints.h"
#include "QuadWorkflow.h"
#include "SeamlessMapChecks.h"
#include "Support.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

namespace crossfield::test
{
namespace
{
constexpr std::uint32_t FirstSeed = 1000;

/// Checks that the map of a case is injective, closes at seams and has the requested cones.
void ExpectMap(const RandomCase& random)
{
  const SeamlessMap map = SolveSeamlessMap(
    ShareTopology(MeshThroughPoints(random.domain, random.singularities)), random.singularities);
  EXPECT_EQ(CountReversed(map), 0);
  EXPECT_FALSE(FindFault(map));
  // Edges down to 4e-10 of the extent, whose directions rounding of the coordinates changes.
  constexpr double Rounding = 1e-15;
  EXPECT_LT(AngleSumDefect(map), std::max(1e-9, Rounding / ShortestEdge(map)));
  EXPECT_EQ(SeamDefect(map), 0.0);
  if (map.flattening)
  {
    EXPECT_TRUE(map.flattening->converged);
    EXPECT_LT(map.flattening->angleDefect, 1e-9);
    EXPECT_LT(map.flattening->alignmentDefect, 1e-9);
  }
  std::size_t singular = 0;
  for (const Cone& cone : map.cones)
  {
    if (cone.row >= 0)
    {
      ++singular;
      const Singularity& singularity = random.singularities[static_cast<std::size_t>(cone.row)];
      EXPECT_EQ(cone.quarterIndex, singularity.quarterIndex);
      EXPECT_LT(
        (map.topology->PositionOf(cone.vertex).head<2>() - singularity.position).norm(), 1e-12);
    }
  }
  EXPECT_EQ(singular, random.singularities.size());
}

/// Returns whether the inner irregular nodes of a mesh are exactly the singularities.
bool HasRequestedNodes(const QuadMesh& mesh, const Configuration& singularities)
{
  std::vector<int> valences(mesh.points.size(), 0);
  for (const auto& quad : mesh.quads)
  {
    for (const int p : quad)
    {
      ++valences[static_cast<std::size_t>(p)];
    }
  }
  std::map<int, int> obtained;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.points[p].curve.loop < 0 && valences[p] != 4)
    {
      ++obtained[4 - valences[p]];
    }
  }
  std::map<int, int> requested;
  for (const Singularity& singularity : singularities)
  {
    ++requested[singularity.quarterIndex];
  }
  return obtained == requested;
}

/// Checks that no edge of a mesh leads around much more than 150° of a round hole, so that chords
/// stay away from its centre.
void ExpectHoles(const QuadMesh& mesh, const PlanarDomain& domain)
{
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.kind == BoundaryKind::Inner)
    {
      const Loop& hole = domain.loops[static_cast<std::size_t>(edge.id)];
      Point centre = Point::Zero();
      for (const Point& point : hole)
      {
        centre += point / static_cast<double>(hole.size());
      }
      const auto from = [&](int point) -> Point
      { return mesh.points[static_cast<std::size_t>(point)].InPlane() - centre; };
      // Inner loops are clockwise.
      EXPECT_LT(-AngleBetween(from(edge.points[0]), from(edge.points[1])), 0.86 * Pi);
      EXPECT_GT(-AngleBetween(from(edge.points[0]), from(edge.points[1])), 0.0);
    }
  }
}

/// Returns the minimum scaled Jacobian of the mesh of a case, 0 if there are inverted quads or no
/// mesh, and checks its irregular nodes.
double JacobianOfQuads(const RandomCase& random)
{
  QuadRequest request;
  request.singularities = random.singularities;
  request.quadCount = QuadsOfRandomCases;
  try
  {
    const QuadWorkflowResult result = MakeQuadMesh(random.domain, request);
    EXPECT_TRUE(HasRequestedNodes(result.quads.mesh, random.singularities));
    ExpectHoles(result.quads.mesh, random.domain);
    return result.quads.quality.inverted == 0 ? result.quads.quality.jacobian.min : 0.0;
  }
  catch (const Error& error)
  {
    std::cout << error.what() << '\n';
    return 0.0;
  }
}

/// Makes quads of `count` rings and as many plates. Returns how many have no inverted quads, and
/// the median of the minimum scaled Jacobian.
std::pair<int, double> QuadsOf(std::uint32_t count)
{
  std::vector<double> minima;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    SCOPED_TRACE(FirstSeed + i);
    minima.push_back(JacobianOfQuads(RandomRing(FirstSeed + i)));
    minima.push_back(JacobianOfQuads(RandomPlate(FirstSeed + i)));
  }
  std::sort(minima.begin(), minima.end());
  return { static_cast<int>(std::count_if(
             minima.begin(), minima.end(), [](double minimum) { return minimum > 0.0; })),
    minima[count] };
}

TEST(RandomConfigurations, HaveAnInjectiveMap)
{
  for (std::uint32_t i = 0; i < 10; ++i)
  {
    SCOPED_TRACE(FirstSeed + i);
    EXPECT_NO_THROW(ExpectMap(RandomRing(FirstSeed + i)));
    EXPECT_NO_THROW(ExpectMap(RandomPlate(FirstSeed + i)));
  }
}

TEST(RandomConfigurations, BecomeQuads)
{
  const auto [valid, median] = QuadsOf(10);
  EXPECT_EQ(valid, 20);
  EXPECT_GT(median, 0.5);
}

/// Takes minutes, so scripts/test.sh leaves it out without --all.
TEST(RandomConfigurations, TwoHundredBecomeQuads)
{
  const auto [valid, median] = QuadsOf(100);
  EXPECT_GE(valid, 196);
  EXPECT_GT(median, 0.5);
}
}
}
