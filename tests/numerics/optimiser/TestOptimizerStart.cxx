#include "DomainQueries.h"
#include "MakePlanarDomain.h"
#include "OptimizerStart.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns a wedge of unit length with its sharp corner at the origin and its bisector along x.
PlanarDomain Wedge(double angle)
{
  const Point side = Point(std::cos(0.5 * angle), std::sin(0.5 * angle));
  return PlanarDomain{ { { Point::Zero(), { side.x(), -side.y() }, side } } };
}

TEST(OptimizerStart, LeavesSharpCorner)
{
  for (const double degrees : { 20.0, 45.0, 80.0, 130.0 })
  {
    const PlanarDomain wedge = Wedge(degrees * Pi / 180.0);
    const double height = std::cos(0.5 * degrees * Pi / 180.0);
    const double inradius = height * std::tan(0.5 * degrees * Pi / 180.0) /
      (1.0 + std::sqrt(1.0 + std::pow(std::tan(0.5 * degrees * Pi / 180.0), 2)));
    for (const double along : { 1e-5, 1e-3, 0.05 })
    {
      SCOPED_TRACE(std::to_string(degrees) + " degrees at " + std::to_string(along));
      const double across = 0.2 * along * std::tan(0.5 * degrees * Pi / 180.0);
      Configuration configuration = { { { along, across }, 1, 0.0 } };
      const double clearance = 0.2 * inradius;
      EXPECT_EQ(EnforceClearance(wedge, clearance, configuration), clearance);
      EXPECT_GE(SignedDistance(configuration[0].position, wedge), 1.2 * clearance);
      // No singularity moves farther than necessary, except for the overshoot of pushes.
      EXPECT_LE(configuration[0].position.x(),
        std::max(along, 2.0 * clearance / std::sin(0.5 * degrees * Pi / 180.0)));
    }
  }
}

TEST(OptimizerStart, KeepsPositionsThatAreClearOrCannotBe)
{
  const PlanarDomain wedge = Wedge(Pi / 3.0);
  const double inradius = std::sqrt(3.0) / 6.0;
  const Configuration centre = { { { std::sqrt(3.0) / 3.0, 0.0 }, 1, 0.0 } };
  Configuration configuration = centre;
  EXPECT_EQ(EnforceClearance(wedge, 0.8 * inradius, configuration), 0.8 * inradius);
  EXPECT_EQ(configuration[0].position, centre[0].position);

  const Configuration corner = { { { 0.1, 0.0 }, 1, 0.0 } };
  configuration = corner;
  EXPECT_NEAR(
    EnforceClearance(wedge, inradius, configuration), 0.5 * 0.1 * std::sin(Pi / 6.0), 1e-12);
  EXPECT_EQ(configuration[0].position, corner[0].position);
}

TEST(OptimizerStart, KeepsMoreDistanceWhereTheClearanceHasAFactor)
{
  const PlanarDomain square =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } } });
  constexpr double Clearance = 0.02;
  Configuration configuration = { { { 0.5, 0.03 }, 1 }, { { 0.5, 0.96 }, 1 } };
  EXPECT_EQ(
    EnforceClearance(square, Clearance, configuration, { { 10.0, 1.0, 1.0, 1.0 } }), Clearance);
  EXPECT_GE(configuration[0].position.y(), 1.2 * 10.0 * Clearance - 1e-12);
  EXPECT_EQ(configuration[1].position, Point(0.5, 0.96));
}

TEST(OptimizerStart, SeparatesSingularities)
{
  const PlanarDomain wedge = Wedge(Pi / 3.0);
  Configuration configuration = { { { 0.55, 0.01 }, 1, 0.0 }, { { 0.551, 0.01 }, -1, 0.0 },
    { { 0.55, -0.02 }, 1, 0.0 } };
  constexpr double Clearance = 0.05;
  EXPECT_EQ(EnforceClearance(wedge, Clearance, configuration), Clearance);
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    EXPECT_GE(SignedDistance(configuration[i].position, wedge), 1.2 * Clearance);
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_GE((configuration[i].position - configuration[j].position).norm(), 1.2 * Clearance);
    }
  }
}
}
}
