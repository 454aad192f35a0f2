#include "PatchColours.h"

#include "LayoutDesign.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crossfield::test
{
namespace
{
/// Returns eight k = 1 and four k = −1 on the unit disk, the first moved.
Configuration Twelve(const Point& move)
{
  Configuration configuration;
  for (int i = 0; i < 12; ++i)
  {
    const bool outside = i < 8;
    const double angle = outside ? Pi * (i + 0.1) / 4.0 : Pi * (i + 0.37) / 2.0;
    configuration.push_back(
      { (outside ? 0.7 : 0.35) * Point(std::cos(angle), std::sin(angle)), outside ? 1 : -1 });
  }
  configuration[0].position += move;
  return configuration;
}

TEST(PatchColours, MeasuresPatches)
{
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  const LayoutDesign design = DesignLayout(disk, Twelve({ 0.0, 0.0 }));
  ASSERT_EQ(design.colours.size(), design.layouts.Single().tMesh.patches.size());
  double area = 0.0;
  SpacePoint moment = SpacePoint::Zero();
  for (const PatchColour& patch : design.colours)
  {
    EXPECT_GT(patch.area, 0.0);
    EXPECT_GE(patch.colour, 0);
    EXPECT_LT(patch.colour, PatchColourCount);
    area += patch.area;
    moment += patch.area * patch.centre;
  }
  EXPECT_NEAR(area, disk.GetDomain().Area(), 1e-9);
  EXPECT_LT(moment.norm(), 1e-9) << "the centroid of the disk";
}

TEST(PatchColours, NeighboursDiffer)
{
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  const LayoutDesign design = DesignLayout(disk, Twelve({ 0.0, 0.0 }));
  int same = 0;
  int pairs = 0;
  for (const TArc& arc : design.layouts.Single().tMesh.arcs)
  {
    const auto half =
      static_cast<std::size_t>(2 * (&arc - design.layouts.Single().tMesh.arcs.data()));
    const int left = design.layouts.Single().tMesh.halfEdges[half].patch;
    const int right = design.layouts.Single().tMesh.halfEdges[half + 1].patch;
    if (left >= 0 && right >= 0 && left != right)
    {
      ++pairs;
      same += design.colours[static_cast<std::size_t>(left)].colour ==
          design.colours[static_cast<std::size_t>(right)].colour
        ? 1
        : 0;
    }
  }
  EXPECT_GT(pairs, 40);
  EXPECT_LE(same, pairs / 50);
}

TEST(PatchColours, DoNotDependOnTheOrderOfPatches)
{
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  LayoutDesign design = DesignLayout(disk, Twelve({ 0.0, 0.0 }));
  // The same patches in the reverse order keep their colours.
  std::vector<PatchColour> earlier = design.colours;
  std::reverse(earlier.begin(), earlier.end());
  const std::vector<PatchColour> again = ColourPatches(design.layouts.Single().tMesh, earlier);
  for (std::size_t i = 0; i < again.size(); ++i)
  {
    EXPECT_EQ(again[i].colour, design.colours[i].colour) << i;
  }
}

TEST(PatchColours, ArePreservedBySmallMoves)
{
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  LayoutOptions options;
  Point place(0.0, 0.0);
  Random random(31);
  int kept = 0;
  int patches = 0;
  for (int step = 0; step < 40; ++step)
  {
    const LayoutDesign design = DesignLayout(disk, Twelve(place), options);
    // Sample every patch of the step before: the patch that has its centre now.
    for (const PatchColour& before : options.earlier)
    {
      const auto nearest = std::min_element(design.colours.begin(), design.colours.end(),
        [&](const PatchColour& a, const PatchColour& b)
        { return (a.centre - before.centre).norm() < (b.centre - before.centre).norm(); });
      ++patches;
      kept += nearest->colour == before.colour ? 1 : 0;
    }
    options.earlier = design.colours;
    place = 0.9 * place + 0.01 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
  }
  EXPECT_GT(patches, 1000);
  EXPECT_GT(kept, 0.97 * patches) << kept << " of " << patches;
}
}
}
