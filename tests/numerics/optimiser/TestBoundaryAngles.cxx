// Quarter indices that a boundary point may have: those with angles for quads.

#include "StageBoundary.h"

#include "MakePlanarDomain.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
OptimizerStage StageOf(const PlanarDomain& domain, const Configuration& singularities, double size)
{
  StageOptions options;
  options.objective.clearance = CoreRadius(domain);
  options.quadSize = size;
  return MakeStage(
    domain, { singularities, std::vector<int>(singularities.size(), 0), {} }, options);
}

PlanarDomain Ellipse(double ratio, int points)
{
  Loop loop = RegularPolygon(points);
  for (Point& point : loop)
  {
    point.x() *= ratio;
  }
  return MakePlanarDomain({ loop });
}

TEST(BoundaryAngles, QualityIsTheSineOfEachQuadsAngle)
{
  for (int quads = 1; quads <= 5; ++quads)
  {
    for (const double each : { 0.1, 1.0, 0.5 * Pi, 3.0 })
    {
      EXPECT_NEAR(CornerQuality(quads * each, 2 - quads), std::sin(each), 1e-12);
    }
  }
  EXPECT_NEAR(CornerQuality(Pi, 1), 0.0, 1e-12);
  EXPECT_NEAR(CornerQuality(1.5 * Pi, 1), 0.0, 1e-12); // more than a half turn for one quad
  EXPECT_EQ(CornerQuality(0.1, 2), 0.0);               // no quad
}

TEST(BoundaryAngles, SmoothBoundaryTakesNegativeIndicesOnly)
{
  const PlanarDomain disk = DiskOfEdges(0.05);
  const OptimizerStage stage = StageOf(disk, OnCircle(4, 0.6, 0.1, 1, 0.0), 0.06);
  const BoundaryVertices boundary(stage);
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    EXPECT_LE(boundary.AngleForQuads(v, v), Pi + 1e-12);
    EXPECT_GT(boundary.AngleForQuads(v, v), Pi - 0.06); // that of points one quad away
    EXPECT_FALSE(boundary.Allows(v, 1));
    EXPECT_TRUE(boundary.Allows(v, -1));
    EXPECT_TRUE(boundary.Allows(v, -2));
  }
  // Nearest vertices are those nearest to the point.
  const Point near = 0.97 * boundary.vertices[5].position;
  EXPECT_EQ(NearestAllowedVertex(boundary, near, 0.1, -1), 5U);
  EXPECT_EQ(NearestAllowedVertex(boundary, near, 0.1, 1), boundary.vertices.size());
  EXPECT_EQ(NearestAllowedVertex(boundary, near, 0.01, -1), boundary.vertices.size());
}

TEST(BoundaryAngles, TipOfAnEllipseIsACornerForQuadsOnly)
{
  // The radius of curvature of the tip is 1/25, a seventh of a quad.
  const double ratio = 25.0;
  const PlanarDomain ellipse = Ellipse(ratio, 800);
  const Configuration inside = { { { -20.0, 0.0 }, 1, 0.0 }, { { -10.0, 0.0 }, 1, 0.0 },
    { { 10.0, 0.0 }, 1, 0.0 }, { { 20.0, 0.0 }, 1, 0.0 } };
  const double size = 0.28;
  const BoundaryVertices boundary(StageOf(ellipse, inside, size));
  const std::size_t tip = boundary.At({ ratio, 0.0 });
  ASSERT_LT(tip, boundary.vertices.size());
  EXPECT_GT(boundary.vertices[tip].angle, 0.8 * Pi);
  EXPECT_LT(boundary.AngleForQuads(tip, tip), 0.6 * Pi);
  EXPECT_TRUE(boundary.Allows(tip, 1));
  EXPECT_FALSE(boundary.Allows(tip, 2));
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    if (std::abs(boundary.vertices[v].position.x()) < ratio - 3.0 * size)
    {
      EXPECT_FALSE(boundary.Allows(v, 1)) << Describe(boundary.vertices[v].position);
    }
  }

  // With a corner at the tip there is none next to it.
  Configuration onTip = inside;
  onTip.back().position = { ratio, 0.0 };
  const BoundaryVertices corner(StageOf(ellipse, onTip, size));
  const std::size_t same = corner.At({ ratio, 0.0 });
  EXPECT_EQ(corner.quarters[same], 1);
  EXPECT_FALSE(corner.Allows(corner.next[same], 1));
  EXPECT_TRUE(corner.Allows(corner.next[same], 1, same));
  EXPECT_FALSE(corner.Allows(same, 2));
}
}
}
