// What rows do at corners: quarter indices of treatments, their bounds and their precedence.

#include "CornerRows.h"

#include "MakePlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
constexpr double Degree = Pi / 180.0;

Corner CornerOf(double degrees)
{
  Corner corner;
  corner.position = Point(1.0, 2.0);
  corner.angle = degrees * Degree;
  return corner;
}

std::vector<std::string> NoSides(const Corner&)
{
  return {};
}

CornerRule At(const Point& position, CornerRows rows)
{
  CornerRule rule;
  rule.position = position;
  rule.rows = rows;
  return rule;
}

TEST(CornerRows, DefaultsFollowTheAngle)
{
  EXPECT_EQ(DefaultRows(60.0 * Degree), CornerRows::End);
  EXPECT_EQ(DefaultRows(90.0 * Degree), CornerRows::End);
  EXPECT_EQ(DefaultRows(135.0 * Degree), CornerRows::End);
  EXPECT_EQ(DefaultRows(136.0 * Degree), CornerRows::Turn);
  EXPECT_EQ(DefaultRows(270.0 * Degree), CornerRows::Turn);
  EXPECT_EQ(DefaultRows(315.0 * Degree), CornerRows::Turn);
  EXPECT_EQ(DefaultRows(316.0 * Degree), CornerRows::Leave);
  EXPECT_EQ(DefaultRows(350.0 * Degree), CornerRows::Leave);
}

TEST(CornerRows, GiveQuarterIndices)
{
  EXPECT_EQ(QuarterIndexFor(CornerOf(90.0), CornerRows::End), 1);
  EXPECT_EQ(QuarterIndexFor(CornerOf(30.0), CornerRows::End), 1);
  EXPECT_EQ(QuarterIndexFor(CornerOf(270.0), CornerRows::Turn), 0);
  EXPECT_EQ(QuarterIndexFor(CornerOf(150.0), CornerRows::Turn), 0);
  EXPECT_EQ(QuarterIndexFor(CornerOf(270.0), CornerRows::Leave), -1);
  EXPECT_EQ(QuarterIndexFor(CornerOf(345.0), CornerRows::Leave), -2);
  // Every default is possible.
  for (int degrees = 5; degrees < 360; degrees += 5)
  {
    if (std::abs(degrees - 180) > 30)
    {
      EXPECT_NO_THROW(QuarterIndexFor(CornerOf(degrees), DefaultRows(degrees * Degree))) << degrees;
    }
  }
}

TEST(CornerRows, RefuseImpossibleAngles)
{
  const auto refuses = [](double degrees, CornerRows rows, const std::string& remedy)
  {
    return Refuses([&] { QuarterIndexFor(CornerOf(degrees), rows); },
      { "(1, 2)", std::to_string(static_cast<int>(degrees)) + "°", remedy });
  };
  EXPECT_TRUE(refuses(270.0, CornerRows::End, "let them turn"));
  EXPECT_TRUE(refuses(345.0, CornerRows::End, "let them leave"));
  EXPECT_TRUE(refuses(90.0, CornerRows::Turn, "let them end"));
  EXPECT_TRUE(refuses(355.0, CornerRows::Turn, "let them leave"));
  EXPECT_TRUE(refuses(90.0, CornerRows::Leave, "let them end"));
  EXPECT_TRUE(refuses(150.0, CornerRows::Leave, "let them turn"));
}

TEST(CornerRows, PositionsComeBeforeSidesAndSidesBeforeAngles)
{
  const PlanarDomain domain = LShape();
  const Point inner(1.0, 1.0);
  CornerRule angle;
  angle.angles = { 200.0 * Degree, 300.0 * Degree };
  angle.rows = CornerRows::Leave;
  CornerRule side;
  side.side = "inner";
  side.rows = CornerRows::Turn;
  const SidesAtCorner sidesAt = [&](const Corner& corner) -> std::vector<std::string>
  { return { corner.position == inner ? "inner" : "other" }; };
  const auto indexOf = [&](const std::vector<CornerRule>& rules)
  {
    const std::vector<CornerChoice> choices = TreatCorners(domain, rules, sidesAt);
    EXPECT_EQ(choices.size(), 1U);
    EXPECT_EQ(choices.at(0).position, inner);
    return choices.at(0).quarterIndex;
  };
  EXPECT_EQ(indexOf({ angle }), -1);
  EXPECT_EQ(indexOf({ angle, side }), 0);
  EXPECT_EQ(indexOf({ At(inner, CornerRows::Leave), side, angle }), -1);
  EXPECT_EQ(indexOf({ At(inner, CornerRows::Turn), At(inner, CornerRows::Turn) }), 0);
}

TEST(CornerRows, RulesForSidesTreatCornersWithAnAngleForThem)
{
  const PlanarDomain domain = LShape();
  CornerRule rule;
  rule.side = "wall";
  const SidesAtCorner sidesAt = [](const Corner&) { return std::vector<std::string>{ "wall" }; };
  rule.rows = CornerRows::Turn;
  const std::vector<CornerChoice> turned = TreatCorners(domain, { rule }, sidesAt);
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_EQ(turned[0].position, Point(1.0, 1.0));
  rule.rows = CornerRows::End;
  EXPECT_EQ(TreatCorners(domain, { rule }, sidesAt).size(), 5U);
}

TEST(CornerRows, RefuseRulesWithoutACornerAndContradictions)
{
  const PlanarDomain domain = LShape();
  const auto refuses = [&](const std::vector<CornerRule>& rules, const std::string& part)
  { return Refuses([&] { TreatCorners(domain, rules, NoSides); }, { part }); };
  EXPECT_TRUE(refuses({ At(Point(0.5, 0.0), CornerRows::End) }, "no corner at (0.5, 0)"));
  EXPECT_TRUE(refuses(
    { At(Point(1.0, 1.0), CornerRows::Turn), At(Point(1.0, 1.0), CornerRows::Leave) }, "two ways"));
  CornerRule side;
  side.side = "inlet";
  EXPECT_TRUE(refuses({ side }, "of a side 'inlet'"));
  CornerRule angle;
  angle.angles = { 300.0 * Degree, 340.0 * Degree };
  EXPECT_TRUE(refuses({ angle }, "300° to 340°"));
}
}
}
