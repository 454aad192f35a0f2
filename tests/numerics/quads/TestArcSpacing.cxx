// Widths of strips beside arcs with a prescribed number of edges.

#include "ArcSpacing.h"

#include "MakePlanarDomain.h"
#include "Quantisation.h"
#include "Support.h"
#include "TMeshChecks.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the numbers of edges of size h on the arcs of a T-mesh.
std::vector<int> CountsOf(const TMesh& mesh, double h)
{
  return Quantise(mesh, MakeQuantisationProblem(mesh, h), SearchEffort::Quick).counts;
}

/// A plate with a hole in the middle, whose arcs meet in T-junctions.
TMesh Plate()
{
  const PlanarDomain plate = MakePlanarDomain({ { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 0, 2 } },
    { { 1, 0.5 }, { 1, 1 }, { 1.5, 1 }, { 1.5, 0.5 } } });
  return LinesOf(plate, {}, 0.1);
}

TEST(ArcSpacing, EveryArcIsDividedInIncreasingOrder)
{
  const TMesh mesh = Plate();
  const std::vector<int> counts = CountsOf(mesh, 0.07);
  for (int arc = 0; arc < static_cast<int>(mesh.arcs.size()); ++arc)
  {
    const std::vector<std::vector<double>> spacing = GradualSpacing(mesh, counts, { arc });
    const std::vector<std::vector<double>> equal = EqualSpacing(mesh, counts);
    for (std::size_t a = 0; a < spacing.size(); ++a)
    {
      EXPECT_EQ(spacing[a].size(), equal[a].size());
      EXPECT_EQ(spacing[a].front(), 0.0);
      EXPECT_EQ(spacing[a].back(), mesh.arcs[a].length);
      EXPECT_TRUE(std::is_sorted(spacing[a].begin(), spacing[a].end()));
    }
  }
}

TEST(ArcSpacing, IsEqualWhereNumbersAreThoseOfTheMap)
{
  // Sides are multiples of the size, so that all strips are equally wide.
  const TMesh mesh = Plate();
  const std::vector<int> counts = CountsOf(mesh, 0.05);
  const std::vector<std::vector<double>> equal = EqualSpacing(mesh, counts);
  const std::vector<std::vector<double>> spacing = GradualSpacing(mesh, counts, { 0 });
  for (std::size_t a = 0; a < equal.size(); ++a)
  {
    for (std::size_t j = 0; j < equal[a].size(); ++j)
    {
      EXPECT_NEAR(spacing[a][j], equal[a][j], 1e-9);
    }
  }
}

TEST(ArcSpacing, WidthsGrowFromAPrescribedArc)
{
  // An L: the strips that end on the lower side of the foot are four times as narrow as the map has
  // them.
  const PlanarDomain domain =
    MakePlanarDomain({ { { 0, 0 }, { 4, 0 }, { 4, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } } });
  const TMesh mesh = LinesOf(domain, {}, 0.1);
  constexpr int Fine = 80; // across the first unit of the lower side
  std::vector<int> counts;
  std::vector<int> prescribed;
  for (std::size_t a = 0; a < mesh.arcs.size(); ++a)
  {
    const TArc& arc = mesh.arcs[a];
    const Point middle = 0.5 * (arc.polyline.front() + arc.polyline.back()).head<2>();
    const bool isHorizontal = std::abs(arc.polyline.back().y() - arc.polyline.front().y()) < 1e-6;
    const bool isFine = isHorizontal && middle.x() < 1.0;
    counts.push_back(isFine ? Fine : static_cast<int>(std::lround(arc.length / 0.05)));
    if (isFine && middle.y() > 1.5)
    {
      prescribed.push_back(static_cast<int>(a));
    }
  }
  ASSERT_EQ(prescribed.size(), 1U);
  const std::vector<std::vector<double>> spacing = GradualSpacing(mesh, counts, prescribed);
  int compared = 0;
  for (std::size_t a = 0; a < mesh.arcs.size(); ++a)
  {
    const TArc& arc = mesh.arcs[a];
    const double x = 0.5 * (arc.polyline.front().x() + arc.polyline.back().x());
    if (std::abs(arc.length - 3.0) < 1e-6 && std::abs(x - 2.5) < 1e-6)
    {
      std::vector<double> widths;
      for (std::size_t j = 1; j < spacing[a].size(); ++j)
      {
        widths.push_back(spacing[a][j] - spacing[a][j - 1]);
      }
      if (arc.polyline.front().x() > arc.polyline.back().x())
      {
        std::reverse(widths.begin(), widths.end());
      }
      EXPECT_NEAR(
        widths[0], 1.2 / Fine, 0.15 * widths[0]); // all lengthen so that they fill the arc
      for (std::size_t j = 1; j < widths.size(); ++j)
      {
        EXPECT_GE(widths[j], widths[j - 1] * (1.0 - 1e-9));
        EXPECT_LE(widths[j], widths[j - 1] * 1.2 * (1.0 + 1e-9));
      }
      ++compared;
    }
  }
  EXPECT_GE(compared, 2); // the lower and the upper side of the foot
}
}
}
