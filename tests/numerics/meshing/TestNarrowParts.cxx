// Narrow parts of a domain get edges as long as half of their width; other parts, and domains
// without narrow parts, are meshed as before.

#include "NarrowParts.h"

#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
PlanarDomain Rectangle(double width, double height)
{
  return MakePlanarDomain({ { { 0.0, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } } });
}

/// Returns a triangle with a corner of `angle` at the origin and a height of 1.
PlanarDomain Wedge(double angle)
{
  const double half = std::tan(0.5 * angle);
  return MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, -half }, { 1.0, half } } });
}

/// Returns the narrow parts of a domain at a constant size.
std::vector<SizeSource> Sources(const PlanarDomain& domain, double size, double across = 2.0)
{
  Eigen::AlignedBox2d box;
  for (const Point& point : domain.loops.front())
  {
    box.extend(point);
  }
  return FindNarrowParts(domain, SizeField({}, size, 0.25, box), across, 1e-3 * size);
}

std::size_t CountTriangles(const PlanarDomain& domain, double refinement = 1.0)
{
  return MeshThroughPoints(domain, {}, 0.0, {}, refinement).triangles.size();
}

double LongestEdge(const TriangleMesh& mesh)
{
  double longest = 0.0;
  for (const auto& triangle : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      longest = std::max(longest,
        (mesh.points[static_cast<std::size_t>(triangle[i])] -
          mesh.points[static_cast<std::size_t>(triangle[(i + 1) % 3])])
          .norm());
    }
  }
  return longest;
}

TEST(NarrowParts, AStripHasSourcesOfHalfItsWidthAlongBothSides)
{
  const std::vector<SizeSource> sources = Sources(Rectangle(40.0, 1.0), 1.0);
  double first = 40.0;
  double last = 0.0;
  for (const SizeSource& source : sources)
  {
    EXPECT_DOUBLE_EQ(source.size, 0.5);
    first = std::min(first, source.position.x());
    last = std::max(last, source.position.x());
  }
  // Every width or less, except near the ends, which are within four widths along the loop.
  EXPECT_GE(sources.size(), 2U * 36U);
  EXPECT_LT(first, 3.0);
  EXPECT_GT(last, 37.0);
}

TEST(NarrowParts, AThinRingIsNarrowBetweenItsLoops)
{
  Loop hole = RegularPolygon(400, 0.99);
  std::reverse(hole.begin(), hole.end());
  const PlanarDomain ring = MakePlanarDomain({ RegularPolygon(400), hole });
  const std::vector<SizeSource> sources = Sources(ring, 0.07);
  EXPECT_EQ(sources.size() % 800, 0U); // every side alike
  ASSERT_FALSE(sources.empty());
  for (const SizeSource& source : sources)
  {
    EXPECT_NEAR(source.size, 0.005, 1e-4);
  }
}

TEST(NarrowParts, NothingIsNarrowWhereTheSizeIsSmallEnough)
{
  EXPECT_TRUE(Sources(Rectangle(40.0, 1.0), 0.5).empty());
  EXPECT_FALSE(Sources(Rectangle(40.0, 1.0), 0.51).empty());
  EXPECT_TRUE(Sources(Rectangle(1.0, 1.0), 0.1).empty());
  EXPECT_TRUE(Sources({ { RegularPolygon(300) } }, 0.1).empty());
}

/// The map of a sharp corner needs no small triangles there, and fails with very small ones.
TEST(NarrowParts, TheTipOfASharpCornerIsNotNarrow)
{
  for (const double degrees : { 5.0, 15.0, 25.0, 45.0 })
  {
    SCOPED_TRACE(degrees);
    const double size = 0.025;
    for (const SizeSource& source : Sources(Wedge(degrees / 180.0 * Pi), size))
    {
      // Opposite points at equal distances from the tip are 2 x apart along the loop.
      EXPECT_GT(source.position.x(), 0.5 * 20.0 * size - size);
    }
  }
}

/// A slit outside the domain has no width inside it.
TEST(NarrowParts, AThinGapOutsideTheDomainIsNotNarrow)
{
  const PlanarDomain slit =
    MakePlanarDomain({ { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } },
      { { -0.5, 0.0 }, { -0.5, 0.01 }, { 0.5, 0.01 }, { 0.5, 0.0 } } });
  EXPECT_TRUE(Sources(slit, 0.1).empty());
}

TEST(NarrowParts, SourcesMoveWithTheDomain)
{
  const Similarity map{ 0.7, 3.0, { 5.0, -2.0 } };
  // Without equal lengths, whose comparison would depend on rounding.
  const PlanarDomain comb = MakePlanarDomain(
    { { { 0.0, 0.0 }, { 5.13, 0.017 }, { 5.21, 3.07 }, { 4.69, 3.11 }, { 4.73, 0.33 },
      { 2.03, 0.29 }, { 2.07, 3.01 }, { 1.81, 2.93 }, { 1.79, 0.31 }, { 0.02, 0.28 } } });
  const std::vector<SizeSource> sources = Sources(comb, 0.21);
  const std::vector<SizeSource> moved = Sources(map(comb), 3.0 * 0.21);
  ASSERT_EQ(moved.size(), sources.size());
  ASSERT_FALSE(sources.empty());
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    EXPECT_LT((map(sources[i].position) - moved[i].position).norm(), 1e-12);
    EXPECT_NEAR(moved[i].size, 3.0 * sources[i].size, 1e-12);
  }
}

TEST(NarrowParts, MeshesOfOrdinaryDomainsAreUnchanged)
{
  for (const PlanarDomain& domain : { LShape(), DiskOfEdges(0.1), Rectangle(2.0, 1.0) })
  {
    const TriangleMesh mesh = MeshThroughPoints(domain, {});
    DrillOptions options;
    options.symmetries = FindSymmetries(domain);
    const TriangleMesh plain = DrillHoles(domain, {}, options);
    EXPECT_EQ(mesh.points, plain.points);
    EXPECT_EQ(mesh.triangles, plain.triangles);
  }
}

/// Two edges across a width of one: about 4/√3 · 4 triangles per unit of length.
TEST(NarrowParts, TrianglesAreInProportionToTheAspectRatio)
{
  for (const double aspect : { 40.0, 200.0, 1000.0 })
  {
    SCOPED_TRACE(aspect);
    const auto triangles = static_cast<double>(CountTriangles(Rectangle(aspect, 1.0)));
    EXPECT_GT(triangles, 4.0 * aspect);
    EXPECT_LT(triangles, 25.0 * aspect);
  }
}

TEST(NarrowParts, RefinementDividesAllEdgeLengths)
{
  for (const PlanarDomain& domain : { LShape(), DiskOfEdges(0.1), Rectangle(100.0, 1.0) })
  {
    const TriangleMesh mesh = MeshThroughPoints(domain, {});
    const TriangleMesh fine = MeshThroughPoints(domain, {}, 0.0, {}, 2.0);
    EXPECT_LT(LongestEdge(fine), 0.75 * LongestEdge(mesh));
    const double ratio =
      static_cast<double>(fine.triangles.size()) / static_cast<double>(mesh.triangles.size());
    EXPECT_GT(ratio, 3.0);
    EXPECT_LT(ratio, 5.5);
    EXPECT_NEAR(MeshArea(fine), domain.Area(), 1e-12 * domain.Area());
  }
}
}
}
