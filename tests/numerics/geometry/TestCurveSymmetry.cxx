// Symmetries of domains whose polygons have them in part only: of curves, and to single precision.

#include "BoundarySymmetry.h"
#include "ConfigurationProposal.h"
#include "CurveSymmetry.h"
#include "ExactSymmetry.h"
#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "Support.h"

#include <Eigen/Geometry>

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns a disk with holes on a circle, whose vertices are not turned with their places.
PlanarDomain DiskWithHoles(int count)
{
  std::vector<Loop> loops = { RegularPolygon(180) };
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    loops.push_back(RegularPolygon(32, 0.1, 0.6 * Point(std::cos(angle), std::sin(angle))));
  }
  return MakePlanarDomain(loops);
}

PlanarDomain Transformed(const PlanarDomain& domain, double angle)
{
  PlanarDomain result = domain;
  for (Loop& loop : result.loops)
  {
    for (Point& point : loop)
    {
      point = 3.0 * (Eigen::Rotation2Dd(angle) * point) + Point(7.0, -4.0);
    }
  }
  return result;
}

/// Returns a domain with coordinates of single precision.
PlanarDomain Rounded(PlanarDomain domain)
{
  for (Loop& loop : domain.loops)
  {
    for (Point& point : loop)
    {
      point = point.cast<float>().cast<double>();
    }
  }
  return domain;
}

double LargestMove(const PlanarDomain& a, const PlanarDomain& b)
{
  double largest = 0.0;
  for (std::size_t l = 0; l < a.loops.size(); ++l)
  {
    for (std::size_t i = 0; i < a.loops[l].size(); ++i)
    {
      largest = std::max(largest, (a.loops[l][i] - b.loops[l][i]).norm());
    }
  }
  return largest;
}
}

TEST(CurveSymmetry, RotationsThatMoveLittleAreNoGroup)
{
  // A rotation by 15° moves the hole by less than the tolerance, one by 180° by more.
  for (const double offset : { 0.008, 0.012, 0.016, 0.02 })
  {
    const Point centre = offset * Point(0.6, 0.8);
    const PlanarDomain ring =
      MakePlanarDomain({ RegularPolygon(97), RegularPolygon(64, 0.5, centre) });
    const SymmetryGroup group = FindCurveSymmetries(ring);
    EXPECT_EQ(group.order, 1) << offset;
    EXPECT_TRUE(group.reflects);
    QuadRequest request;
    request.quadCount = 400;
    const QuadWorkflowResult result = MakeQuadMesh(ring, request);
    EXPECT_TRUE(result.singularities.empty());
    EXPECT_GT(result.quads.quality.jacobian.min, 0.9);
  }
}

TEST(CurveSymmetry, ComparesCircles)
{
  for (const int count : { 3, 5, 6, 7 })
  {
    for (const double angle : { 0.0, 0.3 })
    {
      const PlanarDomain domain = Transformed(DiskWithHoles(count), angle);
      const SymmetryGroup group = FindCurveSymmetries(domain);
      EXPECT_LT(FindSymmetries(domain).order, count) << count;
      EXPECT_EQ(group.order, count);
      ASSERT_TRUE(group.reflects);
      const double turns = (group.axis - angle) * count / Pi;
      EXPECT_NEAR(turns, std::round(turns), 1e-3);
    }
  }
}

TEST(CurveSymmetry, NeedsEqualHoles)
{
  PlanarDomain domain = DiskWithHoles(5);
  for (Point& point : domain.loops[1]) // the leftmost one
  {
    point *= 1.02;
  }
  EXPECT_EQ(FindCurveSymmetries(domain).order, 1);
  EXPECT_EQ(FindCurveSymmetries(DiskWithHoles(5)).order, 5);
}

TEST(CurveSymmetry, DoesNotMoveFromTheBoundary)
{
  // The right side leans by less than is seen; a mean of both sides is on neither.
  const PlanarDomain box =
    MakePlanarDomain({ { { -1.0, -0.5 }, { 1.002, -0.5 }, { 1.0, 0.5 }, { -1.0, 0.5 } } });
  const SymmetryGroup group = FindCurveSymmetries(box);
  ASSERT_TRUE(group.reflects);
  const Configuration given = { { { -1.0, 0.3 }, -1, 0.0 }, { { 1.0004, 0.3 }, -1, 0.0 } };
  Configuration moved = given;
  EXPECT_FALSE(MakeSymmetric(box, group, 0.02, moved));
  EXPECT_EQ(moved[0].position, given[0].position);
  moved = { { { -0.5, 0.3 }, -1, 0.0 }, { { 0.5, 0.3 }, -1, 0.0 } };
  EXPECT_TRUE(MakeSymmetric(box, group, 0.02, moved));
}

TEST(CurveSymmetry, OfPolygonsIsThatOfVertices)
{
  for (const PlanarDomain& domain :
    { MakePlanarDomain({ RegularPolygon(5), RegularPolygon(4, 0.2, { 0.3, 0.1 }) }),
      MakePlanarDomain({ RegularPolygon(6) }), MakePlanarDomain({ RegularPolygon(90) }) })
  {
    const SymmetryGroup exact = FindSymmetries(domain);
    const SymmetryGroup group = FindCurveSymmetries(domain);
    EXPECT_EQ(group.order, exact.order);
    EXPECT_EQ(group.reflects, exact.reflects);
  }
}

TEST(ExactSymmetry, RestoresWhatRoundingTook)
{
  Loop plate = { { -3.0, -2.0 }, { 0.7, -2.0 }, { 3.0, -2.0 }, { 3.0, 2.0 }, { -3.0, 2.0 } };
  const PlanarDomain domains[] = { MakePlanarDomain({ plate, RegularPolygon(60, 0.5, { -1.5, 0.0 }),
                                     RegularPolygon(60, 0.5, { 1.5, 0.0 }),
                                     RegularPolygon(60, 0.5) }),
    MakePlanarDomain({ RegularPolygon(60), RegularPolygon(24, 0.3, { 0.4, 0.0 }) }),
    MakePlanarDomain({ RegularPolygon(7) }) };
  for (const PlanarDomain& given : domains)
  {
    for (const double angle : { 0.0, 0.3 })
    {
      const PlanarDomain moved = Transformed(given, angle);
      const PlanarDomain rounded = Rounded(moved);
      const SymmetryGroup expected = FindSymmetries(moved);
      EXPECT_LT(FindSymmetries(rounded).Elements().size(), expected.Elements().size());
      const PlanarDomain exact = WithExactSymmetries(rounded);
      EXPECT_EQ(FindSymmetries(exact).Elements().size(), expected.Elements().size());
      EXPECT_LT(LargestMove(exact, rounded), 1e-6 * moved.Diagonal());
      EXPECT_EQ(WithExactSymmetries(exact).loops, exact.loops);
    }
  }
}

TEST(ExactSymmetry, LeavesOthersAlone)
{
  const PlanarDomain exact = DiskWithHoles(4);
  EXPECT_EQ(WithExactSymmetries(exact).loops, exact.loops);
  PlanarDomain moved = DiskWithHoles(4);
  moved.loops[1][3] += Point(1e-4, 0.0);
  EXPECT_EQ(WithExactSymmetries(moved).loops, moved.loops);
}

TEST(CurveSymmetry, ANarrowNotchUpToTheCentreIsNoSymmetry)
{
  // All of its points have images on the boundary of the square under the reflection in x = 0.
  const double half = 1e-4;
  const SymmetryGroup group = FindCurveSymmetries(MakePlanarDomain(
    { { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 }, { -1, half }, { 0, 0 }, { -1, -half } } }));
  EXPECT_EQ(group.order, 1);
  EXPECT_TRUE(group.reflects);
}
}
