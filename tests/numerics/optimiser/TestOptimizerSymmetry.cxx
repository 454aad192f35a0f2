// The optimiser keeps the symmetry of its start unless that leads to a saddle.

#include "ConfigurationSymmetry.h"
#include "MakePlanarDomain.h"
#include "OptimizerSymmetry.h"
#include "SingularityOptimizer.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace crossfield::test
{
namespace
{
Loop Rectangle(double width, double height)
{
  return { { 0.0, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } };
}

/// Returns the number of symmetries of a domain that a configuration has, to 1e-9 of the diagonal.
std::size_t SymmetryCount(const PlanarDomain& domain, const Configuration& configuration)
{
  return MatchSymmetry(configuration, FindSymmetries(domain), 1e-9 * domain.Diagonal())
    .elements.size();
}

OptimizerResult Optimize(const PlanarDomain& domain, const Configuration& start)
{
  OptimizerOptions options;
  options.meshSize = domain.Diagonal() / 30.0;
  const OptimizerResult result = OptimizeSingularities(domain, start, options);
  EXPECT_TRUE(result.converged) << result.reason;
  return result;
}

TEST(OptimizerSymmetry, KeepsSymmetriesOfRegularPolygons)
{
  // Corners below 135° take a quarter each; the remaining quarters are inside.
  const Point centre(2.0, -1.0);
  for (const auto& [sides, inside, quarters] :
    { std::tuple(3, 1, 1), std::tuple(5, 1, -1), std::tuple(6, 2, -1), std::tuple(16, 4, 1) })
  {
    SCOPED_TRACE(sides);
    const PlanarDomain polygon = MakePlanarDomain({ RegularPolygon(sides, 1.0, centre) });
    Configuration start;
    for (int i = 0; i < inside; ++i)
    {
      // In the last polygon, which is almost round, positions at the vertices would be a saddle,
      // and the result would be arbitrary.
      const double angle = 2.0 * Pi * i / inside + (sides == 16 ? Pi / sides : 0.0);
      const double radius = inside == 1 ? 0.0 : 0.6;
      start.push_back({ centre + radius * Point(std::cos(angle), std::sin(angle)), quarters, 0.0 });
    }
    const std::size_t before = SymmetryCount(polygon, start);
    EXPECT_GE(before, 2u);
    const OptimizerResult result = Optimize(polygon, start);
    EXPECT_EQ(SymmetryCount(polygon, result.configuration), before);
  }
}

/// Returns four singularities of −1 around each of two holes side by side; the second half is the
/// image of the first.
Configuration AroundTwoHoles(double shift)
{
  Configuration around;
  for (int i = 0; i < 8; ++i)
  {
    const Point centre(i < 4 ? 1.5 : 4.5, 1.0);
    const double angle = 0.25 * Pi + 0.5 * Pi * i;
    around.push_back({ centre + 0.55 * Point(std::cos(angle), std::sin(angle)), -1, 0.0 });
  }
  around[5].position.x() += shift;
  return around;
}

TEST(OptimizerSymmetry, KeepsSymmetriesOfPlateAndRemovesDefects)
{
  const PlanarDomain plate = MakePlanarDomain({ Rectangle(6.0, 2.0),
    RegularPolygon(40, 0.4, { 1.5, 1.0 }), RegularPolygon(40, 0.4, { 4.5, 1.0 }) });
  const Configuration start = AroundTwoHoles(0.0);
  ASSERT_EQ(SymmetryCount(plate, start), 4u);
  const OptimizerResult result = Optimize(plate, start);
  EXPECT_EQ(SymmetryCount(plate, result.configuration), 4u);
  ASSERT_EQ(result.holonomyDefect.size(), 2u);
  for (const double defect : result.holonomyDefect)
  {
    EXPECT_NEAR(defect, 0.0, 1e-6);
  }
  // Another start ends at approximately the same positions, up to the error of the mesh.
  const OptimizerResult forced = Optimize(plate, AroundTwoHoles(0.1));
  EXPECT_LT(SymmetryCount(plate, forced.configuration), 4u)
    << "an asymmetric start is not symmetrised";
  EXPECT_NEAR(forced.energyAfter, result.energyAfter, 0.01 * std::abs(result.energyAfter));
}

TEST(OptimizerSymmetry, ReflectionsNegateDefectsOfIslands)
{
  const PlanarDomain plate = MakePlanarDomain({ Rectangle(6.0, 2.0),
    RegularPolygon(40, 0.4, { 1.5, 1.0 }), RegularPolygon(40, 0.4, { 4.5, 1.0 }) });
  DrillOptions options;
  options.meshSize = 0.3;
  const PointPotential potential = PointPotentialOn(DrillHoles(plate, {}, options), {}, -8);
  const OptimizerSymmetry all = FindKeptSymmetry(potential, plate, AroundTwoHoles(0.0));
  EXPECT_EQ(all.positions.elements.size(), 4u);
  EXPECT_LT(all.defects.norm(), 1e-15);
  // In a configuration with the half turn alone, the two islands have the same defect.
  Configuration turned = AroundTwoHoles(0.0);
  turned[0].position += Point(0.1, 0.03);
  turned[6].position -= Point(0.1, 0.03);
  const OptimizerSymmetry half = FindKeptSymmetry(potential, plate, turned);
  EXPECT_EQ(half.positions.elements.size(), 2u);
  EXPECT_LT((half.defects - Eigen::MatrixXd::Constant(2, 2, 0.5)).norm(), 1e-15);
  // With a quarter index chosen on the boundary, the symmetries of the domain are not those of the
  // problem.
  const PointPotential chosen = PointPotentialOn(
    DrillHoles(plate, {}, options), { { Point(0.0, 0.0), 0 }, { Point(6.0, 0.0), 2 } }, -8);
  EXPECT_TRUE(FindKeptSymmetry(chosen, plate, AroundTwoHoles(0.0)).IsTrivial());
}

TEST(OptimizerSymmetry, LeavesSymmetricSaddle)
{
  // Four singularities on the axis of a disk cannot leave it by symmetric steps, but two pairs
  // beside it have a much lower energy.
  Configuration line;
  for (const double x : { -0.7, -0.25, 0.25, 0.7 })
  {
    line.push_back({ { x, 0.0 }, 1, 0.0 });
  }
  const OptimizerResult result = Optimize(Builtin("disk", 0.1), line);
  EXPECT_TRUE(AnyHas(result.events, "no longer follow a symmetry of the domain"));
  EXPECT_NEAR(result.energyAfter, -7.2962, 0.05);
}

TEST(OptimizerSymmetry, MovesStartAwayFromBoundarySymmetrically)
{
  const PlanarDomain polygon = MakePlanarDomain({ RegularPolygon(16, 1.0) });
  Configuration start;
  for (int i = 0; i < 4; ++i)
  {
    const double angle = 0.5 * Pi * i + Pi / 16.0;
    start.push_back({ 0.978 * Point(std::cos(angle), std::sin(angle)), 1, 0.0 });
  }
  const OptimizerResult result = Optimize(polygon, start);
  EXPECT_TRUE(AnyHas(result.events, "to keep the clearance"));
  EXPECT_EQ(SymmetryCount(polygon, result.configuration), SymmetryCount(polygon, start));
}
}
}
