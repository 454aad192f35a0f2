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
  EXPECT_LT(SeamDefect(map), 1e-12);
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
      EXPECT_LT((map.topology->PointAt(cone.vertex) - singularity.position).norm(), 1e-12);
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

/// Returns whether a case gives a mesh without inverted quads, and checks its irregular nodes.
bool BecomesQuads(const RandomCase& random)
{
  QuadRequest request;
  request.singularities = random.singularities;
  request.quadCount = QuadsOfRandomCases;
  try
  {
    const QuadWorkflowResult result = MakeQuadMesh(random.domain, request);
    EXPECT_TRUE(HasRequestedNodes(result.quads.mesh, random.singularities));
    return result.quads.quality.inverted == 0;
  }
  catch (const Error& error)
  {
    std::cout << error.what() << '\n';
    return false;
  }
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
  int rings = 0;
  int plates = 0;
  for (std::uint32_t i = 0; i < 10; ++i)
  {
    SCOPED_TRACE(FirstSeed + i);
    rings += BecomesQuads(RandomRing(FirstSeed + i)) ? 1 : 0;
    plates += BecomesQuads(RandomPlate(FirstSeed + i)) ? 1 : 0;
  }
  EXPECT_EQ(rings, 10);
  EXPECT_GE(plates, 9);
}
}
}
