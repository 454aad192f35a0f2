// Files of Triangle and OFF: their boundary, names, warnings, and damaged texts.

#include "DrawingChecks.h"
#include "DrawingFormats.h"
#include "DrawingLayers.h"
#include "DrawingOutline.h"
#include "MakePlanarDomain.h"
#include "ReadOff.h"
#include "ReadPoly.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
const std::string Plate = "# a plate with a hole\n"
                          "7 2 0 1\n"
                          "0 0 0 1\n1 4 0 1\n2 4 3 1\n3 0 3 1 # a corner\n4 1 1\n5 2 1\n6 1 2\n"
                          "\n7 1\n"
                          "1 0 1 1\n2 1 2 1\n3 2 3 1\n4 3 0 5\n5 4 5 0\n6 5 6 0\n7 6 4 0\n";

TEST(ReadPoly, PointsSegmentsMarkersAndHoles)
{
  const Drawing drawing = ReadDrawing(DrawingFormat::Poly, Plate + "1\n1 1.2 1.2\n", "plate.poly");
  EXPECT_EQ(drawing.pieces.size(), 7U);
  EXPECT_EQ(drawing.pieces[0].name, "1");
  EXPECT_EQ(drawing.pieces[3].name, "5");
  EXPECT_EQ(drawing.pieces[4].name, "");
  EXPECT_TRUE(drawing.warnings.empty());
  EXPECT_NEAR(AreaOf(TraceOutline(drawing, 0.0, 0.1)), 12.0 - 0.5, 1e-12);
  const Drawing other = ReadPoly(Plate + "0\n", "plate.poly");
  ASSERT_EQ(other.warnings.size(), 1U);
  EXPECT_NE(other.warnings[0].find("0 holes and 2 curves"), std::string::npos);
}

TEST(ReadPoly, RefusesOtherTexts)
{
  const auto refuses = [](const std::string& text, const std::string& part) {
    EXPECT_TRUE(Refuses([&] { ReadPoly(text, "plate.poly"); }, { part, "plate.poly" })) << text;
  };
  refuses("", "ends too early");
  refuses(Plate, "Line 19");
  refuses("0 2 0 0\n", ".node file");
  refuses("words\n", "Line 1");
  refuses("3 3 0 0\n", "other than 2");
  refuses("3 2 0 0\n1 0 0\n3 1 0\n", "next number");
  refuses("3 2 0 0\n1 0 0\n2 1 0\n3 1 inf\n", "no number as entry 3");
  refuses("3 2 0 0\n1 0 0\n2 1 0\n3 1 1\n1 0\n1 1 4\n", "names a point");
  refuses("1000000000 2 0 0\n", "whole number");
}

TEST(ReadOff, BoundaryInAnyPlane)
{
  const std::string mesh =
    "OFF\n6 2 0\n0 0 0\n2 0 2\n2 1 2\n0 1 0\n4 0 4\n4 1 4\n4 0 1 2 3\n4 1 4 5 2\n";
  const Drawing drawing = ReadDrawing(DrawingFormat::Off, mesh, "two.off");
  EXPECT_EQ(drawing.pieces.size(), 6U);
  const DrawingOutline outline = TraceOutline(drawing, 0.0, 0.1);
  ASSERT_EQ(outline.loops.size(), 1U);
  EXPECT_NEAR(std::abs(SignedArea(outline.loops[0].points)), 4.0 * std::sqrt(2.0), 1e-12);
  const auto refuses = [](const std::string& text, const std::string& part)
  { EXPECT_TRUE(Refuses([&] { ReadOff(text, "two.off"); }, { part })) << text; };
  refuses("", "ends too early");
  refuses("ply\n", "is not OFF");
  refuses("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n", "names a point");
  const Drawing inSpace =
    ReadOff("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n", "two.off");
  EXPECT_TRUE(inSpace.pieces.empty());
  EXPECT_EQ(inSpace.surface.points.size(), 4U);
  EXPECT_EQ(inSpace.surface.polygons, (std::vector<std::vector<int>>{ { 0, 1, 2 }, { 0, 2, 3 } }));
  refuses("OFF\n3 2 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 0 1 2\n", "no boundary");
}

TEST(DrawingLayers, KeepOnlyThoseThatAreNamed)
{
  const Drawing plate = ReadPoly(Plate + "1\n1 1.2 1.2\n", "plate.poly");
  Drawing drawing = plate;
  KeepLayers({}, drawing);
  EXPECT_EQ(drawing.pieces.size(), plate.pieces.size());
  KeepLayers({ "1", "5" }, drawing);
  EXPECT_NEAR(AreaOf(TraceOutline(drawing, 0.0, 0.1)), 12.0, 1e-12);
  ASSERT_EQ(drawing.warnings.size(), 1U);
  EXPECT_EQ(drawing.warnings[0], "3 curves on other layers were left out.");
  drawing = plate;
  KeepLayers({ "0" }, drawing);
  EXPECT_EQ(drawing.pieces.size(), 3U);
  EXPECT_TRUE(Refuses([&] { KeepLayers({ "0", "cut" }, drawing); }, { "'cut'", "'0'" }));
}
}
}
