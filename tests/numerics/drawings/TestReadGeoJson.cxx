#include "ReadGeoJson.h"

#include "DrawingChecks.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
const std::string Rings = "[[[0,0],[4,0],[4,3],[0,3],[0,0]],[[1,1],[1,2],[2,2],[2,1],[1,1]]]";
const std::string Polygon = R"({"type":"Polygon","coordinates":)" + Rings + "}";

TEST(ReadGeoJson, ReadsAPolygonWithItsHole)
{
  for (const std::string& text :
    { Polygon, R"({"type":"Feature","properties":{},"geometry":)" + Polygon + "}",
      R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":)" + Polygon + "}]}",
      R"({"type":"MultiPolygon","coordinates":[)" + Rings + "]}",
      R"({"type":"GeometryCollection","geometries":[)" + Polygon + "]}" })
  {
    const Drawing drawing = ReadGeoJson(text, "lake.geojson");
    EXPECT_EQ(drawing.pieces.size(), 8U);
    EXPECT_EQ(drawing.unit, "degree");
    const DrawingOutline outline = Trace(drawing);
    EXPECT_EQ(AreaOf(outline), 11.0);
    EXPECT_TRUE(outline.curves.empty());
  }
}

TEST(ReadGeoJson, OtherGeometriesAndSystemsAreReported)
{
  const Drawing drawing = ReadGeoJson(
    R"({"type":"GeometryCollection","crs":{},"geometries":[{"type":"Point","coordinates":[0,0]},)" +
      Polygon + "]}",
    "lake.geojson");
  EXPECT_EQ(drawing.unit, "");
  ASSERT_EQ(drawing.warnings.size(), 1U);
  EXPECT_NE(drawing.warnings[0].find("1 geometries"), std::string::npos);
}

TEST(ReadGeoJson, LeavesOutSpikesAndRingsWithoutArea)
{
  const Drawing drawing = ReadGeoJson(
    R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[5,0],[6,0],[5,0],[4,0],[4,3],[0,3],[0,0]],[[1,1],[2,2],[1,1]],[[3,1],[3,1]]]})",
    "lake.geojson");
  ASSERT_EQ(drawing.warnings.size(), 1U);
  EXPECT_EQ(
    drawing.warnings[0].find("2 rings of 'lake.geojson' with fewer than three places were"), 0U);
  const DrawingOutline outline = Trace(drawing);
  EXPECT_EQ(outline.loops.size(), 1U);
  EXPECT_EQ(AreaOf(outline), 12.0);
  EXPECT_EQ(outline.warnings.size(), 3U); // two copies, and two ways there and back
}

TEST(ReadGeoJson, RefusesOtherFiles)
{
  const auto refuses = [](const std::string& text, const std::string& part)
  { EXPECT_TRUE(Refuses([&] { ReadGeoJson(text, "lake.geojson"); }, { part })) << text; };
  refuses("", "no valid JSON");
  refuses(Polygon.substr(0, 40), "no valid JSON");
  refuses("[]", "no geometry");
  refuses("{}", "no geometry");
  refuses(R"({"type":5})", "no geometry");
  refuses(R"({"type":"Point","coordinates":[0,0]})", "no polygon");
  refuses(R"({"type":"Polygon"})", "Ring 1");
  refuses(R"({"type":"Polygon","coordinates":[[[0,0],[1,0]]]})", "Ring 1");
  refuses(R"({"type":"Polygon","coordinates":[[[0,0],[1,"x"],[1,1]]]})", "Ring 1");
  refuses(R"({"type":"Polygon","coordinates":[[[0,0],[1,1e999],[1,1]]]})", "JSON");
  refuses(R"({"type":"Polygon","coordinates":{"a":3}})", "Ring 1");
  std::string deep;
  for (int i = 0; i < 100000; ++i)
  {
    deep += R"({"type":"GeometryCollection","geometries":[)";
  }
  refuses(deep, "no valid JSON");
  std::string closed = deep;
  for (int i = 0; i < 100000; ++i)
  {
    closed += "]}";
  }
  refuses(closed, "no geometry");
}
}
}
