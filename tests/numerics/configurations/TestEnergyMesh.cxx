#include "EnergyMesh.h"

#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
TEST(EnergyMesh, LengthsScaleBelowDefaultSize)
{
  const PlanarDomain disk = Builtin("disk", 0.1);
  const double usual = disk.Diagonal() / 40.0;
  const Configuration holes = OnCircle(4, 0.6, 0.3, 1, 0.1);
  for (const double size : { 0.0, usual, 3.0 * usual })
  {
    const DrillOptions options = DrillForEnergies(disk, holes, size);
    EXPECT_EQ(options.meshSize, size > 0.0 ? size : usual);
    EXPECT_EQ(options.gradation, DrillOptions().gradation);
    EXPECT_EQ(options.minimumHoleEdges, DrillOptions().minimumHoleEdges);
    EXPECT_TRUE(options.refinements.empty());
  }
  const DrillOptions fine = DrillForEnergies(disk, holes, usual / 8.0);
  EXPECT_NEAR(fine.gradation, DrillOptions().gradation / 8.0, 1e-12);
  EXPECT_NEAR(fine.minimumHoleEdges, 8 * DrillOptions().minimumHoleEdges, 1);
  // The dense matrices of edges of holes remain small: at most 4,096 edges on all holes.
  EXPECT_EQ(DrillForEnergies(disk, holes, usual / 1e3).minimumHoleEdges, 1024);
  EXPECT_EQ(DrillForEnergies(disk, OnCircle(500, 0.6, 0.3, 1, 0.001), usual / 1e3).minimumHoleEdges,
    DrillOptions().minimumHoleEdges);
  EXPECT_EQ(
    DrillForEnergies(disk, {}, usual / 8.0).minimumHoleEdges, DrillOptions().minimumHoleEdges);
}

TEST(EnergyMesh, RefinesReEntrantCorners)
{
  const PlanarDomain shape = LShape();
  const double diagonal = shape.Diagonal();
  for (const double fraction : { 1.0 / 40.0, 1.0 / 160.0 })
  {
    const DrillOptions options = DrillForEnergies(shape, {}, fraction * diagonal);
    ASSERT_EQ(options.refinements.size(), 1u); // of six corners
    EXPECT_EQ(options.refinements[0].position, Point(1.0, 1.0));
    EXPECT_NEAR(options.refinements[0].size, diagonal * std::pow(fraction, 1.5), 1e-12); // β = 2/3
  }
}
}
}
