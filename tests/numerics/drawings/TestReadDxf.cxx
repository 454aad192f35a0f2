#include "ReadDxf.h"

#include "DrawingChecks.h"
#include "DrawingFormats.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
Drawing Read(const std::vector<std::string>& entities, const std::vector<std::string>& blocks = {})
{
  return ReadDxf(DxfText(entities, blocks), "part.dxf");
}

const std::vector<std::string> Square = { "LINE 8 wall 10 0 20 0 11 2 21 0",
  "LINE 8 wall 10 2 20 0 11 2 21 2", "LINE 8 inlet 10 2 20 2 11 0 21 2",
  "LINE 8 0 10 0 20 2 11 0 21 0" };

TEST(ReadDxf, ReadsFilesOfWindows)
{
  std::string text = "\xEF\xBB\xBF" + DxfText(Square);
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
  {
    text.insert(at, "\r");
  }
  const Drawing drawing = ReadDrawing(DrawingFormat::Dxf, text, "part.dxf");
  EXPECT_EQ(drawing.pieces.size(), 4U);
  EXPECT_EQ(drawing.pieces[0].name, "wall");
}

TEST(ReadDxf, LayersAreNamesExceptLayer0)
{
  const DrawingOutline outline = Trace(Read(Square));
  ASSERT_EQ(outline.loops.size(), 1U);
  ASSERT_EQ(outline.loops[0].points.size(), 4U);
  std::map<std::string, int> counts;
  for (const OutlineSegment& segment : outline.loops[0].segments)
  {
    ++counts[segment.name];
    EXPECT_EQ(
      outline.curves.at(static_cast<std::size_t>(segment.curve)).kind, PlaneCurve::Kind::Line);
  }
  EXPECT_EQ(counts, (std::map<std::string, int>{ { "wall", 2 }, { "inlet", 1 }, { "", 1 } }));
}

TEST(ReadDxf, ReadsCirclesArcsAndEllipses)
{
  const Drawing drawing =
    Read({ "CIRCLE 8 a 10 1 20 2 40 0.5", "ARC 8 a 10 0 20 0 40 2 50 350 51 10",
      "ELLIPSE 8 a 10 1 20 1 11 0 21 3 40 0.5 41 0 42 1.5707963267948966" });
  ASSERT_EQ(drawing.pieces.size(), 3U);
  EXPECT_EQ(drawing.pieces[0].first, Point(1.5, 2));
  EXPECT_EQ(drawing.pieces[0].last, Point(1.5, 2));
  EXPECT_NEAR(drawing.pieces[1].end - drawing.pieces[1].begin, Pi / 9, 1e-14);
  EXPECT_LT((PointAt(drawing.pieces[1], 0.0) - Point(2, 0)).norm(), 1e-14);
  EXPECT_EQ(drawing.pieces[2].curve.kind, PlaneCurve::Kind::Ellipse);
  EXPECT_LT((drawing.pieces[2].first - Point(1, 4)).norm(), 1e-14);
  EXPECT_LT((drawing.pieces[2].last - Point(-0.5, 1)).norm(), 1e-14); // 90° to the left of the axis
}

TEST(ReadDxf, ReadsPolylinesWithBulges)
{
  // A stadium: bulges of 1 are semicircles.
  const double area = 4.0 + Pi;
  const DrawingOutline light =
    Trace(Read({ "LWPOLYLINE 8 a 90 4 70 1 10 0 20 0 10 2 20 0 42 1 10 2 20 2 "
                 "10 0 20 2 42 1" }));
  const DrawingOutline heavy = Trace(Read({ "POLYLINE 8 a 66 1 70 1", "VERTEX 10 0 20 0",
    "VERTEX 10 2 20 0 42 1", "VERTEX 10 2 20 2", "VERTEX 10 0 20 2 42 1", "SEQEND" }));
  for (const DrawingOutline& outline : { light, heavy })
  {
    EXPECT_NEAR(AreaOf(outline), area, 3e-3);
    EXPECT_LT(AreaOf(outline), area);
    ASSERT_EQ(outline.curves.size(), 3U);
    int circles = 0;
    for (const PlaneCurve& curve : outline.curves)
    {
      if (curve.kind == PlaneCurve::Kind::Circle)
      {
        ++circles;
        EXPECT_NEAR(curve.axis.norm(), 1.0, 1e-15);
        EXPECT_NEAR(curve.centre.y(), 1.0, 1e-15);
      }
    }
    EXPECT_EQ(circles, 2);
  }
}

TEST(ReadDxf, ReadsSplines)
{
  const std::string weight = std::to_string(std::sqrt(0.5));
  const Drawing drawing =
    Read({ "SPLINE 8 a 70 4 71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 " + weight +
        " 41 1 10 1 20 0 30 0 10 1 20 1 30 0 10 0 20 1 30 0",
      "SPLINE 8 b 70 1 71 3 74 4 11 1 21 0 31 0 11 0 21 1 31 0 11 -1 21 0 31 0 11 0 21 -1 31 0" });
  ASSERT_EQ(drawing.pieces.size(), 2U);
  for (const Point& point : PointsOf(drawing.pieces[0]))
  {
    EXPECT_NEAR(point.norm(), 1.0, 1e-6); // the weight has six digits
  }
  EXPECT_EQ(drawing.pieces[1].first, drawing.pieces[1].last);
  // A periodic spline through four points of a circle, by symmetry.
  const Point octant = PointAt(drawing.pieces[1], 0.125 * drawing.pieces[1].end);
  EXPECT_NEAR(octant.x(), octant.y(), 1e-12);
}

TEST(ReadDxf, DividesSplinesAtKinks)
{
  // Degree 1: a polyline. A knot of multiplicity 2 of degree 2 is a corner, unless the curve is smooth.
  const auto quadratic = [](const std::string& y)
  {
    return Read({ "SPLINE 8 a 70 8 71 2 72 8 73 5 40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 2 "
                  "10 0 20 0 30 0 10 1 20 0 30 0 10 2 20 0 30 0 10 3 20 " +
                  y + " 30 0 10 4 20 1 30 0" })
      .pieces;
  };
  const std::vector<DrawingPiece> lines =
    Read({ "SPLINE 8 a 70 8 71 1 72 6 73 4 40 0 40 0 40 1 40 2 40 3 40 3 10 0 20 0 30 0 "
           "10 4 20 0 30 0 10 4 20 3 30 0 10 0 20 3 30 0" })
      .pieces;
  ASSERT_EQ(lines.size(), 3U);
  for (const DrawingPiece& line : lines)
  {
    EXPECT_EQ(line.curve.kind, PlaneCurve::Kind::Line);
    EXPECT_EQ(line.name, "a");
  }
  EXPECT_EQ(lines[1].first, Point(4, 0));
  EXPECT_EQ(lines[1].last, Point(4, 3));
  EXPECT_EQ(quadratic("0").size(), 1U);
  const std::vector<DrawingPiece> parts = quadratic("1");
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].last, Point(2, 0));
  EXPECT_EQ(parts[1].first, Point(2, 0));
  EXPECT_EQ(parts[1].last, Point(4, 1));
  EXPECT_LT((PointAt(parts[1], 1.5) - Point(3, 0.75)).norm(), 1e-14);
}

TEST(ReadDxf, InsertsBlocks)
{
  // The base point (1, 1) goes to (10, 20); scale (2, 2), turned by 90°; twice, 8 apart.
  const Drawing drawing = Read({ "INSERT 8 hole 2 round 10 10 20 20 41 2 42 2 50 90 70 2 44 8" },
    { "BLOCK 2 round 10 1 20 1", "CIRCLE 8 0 10 2 20 1 40 0.5", "LINE 8 own 10 1 20 1 11 2 21 1",
      "ENDBLK" });
  ASSERT_EQ(drawing.pieces.size(), 4U);
  EXPECT_EQ(drawing.pieces[0].name, "hole");
  EXPECT_EQ(drawing.pieces[1].name, "own");
  EXPECT_LT((drawing.pieces[0].curve.centre - Point(10, 22)).norm(), 1e-14);
  EXPECT_NEAR(drawing.pieces[0].curve.axis.norm(), 1.0, 1e-14);
  EXPECT_EQ(drawing.pieces[0].curve.kind, PlaneCurve::Kind::Circle);
  EXPECT_LT((drawing.pieces[2].curve.centre - Point(10, 30)).norm(), 1e-13);
  EXPECT_LT((drawing.pieces[1].last - Point(10, 22)).norm(), 1e-14);
}

TEST(ReadDxf, LimitsInsertions)
{
  EXPECT_TRUE(Refuses([] { Read({ "INSERT 2 no 10 0 20 0" }); }, { "'no'", "not defined" }));
  EXPECT_TRUE(Refuses(
    [] {
      Read({ "INSERT 2 a 10 0 20 0" }, { "BLOCK 2 a 10 0 20 0", "INSERT 2 a 10 1 20 0", "ENDBLK" });
    },
    { "inserts itself" }));
  std::vector<std::string> blocks;
  for (int i = 0; i < 30; ++i)
  {
    const std::string inner = "INSERT 2 b" + std::to_string(i + 1) + " 10 0 20 0";
    blocks.insert(
      blocks.end(), { "BLOCK 2 b" + std::to_string(i) + " 10 0 20 0", inner, inner, "ENDBLK" });
  }
  blocks.insert(blocks.end(), { "BLOCK 2 b30 10 0 20 0", "ENDBLK" });
  EXPECT_TRUE(Refuses([&] { Read({ "INSERT 2 b0 10 0 20 0" }, blocks); }, { "two million" }));
}

TEST(ReadDxf, ReflectsEntitiesSeenFromBelow)
{
  const Drawing drawing = Read({ "ARC 8 a 10 -1 20 0 40 1 50 0 51 90 230 -1",
    "LWPOLYLINE 8 a 90 2 70 0 10 -1 20 0 42 1 10 -3 20 0 230 -1",
    "ELLIPSE 8 a 10 0 20 0 11 2 21 0 40 0.5 41 0 42 1.5707963267948966 230 -1",
    "LINE 8 a 10 5 20 0 11 6 21 0 230 -1" });
  EXPECT_LT((drawing.pieces[0].first - Point(0, 0)).norm(), 1e-15);
  EXPECT_LT((drawing.pieces[0].last - Point(1, 1)).norm(), 1e-15);
  EXPECT_LT((drawing.pieces[1].first - Point(1, 0)).norm(), 1e-15);
  EXPECT_LT((drawing.pieces[1].last - Point(3, 0)).norm(), 1e-15);
  const DrawingPiece& bulge = drawing.pieces[1];
  // To the left in its own system, which is mirrored.
  EXPECT_NEAR(PointAt(bulge, 0.5 * (bulge.begin + bulge.end)).y(), 1.0, 1e-14);
  EXPECT_LT((drawing.pieces[2].last - Point(0, -1)).norm(), 1e-14);
  EXPECT_EQ(drawing.pieces[3].first, Point(5, 0));
  EXPECT_TRUE(
    Refuses([] { Read({ "ARC 10 0 20 0 40 1 50 0 51 90 210 1 230 0" }); }, { "not parallel" }));
  // Some programs write no normal of splines.
  EXPECT_EQ(Read({ "SPLINE 70 8 71 1 210 0 220 0 230 0 40 0 40 0 40 1 40 1 10 0 20 0 10 3 20 1" })
              .pieces.size(),
    1U);
}

TEST(ReadDxf, TheFlagClosesSplines)
{
  const std::string points =
    " 10 0 20 0 10 30 20 -5 10 60 20 0 10 65 20 25 10 30 20 40 10 -5 20 25";
  // Even knots: the control points are repeated.
  const Drawing even =
    Read({ "SPLINE 70 11 71 3 40 0 40 1 40 2 40 3 40 4 40 5 40 6 40 7 40 8 40 9" + points });
  ASSERT_EQ(even.pieces.size(), 1U);
  const DrawingPiece& piece = even.pieces[0];
  EXPECT_EQ(piece.first, piece.last);
  EXPECT_LT((PointAt(piece, piece.end - 1e-9) - piece.last).norm(), 1e-6);
  // Of a uniform cubic B-spline: one sixth, four sixths and one sixth of control points.
  EXPECT_LT((piece.first - Point(30, -20.0 / 6.0)).norm(), 1e-12);
  EXPECT_EQ(Trace(even).loops.size(), 1U);
  // Knots of full multiplicity at ends that differ: a sentence names the flag.
  const Drawing open =
    Read({ "SPLINE 70 11 71 3 40 0 40 0 40 0 40 0 40 1 40 2 40 3 40 3 40 3 40 3" + points });
  EXPECT_TRUE(Refuses([&] { Trace(open); }, { "open at", "whose flag says that it is closed" }));
}

TEST(ReadDxf, LeavesOutWhatIsNotDrawn)
{
  const std::string layers = "  0\nSECTION\n  2\nTABLES\n" +
    DxfGroups({ "TABLE 2 LAYER", "LAYER 2 off 70 0 62 -7", "LAYER 2 frozen 70 1 62 7", "ENDTAB" }) +
    "  0\nENDSEC\n";
  std::vector<std::string> entities = Square;
  entities.insert(entities.end(),
    { "LINE 8 off 10 0 20 0 11 1 21 1", "LINE 8 frozen 10 0 20 0 11 1 21 1",
      "LINE 8 wall 67 1 10 0 20 0 11 1 21 1", "TEXT 8 wall 10 0 20 0 1 words",
      "TEXT 8 wall 10 0 20 0 1 words", "DIMENSION 8 wall 10 0 20 0" });
  const Drawing drawing = ReadDxf(DxfText(entities, {}, layers), "part.dxf");
  EXPECT_EQ(drawing.pieces.size(), 4U);
  ASSERT_EQ(drawing.warnings.size(), 2U);
  EXPECT_NE(drawing.warnings[0].find("1 DIMENSION, 2 TEXT"), std::string::npos)
    << drawing.warnings[0];
  EXPECT_NE(drawing.warnings[1].find("2 entities"), std::string::npos) << drawing.warnings[1];
}

TEST(ReadDxf, ReadsTheUnit)
{
  const auto unitOf = [](const std::string& code)
  {
    return ReadDxf(DxfText(Square, {},
                     "  0\nSECTION\n  2\nHEADER\n  9\n$INSUNITS\n 70\n" + code + "\n  0\nENDSEC\n"),
      "part.dxf")
      .unit;
  };
  EXPECT_EQ(unitOf("4"), "mm");
  EXPECT_EQ(unitOf("1"), "in");
  EXPECT_EQ(unitOf("6"), "m");
  EXPECT_EQ(unitOf("0"), "");
  EXPECT_EQ(unitOf("77"), "");
}

TEST(ReadDxf, KeepsTheHeightAndRefusesSeveral)
{
  const Drawing high = Read({ "CIRCLE 10 0 20 0 30 5 40 1" });
  EXPECT_EQ(high.plane.ToSpace({ 1, 2 }), Eigen::Vector3d(1, 2, 5));
  EXPECT_TRUE(Refuses([] { Read({ "LINE 10 0 20 0 30 0 11 1 21 0 31 1" }); }, { "z ranges from" }));
}

TEST(ReadDxf, RefusesOtherFiles)
{
  const auto refuses = [](const std::string& text, const std::string& part)
  { EXPECT_TRUE(Refuses([&] { ReadDxf(text, "part.dxf"); }, { part })) << text; };
  refuses("AutoCAD Binary DXF\r\n", "ASCII DXF");
  refuses("AC1027", "ASCII DXF");
  refuses("", "EOF");
  refuses(std::string("0\n\0", 3), "no text");
  refuses("hello\nworld\n", "Line 1");
  const std::string good = DxfText(Square);
  refuses(good.substr(0, good.size() / 2), "part.dxf");
  refuses("  0\nSECTION\n  2\nENTITIES\n  0\nEOF\n", "no end ENDSEC");
  refuses("  0\nEOF\n", "ENTITIES");
  EXPECT_TRUE(Refuses([] { Read({}); }, { "no visible lines" }));
  EXPECT_TRUE(Refuses([] { Read({ "TEXT 10 0 20 0" }); }, { "1 TEXT" }));
  EXPECT_TRUE(Refuses([] { Read({ "LINE 10 0 20 0 11 x 21 0" }); }, { "finite number" }));
  EXPECT_TRUE(Refuses([] { Read({ "CIRCLE 10 0 20 0 40 nan" }); }, { "finite number" }));
  EXPECT_TRUE(Refuses([] { Read({ "SPLINE 71 3 10 0 20 0 10 1" }); }, { "lacks a coordinate" }));
  EXPECT_TRUE(Refuses([] { Read({ "SPLINE 71 3 11 0 21 0" }); }, { "too few points" }));
}
}
}
