// Regions between curves of a drawing that branch, cross or end on each other.

#include "DrawingRegions.h"

#include "CurvePieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace crossfield::test
{
namespace
{
constexpr double SamplingTurn = Pi / 36.0;

Drawing LineDrawing(const std::vector<std::pair<Point, Point>>& ends)
{
  Drawing drawing;
  for (const auto& [first, last] : ends)
  {
    drawing.pieces.push_back(LinePiece(first, last));
  }
  return drawing;
}

Drawing SquareDrawing(double half = 1.0)
{
  return LineDrawing({ { { -half, -half }, { half, -half } }, { { half, -half }, { half, half } },
    { { half, half }, { -half, half } }, { { -half, half }, { -half, -half } } });
}

/// Returns the area of each material.
std::map<std::string, double> AreasOfMaterials(const Drawing& drawing)
{
  std::map<std::string, double> areas;
  for (const DrawingFace& face : drawing.faces)
  {
    EXPECT_GT(SignedArea(face.points), 0.0);
    areas[face.material] += SignedArea(face.points);
  }
  return areas;
}

TEST(DrawingRegions, AreThreeGrains)
{
  Drawing drawing;
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 2.0 * Pi * i / 3.0;
    drawing.pieces.push_back(ArcPiece({ 0, 0 }, 1.0, 120.0 * i, 120.0 * (i + 1), ""));
    drawing.pieces.push_back(LinePiece({ 0, 0 }, { std::cos(angle), std::sin(angle) }));
    drawing.pieces.back().name = "boundary";
  }
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, drawing));
  const std::map<std::string, double> areas = AreasOfMaterials(drawing);
  ASSERT_EQ(areas.size(), 3U);
  for (const auto& [name, area] : areas)
  {
    EXPECT_NEAR(area, Pi / 3.0, 0.01);
  }
  EXPECT_EQ(std::count_if(drawing.pieces.begin(), drawing.pieces.end(),
              [](const DrawingPiece& piece) { return piece.name == "boundary"; }),
    3);
}

TEST(DrawingRegions, AreDividedWhereLinesEndOnOthersOrCross)
{
  Drawing drawing = SquareDrawing();
  for (const DrawingPiece& piece :
    LineDrawing({ { { -1.0, 0.2 }, { 1.0, 0.2 } }, { { 0.3, -1.0 }, { 0.3, 1.0 } },
                  { { -0.4, -1.0 }, { -0.4, 0.2 + 1e-9 } } })
      .pieces)
  {
    drawing.pieces.push_back(piece);
  }
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, drawing));
  const std::map<std::string, double> areas = AreasOfMaterials(drawing);
  ASSERT_EQ(areas.size(), 5U);
  EXPECT_NEAR(areas.at("region1"), 1.3 * 0.8, 1e-8);
  EXPECT_NEAR(areas.at("region2"), 0.7 * 1.2, 1e-8);
  double sum = 0.0;
  for (const auto& [name, area] : areas)
  {
    sum += area;
  }
  EXPECT_NEAR(sum, 4.0, 1e-8);
}

TEST(DrawingRegions, HaveHolesWhereClosedCurvesMeetNoOther)
{
  Drawing drawing = SquareDrawing();
  drawing.pieces.push_back(LinePiece({ -1.0, 0.6 }, { 1.0, 0.6 }));
  drawing.pieces.push_back(ArcPiece({ 0, 0 }, 0.3, 0.0, 360.0, ""));
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, drawing));
  const std::map<std::string, double> areas = AreasOfMaterials(drawing);
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_NEAR(areas.at("region1"), 3.2 - Pi * 0.09, 0.002);
  // A circle around all of it is the outline of another region.
  drawing = SquareDrawing(0.5);
  drawing.pieces.push_back(LinePiece({ -0.5, 0.1 }, { 0.5, 0.1 }));
  drawing.pieces.push_back(ArcPiece({ 0, 0 }, 1.0, 0.0, 360.0, ""));
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, drawing));
  const std::map<std::string, double> around = AreasOfMaterials(drawing);
  ASSERT_EQ(around.size(), 3U);
  EXPECT_NEAR(around.at("region1"), Pi - 1.0, 0.01);
}

TEST(DrawingRegions, HaveSeveralHoles)
{
  Drawing drawing = SquareDrawing();
  drawing.pieces.push_back(LinePiece({ -1.0, 0.9 }, { 1.0, 0.9 }));
  // In a row: the shortest slits of the inner ones would lead through others.
  for (int i = 0; i < 5; ++i)
  {
    drawing.pieces.push_back(ArcPiece({ -0.6 + 0.3 * i, 0.0 }, 0.14, 0.0, 360.0, ""));
    drawing.pieces.push_back(ArcPiece({ -0.6 + 0.3 * i, 0.35 }, 0.14, 0.0, 360.0, ""));
  }
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, drawing));
  const std::map<std::string, double> areas = AreasOfMaterials(drawing);
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_NEAR(areas.at("region1"), 3.8 - 10.0 * Pi * 0.14 * 0.14, 0.002);
  EXPECT_NEAR(areas.at("region2"), 0.2, 1e-9);
}

TEST(DrawingRegions, HaveIslandsInHoles)
{
  Drawing drawing = SquareDrawing();
  drawing.pieces.push_back(LinePiece({ -1.0, 0.9 }, { 1.0, 0.9 }));
  drawing.pieces.push_back(ArcPiece({ 0, 0 }, 0.3, 0.0, 360.0, ""));
  for (const DrawingPiece& piece : SquareDrawing(0.6).pieces) // a hole of several curves
  {
    drawing.pieces.push_back(piece);
  }
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, drawing));
  const std::map<std::string, double> areas = AreasOfMaterials(drawing);
  ASSERT_EQ(areas.size(), 3U);
  EXPECT_NEAR(areas.at("region1"), 3.8 - 1.44, 1e-9);
  EXPECT_NEAR(areas.at("region2"), Pi * 0.09, 0.002);
}

TEST(DrawingRegions, AreWithinClosedCurvesOnRequest)
{
  const auto pipe = [](const std::string& inside)
  {
    Drawing drawing = SquareDrawing();
    for (DrawingPiece& piece : drawing.pieces)
    {
      piece.name = "soil";
    }
    drawing.pieces.push_back(ArcPiece({ 0, 0 }, 0.5, 0.0, 360.0, ""));
    drawing.pieces.back().name = "wool";
    drawing.pieces.push_back(ArcPiece({ 0, 0 }, 0.3, 0.0, 360.0, ""));
    drawing.pieces.back().name = inside;
    return drawing;
  };
  Drawing hollow = pipe("hole");
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Regions, hollow));
  std::map<std::string, double> areas = AreasOfMaterials(hollow);
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_NEAR(areas.at("soil"), 4.0 - Pi * 0.25, 0.01);
  EXPECT_NEAR(areas.at("wool"), Pi * 0.16, 0.01);
  Drawing full = pipe("steel");
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Regions, full));
  areas = AreasOfMaterials(full);
  ASSERT_EQ(areas.size(), 3U);
  EXPECT_NEAR(areas.at("steel"), Pi * 0.09, 0.01);
  // Names that do not distinguish regions are none.
  Drawing unnamed = pipe("");
  for (DrawingPiece& piece : unnamed.pieces)
  {
    piece.name = "lines";
  }
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Regions, unnamed));
  EXPECT_EQ(AreasOfMaterials(unnamed).count("region3"), 1U);
}

TEST(DrawingRegions, DoNotCountLinesTwice)
{
  Drawing drawing = SquareDrawing();
  drawing.pieces.push_back(LinePiece({ 0.0, -1.0 }, { 0.0, 1.0 }));
  drawing.pieces.push_back(LinePiece({ 0.0, 1.0 }, { 0.0, -1.0 }));
  ASSERT_TRUE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, drawing));
  EXPECT_EQ(AreasOfMaterials(drawing).size(), 2U);
}

TEST(DrawingRegions, NeedClosedLines)
{
  Drawing drawing = SquareDrawing();
  drawing.pieces.push_back(LinePiece({ -1.0, 0.0 }, { 0.5, 0.0 }));
  const std::size_t before = drawing.pieces.size();
  EXPECT_FALSE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, drawing));
  EXPECT_EQ(drawing.pieces.size(), before);
  EXPECT_TRUE(drawing.faces.empty());
  Drawing square = SquareDrawing();
  EXPECT_FALSE(TraceRegions(0.0, SamplingTurn, ClosedCurves::Holes, square));
}
}
}
