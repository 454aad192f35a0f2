#include "ReadAerofoil.h"

#include "DrawingChecks.h"
#include "Support.h"

#include <algorithm>
#include <functional>
#include <iomanip>
#include <sstream>

namespace crossfield::test
{
namespace
{
/// Half thickness of a NACA 0012 profile; its trailing edge is open, or closed by another last
/// coefficient.
double Thickness(double x, bool isBlunt)
{
  return 0.6 *
    (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x -
      (isBlunt ? 0.1015 : 0.1036) * x * x * x * x);
}

/// Returns points from the trailing edge along the upper side to the leading edge, or of the lower
/// side from there.
std::vector<Point> Side(int count, bool isUpper, bool isBlunt)
{
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i)
  {
    const double x = 0.5 * (1.0 + std::cos(Pi * i / count));
    points.emplace_back(
      x, (isUpper ? 1.0 : -1.0) * (i == 0 && !isBlunt ? 0.0 : Thickness(x, isBlunt)));
  }
  points.back() = Point(0, 0);
  if (!isUpper)
  {
    std::reverse(points.begin(), points.end());
  }
  return points;
}

std::string Rows(const std::vector<Point>& points)
{
  std::ostringstream text;
  text << std::setprecision(17);
  for (const Point& point : points)
  {
    text << "  " << point.x() << "  " << point.y() << "\n";
  }
  return text.str();
}

std::string Selig(int count, bool isBlunt)
{
  std::vector<Point> points = Side(count, true, isBlunt);
  const std::vector<Point> lower = Side(count, false, isBlunt);
  points.insert(points.end(), lower.begin() + 1, lower.end());
  return "NACA 0012\n" + Rows(points);
}

std::string Lednicer(int count, bool isBlunt)
{
  std::vector<Point> upper = Side(count, true, isBlunt);
  std::reverse(upper.begin(), upper.end());
  return "NACA 0012\n" + std::to_string(count + 1) + ". " + std::to_string(count + 1) + ".\n\n" +
    Rows(upper) + "\n" + Rows(Side(count, false, isBlunt));
}

TEST(ReadAerofoil, SplineIsCloseToTheProfile)
{
  const Drawing drawing = ReadAerofoil(Selig(60, false), "naca.dat");
  ASSERT_EQ(drawing.pieces.size(), 1U); // a sharp trailing edge
  double largest = 0.0;
  for (const Point& point : PointsOf(drawing.pieces[0], 5001))
  {
    largest = std::max(
      largest, std::abs(std::abs(point.y()) - Thickness(std::clamp(point.x(), 0.0, 1.0), false)));
  }
  EXPECT_LT(largest, 2e-5); // chords are off by 1.7e-4
}

TEST(ReadAerofoil, BluntTrailingEdgeIsALine)
{
  const Drawing drawing = ReadAerofoil(Selig(60, true), "naca.dat");
  ASSERT_EQ(drawing.pieces.size(), 2U);
  EXPECT_EQ(drawing.pieces[1].curve.kind, PlaneCurve::Kind::Line);
  EXPECT_NEAR(
    (drawing.pieces[1].last - drawing.pieces[1].first).norm(), 2 * Thickness(1, true), 1e-15);
  const DrawingOutline outline = Trace(drawing);
  EXPECT_EQ(outline.loops.size(), 1U);
  EXPECT_TRUE(outline.warnings.empty());
}

TEST(ReadAerofoil, LednicerIsTheSameProfile)
{
  for (const bool isBlunt : { false, true })
  {
    const DrawingPiece a = ReadAerofoil(Selig(40, isBlunt), "a.dat").pieces[0];
    const DrawingPiece b = ReadAerofoil(Lednicer(40, isBlunt), "b.dat").pieces[0];
    ASSERT_EQ(a.curve.points.size(), b.curve.points.size());
    for (std::size_t i = 0; i < a.curve.points.size(); ++i)
    {
      EXPECT_LT((a.curve.points[i] - b.curve.points[i]).norm(), 1e-13);
    }
  }
}

TEST(ReadAerofoil, KeepsEveryPoint)
{
  const DrawingOutline outline = Trace(ReadAerofoil(Selig(40, false), "naca.dat"));
  const Loop& points = outline.loops.at(0).points;
  for (const Point& given : Side(40, true, false))
  {
    EXPECT_TRUE(std::any_of(points.begin(), points.end(),
      [&given](const Point& point) { return (point - given).norm() < 1e-13; }))
      << given.transpose();
  }
}

/// Returns the lines of a text, changed.
std::string Changed(const std::string& text, const std::function<std::string(std::string)>& change)
{
  std::istringstream lines(text);
  std::string changed;
  std::string line;
  std::getline(lines, line);
  changed = line + "\n";
  while (std::getline(lines, line))
  {
    changed += change(line) + "\n";
  }
  return changed;
}

TEST(ReadAerofoil, LeavesOutWhatIsNoPointAndCountsIt)
{
  const std::string plain = Selig(30, true);
  const DrawingPiece expected = ReadAerofoil(plain, "a.dat").pieces[0];
  const std::size_t title = plain.find('\n') + 1;
  const auto withComma = [](std::string line) { return line.replace(line.find("  ", 3), 2, ", "); };
  const std::vector<std::pair<std::string, std::string>> files = {
    { Changed(plain, withComma), "" },
    { Changed(plain, [](const std::string& line) { return line + "\r"; }), "" },
    { plain + "\nSource: a book\nCLmax 1.3\n", "2 lines of text." },
    { plain.substr(0, title) + "by J. Doe 1931\n" + plain.substr(title), "1 line of text." },
    { plain.substr(0, title) + " -2.0 3.0 -2.5 3.5\n" + plain.substr(title),
      "1 row with another number of columns." },
    { Changed(plain, [](const std::string& line) { return line + " 0.5 7"; }),
      "2 columns after x and y." },
  };
  for (const auto& [text, leftOut] : files)
  {
    ASSERT_TRUE(IsAerofoil(text)) << text.substr(0, 200);
    const Drawing drawing = ReadAerofoil(text, "a.dat");
    ASSERT_EQ(drawing.pieces[0].curve.points.size(), expected.curve.points.size());
    for (std::size_t i = 0; i < expected.curve.points.size(); ++i)
    {
      EXPECT_EQ(drawing.pieces[0].curve.points[i], expected.curve.points[i]);
    }
    ASSERT_EQ(drawing.warnings.size(), leftOut.empty() ? 0U : 1U);
    EXPECT_TRUE(
      leftOut.empty() || drawing.warnings[0] == "Of the profile 'a.dat' were left out: " + leftOut)
      << drawing.warnings[0];
  }
}

TEST(ReadAerofoil, DoesNotClaimOtherLists)
{
  EXPECT_TRUE(IsAerofoil(Selig(20, false)));
  EXPECT_FALSE(IsAerofoil("square\n0 0\n1 0\n1 1\n0 1\n"));
  EXPECT_FALSE(IsAerofoil(Selig(20, false).substr(10))); // no name
  EXPECT_FALSE(IsAerofoil("disk\n" + Rows(RegularPolygon(64))));
  EXPECT_FALSE(IsAerofoil("two\n" + Rows(RegularPolygon(9)) + "\n\n" + Rows(RegularPolygon(9))));
  EXPECT_FALSE(IsAerofoil(Selig(20, false) + "words\n" + Rows(RegularPolygon(9))));
  EXPECT_FALSE(IsAerofoil(""));
  EXPECT_TRUE(Refuses([] { ReadAerofoil("x\n0 0\n", "a.dat"); }, { "'a.dat'", "Selig" }));
}
}
}
