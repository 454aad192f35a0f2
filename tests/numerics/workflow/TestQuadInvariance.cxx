// A domain that is turned, scaled and shifted gives the same quads, and a symmetric one symmetric
// quads.

#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>

namespace crossfield::test
{
namespace
{
/// A plate with two round holes, at none of whose angles the sides are parallel to the axes.
PlanarDomain Plate(Random& random)
{
  const double width = random.Uniform(2.0, 3.0);
  const Point second(random.Uniform(0.5, width - 0.5), 0.5);
  std::vector<Loop> loops = { { { 0.0, 0.0 }, { width, 0.0 }, { width, 2.0 }, { 0.0, 1.7 } },
    RegularPolygon(24, random.Uniform(0.15, 0.3), Point(0.6, 1.2)),
    RegularPolygon(24, 0.2, second) };
  return MakePlanarDomain(std::move(loops));
}

/// Returns whether the numbers of quads and blocks are the same. Expects the same singularities and quality, which is
/// only similar if other separatrices meet.
bool ExpectSameQuality(const QuadWorkflowResult& result, const QuadWorkflowResult& expected)
{
  const QuadResult& quads = result.quads;
  const bool isSame = quads.mesh.quads.size() == expected.quads.mesh.quads.size() &&
    quads.blocks.blocks.size() == expected.quads.blocks.blocks.size();
  const double tolerance = isSame ? 0.01 : 0.1;
  EXPECT_EQ(result.singularities.size(), expected.singularities.size());
  EXPECT_NEAR(quads.quality.jacobian.min, expected.quads.quality.jacobian.min, tolerance);
  EXPECT_NEAR(quads.quality.variation, expected.quads.quality.variation, tolerance);
  return isSame;
}

TEST(QuadInvariance, MotionsAndScalesGiveTheSameQuads)
{
  Random random(1010);
  int different = 0;
  for (int i = 0; i < 6; ++i)
  {
    const PlanarDomain domain = i % 2 == 0 ? Plate(random) : RandomSmoothDomain(random, 60);
    QuadRequest request;
    request.quadCount = 300;
    const QuadWorkflowResult expected = MakeQuadMesh(MakePlanarDomain(domain.loops), request);
    for (const double angle : { 0.4, 2.1 })
    {
      SCOPED_TRACE("domain " + std::to_string(i) + " turned by " + std::to_string(angle));
      const Similarity motion{ angle, 2.7, Point(3.0, -8.0) };
      const QuadWorkflowResult result =
        MakeQuadMesh(MakePlanarDomain(motion(domain.loops)), request);
      different += ExpectSameQuality(result, expected) ? 0 : 1;
    }
  }
  // On one of the domains two separatrices nearly meet, and rounding decides whether they do.
  EXPECT_LE(different, 2);
}

/// Returns the largest distance from the image of a point under a reflection to a point.
double Asymmetry(const QuadMesh& mesh, const Point& signs)
{
  double largest = 0.0;
  for (const QuadPoint& point : mesh.points)
  {
    const Point image = point.InPlane().cwiseProduct(signs);
    double nearest = (mesh.points[0].InPlane() - image).norm();
    for (const QuadPoint& other : mesh.points)
    {
      nearest = std::min(nearest, (other.InPlane() - image).norm());
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// A square with one hole in its middle, or with one in each quarter.
PlanarDomain SquareWithHoles(bool four)
{
  const Loop square = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } };
  std::vector<Loop> loops = { square };
  if (!four)
  {
    loops.push_back(RegularPolygon(32, 0.4));
  }
  for (std::size_t i = 0; four && i < 4; ++i)
  {
    loops.push_back(RegularPolygon(32, 0.2, 0.5 * square[i]));
  }
  return MakePlanarDomain(std::move(loops));
}

void ExpectSymmetric(const PlanarDomain& domain, const QuadRequest& request)
{
  const QuadWorkflowResult result = MakeQuadMesh(domain, request);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_LT(Asymmetry(result.quads.mesh, Point(1.0, -1.0)), 1e-9);
  EXPECT_LT(Asymmetry(result.quads.mesh, Point(-1.0, 1.0)), 1e-9);
}

TEST(QuadInvariance, SymmetricDomainsGiveSymmetricQuads)
{
  for (const bool four : { false, true })
  {
    for (const std::optional<Sizing> sizing : { std::optional<Sizing>(), { Sizing::Conformal } })
    {
      QuadRequest request;
      request.quadCount = 600;
      request.sizing = sizing;
      ExpectSymmetric(SquareWithHoles(four), request);
      request.quadSize = 0.08;
      ExpectSymmetric(SquareWithHoles(four), request);
    }
  }
}

TEST(QuadInvariance, SymmetricPrescriptionsGiveSymmetricQuads)
{
  for (const bool four : { false, true })
  {
    const PlanarDomain domain = SquareWithHoles(four);
    SegmentNames names;
    for (const Loop& loop : domain.loops)
    {
      names.emplace_back(loop.size(), names.empty() ? "wall" : "hole");
    }
    QuadRequest request;
    request.sides = NameSides(domain, names);
    request.quadCount = 3000;
    // With four holes and uniform sizes, no symmetric counts have 5 % more or fewer quads.
    const std::vector<Sizing> sizings = four
      ? std::vector<Sizing>{ Sizing::Conformal }
      : std::vector<Sizing>{ Sizing::Conformal, Sizing::Uniform };
    for (const Sizing sizing : sizings)
    {
      QuadRequest other = request;
      other.sizing = sizing;
      other.sideRequests = { LayerOf("hole", 2e-3) };
      ExpectSymmetric(domain, other);
      other.sideRequests.push_back(CountOf("hole", 96));
      ExpectSymmetric(domain, other);
      other.sideRequests = { CountOf("hole", 96) };
      ExpectSymmetric(domain, other);
    }
    request.sideRequests = { SizeOf("hole", 0.03) };
    ExpectSymmetric(domain, request);
  }
}
}
}
