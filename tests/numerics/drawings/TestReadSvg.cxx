#include "ReadSvg.h"

#include "DrawingChecks.h"
#include "Support.h"
#include "SvgPath.h"
#include "SvgShapes.h"

namespace crossfield::test
{
namespace
{
Drawing Read(const std::string& body, const std::string& attributes = "")
{
  return ReadSvg("<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " +
      attributes + ">\n" + body + "\n</svg>\n",
    "part.svg");
}

/// Returns points of all pieces.
std::vector<Point> Samples(const std::vector<DrawingPiece>& pieces)
{
  std::vector<Point> points;
  for (const DrawingPiece& piece : pieces)
  {
    const std::vector<Point> own = PointsOf(piece);
    points.insert(points.end(), own.begin(), own.end());
  }
  return points;
}

void ExpectSame(const std::vector<DrawingPiece>& a, const std::vector<DrawingPiece>& b)
{
  const std::vector<Point> first = Samples(a);
  const std::vector<Point> second = Samples(b);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_LT((first[i] - second[i]).norm(), 1e-13);
  }
}

TEST(ReadSvg, RelativeCommandsEqualAbsoluteOnes)
{
  ExpectSame(SvgPath("M1,2 L4 2 H5 V3 C5,4 4,5 3 5 S1 6 1,5 Q0,4 1 3 T1 2 Z"),
    SvgPath("m1 2l3 0h1v1c0 1-1 2-2 2s-2 1-2 0q-1-1 0-2t0-1z"));
  ExpectSame(SvgPath("M0 0A5 3 30 1 0 2 1"), SvgPath("m0 0a5 3 30 10 2 1")); // flags without blanks
  ExpectSame(SvgPath("M0 0 1 0 1 1"), SvgPath("M0 0L1 0L1 1"));
  ExpectSame(SvgPath("m1 1 1 0 0 1"), SvgPath("M1 1L2 1L2 2"));
}

TEST(ReadSvg, SmoothCurvesContinueTheTangent)
{
  const std::vector<DrawingPiece> pieces = SvgPath("M0 0C0 1 1 2 2 2S4 1 4 0");
  EXPECT_EQ(pieces[1].curve.points[1], Point(3, 2));
  const std::vector<DrawingPiece> other = SvgPath("M0 0L2 2S4 1 4 0"); // nothing to continue
  EXPECT_EQ(other[1].curve.points[1], Point(2, 2));
}

TEST(ReadSvg, ArcsHaveTheGivenRadiiAndEnds)
{
  Random random(71);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Point first(random.Uniform(-1, 1), random.Uniform(-1, 1));
    const Point last(random.Uniform(-1, 1), random.Uniform(-1, 1));
    const Point radii(random.Uniform(2, 3), random.Uniform(2, 3));
    const double degrees = random.Uniform(-180, 180);
    const bool isLarge = trial % 2 == 0;
    const bool isPositive = trial % 4 < 2;
    const DrawingPiece arc = SvgArc(first, last, radii, degrees, isLarge, isPositive);
    EXPECT_NEAR(arc.curve.axis.norm(), radii.x(), 1e-12);
    EXPECT_NEAR(arc.curve.ratio * arc.curve.axis.norm(), radii.y(), 1e-12);
    EXPECT_EQ(std::abs(arc.end - arc.begin) > Pi, isLarge);
    EXPECT_EQ(arc.end > arc.begin, isPositive);
    const DrawingPiece exact = CurvePiece(arc.curve, arc.begin, arc.end);
    EXPECT_LT((exact.first - first).norm() + (exact.last - last).norm(), 1e-11);
  }
  // Radii that do not reach are enlarged to a half ellipse.
  const DrawingPiece small = SvgArc({ 0, 0 }, { 4, 0 }, { 1, 0.5 }, 0.0, false, true);
  EXPECT_NEAR(small.curve.axis.norm(), 2.0, 1e-14);
  EXPECT_NEAR(small.curve.ratio, 0.5, 1e-14);
}

TEST(ReadSvg, ReadsShapes)
{
  const Drawing drawing =
    Read("<rect id='r' x='1' y='2' width='30' height='20'/>"
         "<circle cx='10' cy='10' r='3'/><ellipse cx='20' cy='10' rx='4' ry='2'/>"
         "<polygon points='5,5 6,5 6,6'/>");
  EXPECT_EQ(drawing.pieces.size(), 4U + 1U + 1U + 3U);
  EXPECT_EQ(drawing.pieces[0].name, "r");
  EXPECT_EQ(drawing.pieces[0].first, Point(1, -2)); // y is negated
  EXPECT_EQ(drawing.pieces[4].curve.centre, Point(10, -10));
  EXPECT_EQ(drawing.pieces[4].name, "");
  EXPECT_NEAR(drawing.pieces[5].curve.ratio, 0.5, 1e-15);
}

TEST(ReadSvg, RoundsTheCornersOfRectangles)
{
  const DrawingOutline outline = Trace(Read("<rect width='10' height='6' rx='2' ry='1'/>"));
  ASSERT_EQ(outline.loops.size(), 1U);
  EXPECT_NEAR(AreaOf(outline), 60.0 - (4.0 - Pi) * 2.0 * 1.0, 0.02);
  const DrawingOutline circle = Trace(Read("<rect width='10' height='10' rx='9'/>"));
  EXPECT_NEAR(AreaOf(circle), 25.0 * Pi, 0.1);
}

TEST(ReadSvg, AppliesTransforms)
{
  const Drawing drawing =
    Read("<g id='layer' transform='translate(10,20) scale(2)'>"
         "<line x1='0' y1='0' x2='1' y2='0' transform='rotate(90 1 0)'/></g>"
         "<line x1='1' y1='1' x2='2' y2='1' transform='matrix(0,1,-1,0,5,6) skewX(45)'/>");
  // Rotation about (1, 0): (0, 0) to (1, −1), then scaled and moved, then y negated.
  EXPECT_LT((drawing.pieces[0].first - Point(12, -18)).norm(), 1e-14);
  EXPECT_LT((drawing.pieces[0].last - Point(12, -20)).norm(), 1e-14);
  EXPECT_EQ(drawing.pieces[0].name, "layer");
  // skewX(45): (1, 1) to (2, 1); matrix: (−1 + 5, 2 + 6).
  EXPECT_LT((drawing.pieces[1].first - Point(4, -8)).norm(), 1e-14);
}

TEST(ReadSvg, ReportsTheUnit)
{
  const std::string shape = "<circle r='1'/>";
  EXPECT_EQ(Read(shape, "width='100mm' height='50mm' viewBox='0 0 100 50'").unit, "mm");
  EXPECT_EQ(Read(shape, "width='1in' viewBox='0 0 96 96'").unit, "0.264583 mm");
  EXPECT_EQ(Read(shape, "width='100' viewBox='0 0 100 50'").unit, "");
  EXPECT_EQ(SvgLength({ { "r", "1in" } }, "r"), 96.0);
}

TEST(ReadSvg, LeavesOutWhatIsNoShape)
{
  const Drawing drawing = Read(
    "<defs><circle r='9'/></defs><clipPath><circle r='8'/></clipPath><text>words</text>"
    "<use href='#a'/><g style='display: none'><circle r='7'/></g><g display='none'><circle r='6'/></g>"
    "<circle r='1'/><x:y xmlns:x='http://x'><circle r='5'/></x:y><!-- <circle r='4'/> -->");
  ASSERT_EQ(drawing.pieces.size(), 1U);
  EXPECT_EQ(drawing.pieces[0].curve.axis.norm(), 1.0);
  ASSERT_EQ(drawing.warnings.size(), 1U);
  EXPECT_NE(drawing.warnings[0].find("1 text, 1 use"), std::string::npos) << drawing.warnings[0];
}

TEST(ReadSvg, FilledCurvesAreClosed)
{
  const std::string open = "d='M0 0 H4 V3 H0 M1 1 V2 H2'";
  for (const std::string& body : std::vector<std::string>{ "<path " + open + "/>",
         "<g fill='none'><path style='stroke:red; fill: blue' " + open + "/></g>",
         "<polyline points='0 0 4 0 4 3 0 3'/><polyline points='1 1 1 2 2 2'/>" })
  {
    const Drawing drawing = Read(body);
    ASSERT_EQ(drawing.warnings.size(), 1U) << body;
    EXPECT_EQ(drawing.warnings[0],
      "2 filled curves of 'part.svg' without Z at the end were closed by a straight line.");
    EXPECT_NEAR(AreaOf(Trace(drawing)), 11.5, 1e-12);
  }
  for (const std::string& body : std::vector<std::string>{ "<path fill='none' " + open + "/>",
         "<g style='fill:none'><path " + open + "/></g>", "<path class='a' " + open + "/>",
         "<line x2='3'/><path d='M0 0 h3'/>" })
  {
    EXPECT_TRUE(Read(body).warnings.empty()) << body;
  }
  // A part without area.
  const DrawingOutline outline = Trace(Read("<path d='M0 0h4v3h-4zM1 1l.08.06z'/>"));
  EXPECT_EQ(outline.loops.size(), 1U);
  EXPECT_FALSE(outline.warnings.empty());
}

TEST(ReadSvg, RefusesWhatIsNotValid)
{
  const auto refuses = [](const std::string& body, const std::string& part)
  { EXPECT_TRUE(Refuses([&] { Read(body); }, { part })) << body; };
  refuses("<circle r='1'>", "no valid XML");
  refuses("", "no visible shapes");
  refuses("<circle r='10%'/>", "r=\"10%\"");
  refuses("<path d='L1 1'/>", "character 2");
  refuses("<path d='M1 x'/>", "'x'");
  refuses("<path d='M0 0 A1 1 0 2 0 3 3'/>", "not valid");
  refuses("<path d='M0 0 z 3'/>", "not valid");
  refuses("<polygon points='1 2 3'/>", "odd");
  refuses("<g transform='turn(3)'><circle r='1'/></g>", "'turn'");
  refuses("<g transform='rotate(1'><circle r='1'/></g>", "rotate(1");
  refuses("<circle r='1' transform='scale(0)'/>", "scale of zero");
  EXPECT_TRUE(Refuses([] { ReadSvg("<html/>", "part.svg"); }, { "no SVG" }));
  EXPECT_TRUE(Refuses([] { ReadSvg("", "part.svg"); }, { "no valid XML" }));
}
}
}
