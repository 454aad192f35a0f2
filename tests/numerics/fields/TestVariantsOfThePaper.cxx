// Results that the paper shows for each variant, "Analysis of the numerical results".
#include "FieldSingularities.h"
#include "GinzburgLandau.h"
#include "MakePlanarDomain.h"
#include "PerforatedSolve.h"
#include "Support.h"
#include "VariantSolve.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace crossfield::test
{
namespace
{
std::vector<FieldSingularity> Find(
  const TriangleMesh& mesh, const SolvedField& field, bool corners = false)
{
  FieldSingularityOptions options;
  options.corners = corners;
  return FindFieldSingularities({ ShareTopology(mesh), field.u }, options);
}

PlanarDomain Ring(double innerRadius, double meshSize)
{
  return MakePlanarDomain({ RegularPolygon(static_cast<int>(2.0 * Pi / meshSize)),
    RegularPolygon(static_cast<int>(2.0 * Pi * innerRadius / meshSize), innerRadius) });
}
}

TEST(VariantsOfThePaper, AMinusOneOnTheQuarterDiskCausesTwoPlusOnes)
{
  // Figure normHole: the sum of the corners is three, so the interior sum has to be one.
  for (const double radius : { 0.05, 0.1, 0.2 })
  {
    SCOPED_TRACE(radius);
    const Point place(0.42, 0.42);
    const TriangleMesh mesh =
      DrillMesh(Builtin("quarter-disk", 0.04), { { place, -1, radius } }, 0.04, DrillMode::Imprint);
    PerforatedOptions options;
    options.unitHoles = true;
    const SolvedField field = SolvePerforated(ShareTopology(mesh), options);
    EXPECT_TRUE(field.converged);
    ASSERT_EQ(field.holes.size(), 1u);
    EXPECT_EQ(field.holes[0].degree, -1);
    EXPECT_NEAR(field.holes[0].minimumNorm, 1.0, 1e-9);
    EXPECT_NEAR(field.holes[0].maximumNorm, 1.0, 1e-9);
    EXPECT_EQ(field.unwantedSingularities, 2);
    EXPECT_EQ(field.count.requiredInteriorQuarters, 1);
    EXPECT_FALSE(field.count.Consistent());
    int inside = 0;
    int outside = 0;
    int corners = 0;
    for (const FieldSingularity& singularity : Find(mesh, field, true))
    {
      if (singularity.place == FieldSingularity::Place::OuterLoop)
      {
        corners += singularity.quarterIndex;
      }
      else if ((singularity.position - place).norm() < radius)
      {
        inside += singularity.quarterIndex;
        EXPECT_EQ(singularity.quarterIndex, -1);
      }
      else
      {
        outside += singularity.quarterIndex;
        EXPECT_EQ(singularity.quarterIndex, 1);
      }
    }
    EXPECT_EQ(inside, -1);
    EXPECT_EQ(outside, 2);
    EXPECT_EQ(corners, 3);
  }
}

TEST(VariantsOfThePaper, SingleTrianglesWorkNearTheReferenceOnly)
{
  // Figure oneTriangle; the four singularities of the reference are at distance 0.850.
  constexpr double Size = 0.05;
  PerforatedOptions options;
  options.epsilon = Size;
  for (const double distance : { 0.85, 0.7, 0.3 })
  {
    SCOPED_TRACE(distance);
    const TriangleMesh mesh = DrillMesh(
      Builtin("disk", Size), OnCircle(4, distance, Pi / 4.0, 1, 0.0), Size, DrillMode::Triangle);
    const SolvedField field = SolvePerforated(ShareTopology(mesh), options);
    EXPECT_TRUE(field.converged);
    const bool isNear = distance > 0.5;
    EXPECT_EQ(field.degreesReached, isNear);
    EXPECT_EQ(field.wrongDegrees == 0, isNear);
    EXPECT_EQ(field.unwantedSingularities == 0, isNear);
    // Far from these positions the singularities of the reference appear instead.
    const auto found = Find(mesh, field);
    ASSERT_EQ(found.size(), 4u);
    for (const FieldSingularity& singularity : found)
    {
      EXPECT_EQ(singularity.quarterIndex, 1);
      EXPECT_NEAR(singularity.position.norm(), isNear ? distance : 0.85, 1.5 * Size);
    }
  }
}

TEST(VariantsOfThePaper, EightSingularitiesOfTheRingCanBeImposed)
{
  constexpr double Size = 0.025;
  constexpr double Epsilon = 0.01;
  for (const double innerRadius : { 0.4, 0.46 })
  {
    SCOPED_TRACE(innerRadius);
    const PlanarDomain ring = Ring(innerRadius, Size);
    const TriangleMesh plain = DrillMesh(ring, {}, Size);
    GinzburgLandauOptions reference;
    reference.epsilon = Epsilon;
    const GinzburgLandauField radial = SolveGinzburgLandau(ShareTopology(plain), reference);
    reference.start = GinzburgLandauStart::Constant;
    const GinzburgLandauField broken = SolveGinzburgLandau(ShareTopology(plain), reference);
    EXPECT_TRUE(radial.converged && broken.converged);
    EXPECT_EQ(radial.unwantedSingularities, 0);
    EXPECT_EQ(broken.unwantedSingularities, 8);
    // The radial field u = e^{4iα}: ½ ∫ |4/r|².
    EXPECT_NEAR(radial.energy, 16.0 * Pi * std::log(1.0 / innerRadius), 0.02 * radial.energy);
    EXPECT_GT(broken.energy, 2.0 * radial.energy);

    Configuration eight;
    for (const FieldSingularity& singularity : Find(plain, broken))
    {
      eight.push_back({ singularity.position, singularity.quarterIndex, 0.02 });
    }
    ASSERT_EQ(eight.size(), 8u);
    EXPECT_EQ(TotalQuarters(eight), 0);
    const TriangleMesh drilled = DrillMesh(ring, eight, Size);
    PerforatedOptions options;
    options.unitHoles = true;
    const SolvedField imposed = SolvePerforated(ShareTopology(drilled), options);
    options = PerforatedOptions();
    options.epsilon = Epsilon;
    const SolvedField penalised = SolvePerforated(ShareTopology(drilled), options);
    for (const SolvedField* field : { &imposed, &penalised })
    {
      EXPECT_TRUE(field->converged);
      EXPECT_EQ(field->wrongDegrees, 0);
      EXPECT_EQ(field->unwantedSingularities, 0);
    }
    // Holes remove the cores; without the penalty the norm may decrease as well.
    EXPECT_LT(penalised.energy, broken.energy);
    EXPECT_LT(imposed.energy, penalised.energy);
  }
}

TEST(VariantsOfThePaper, TheFlatEllipseKeepsARectangleOfHoles)
{
  // Figure ellipse, semi-axes 3 and 0.6.
  constexpr double Size = 0.06;
  Loop ellipse;
  for (const Point& point : RegularPolygon(240))
  {
    ellipse.emplace_back(3.0 * point.x(), 0.6 * point.y());
  }
  const PlanarDomain domain = MakePlanarDomain({ ellipse });
  const TriangleMesh plain = DrillMesh(domain, {}, Size);
  GinzburgLandauOptions reference;
  reference.epsilon = Size;
  const GinzburgLandauField line = SolveGinzburgLandau(ShareTopology(plain), reference);
  EXPECT_TRUE(line.converged);
  const auto onLine = Find(plain, line);
  ASSERT_EQ(onLine.size(), 4u);
  for (const FieldSingularity& singularity : onLine)
  {
    EXPECT_LT(std::abs(singularity.position.y()), 0.25 * Size);
  }

  Configuration rectangle;
  for (const double x : { -1.8, 1.8 })
  {
    for (const double y : { -0.25, 0.25 })
    {
      rectangle.push_back({ Point(x, y), 1, 0.08 });
    }
  }
  const TriangleMesh drilled = DrillMesh(domain, rectangle, Size);
  PerforatedOptions options;
  const SolvedField relaxed = SolvePerforated(ShareTopology(drilled), options);
  EXPECT_TRUE(relaxed.converged);
  EXPECT_EQ(relaxed.wrongDegrees, 0);
  // At this distance from the reference positions, |u| vanishes next to the holes unless it is
  // constrained to one.
  EXPECT_GT(relaxed.unwantedSingularities, 0);
  options.method = PerforatedMethod::UnitNorm;
  const SolvedField field = SolvePerforated(ShareTopology(drilled), options);
  EXPECT_TRUE(field.converged);
  EXPECT_EQ(field.wrongDegrees, 0);
  EXPECT_EQ(field.unwantedSingularities, 0);
  EXPECT_TRUE(Find(drilled, field).empty());
}

TEST(VariantsOfThePaper, PenaltyCompensatesForInconsistentSets)
{
  constexpr double Size = 0.07;
  const PlanarDomain disk = Builtin("disk", Size);
  const TriangleMesh five = DrillMesh(disk, OnCircle(5, 0.6, 0.3, 1, 0.1), Size);
  EXPECT_TRUE(Refuses([&] { SolvePerforated(ShareTopology(five)); },
    { "add up to 5", "requires 4" }, Error::Kind::Inconsistent));
  PerforatedOptions options;
  options.epsilon = Size;
  const SolvedField field = SolvePerforated(ShareTopology(five), options);
  EXPECT_TRUE(field.converged);
  EXPECT_EQ(field.wrongDegrees, 0);
  EXPECT_EQ(field.unwantedSingularities, 1);
  const auto found = Find(five, field);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].quarterIndex, -1);

  // Figure holeAndGL: three +1 and four −1, sum −1; additional singularities compensate for it.
  Configuration wrong = { { Point(-0.6, 0.6), 1, 0.1 }, { Point(-0.6, -0.6), 1, 0.1 },
    { Point(0.6, -0.35), 1, 0.1 }, { Point(-0.2, 0.2), -1, 0.1 }, { Point(-0.2, -0.2), -1, 0.1 },
    { Point(0.5, -0.62), -1, 0.05 }, { Point(0.6, 0.6), -1, 0.1 } };
  const TriangleMesh mesh = DrillMesh(disk, wrong, Size);
  options.reduced.maximumIterations = 300;
  const SolvedField solved = SolvePerforated(ShareTopology(mesh), options);
  EXPECT_TRUE(solved.converged);
  EXPECT_EQ(solved.wrongDegrees, 0);
  int sum = 0;
  int size = 0;
  for (const FieldSingularity& singularity : Find(mesh, solved))
  {
    sum += singularity.quarterIndex;
    size += std::abs(singularity.quarterIndex);
  }
  EXPECT_EQ(sum, 5);
  EXPECT_EQ(size, solved.unwantedSingularities);
}
}
