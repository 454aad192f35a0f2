#include "PieceChains.h"

#include "CurvePieces.h"
#include "DrawingChecks.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
/// Returns a square of side 2 with a semicircle on top, and a round hole: area 4 + π/2 − π/4.
std::vector<DrawingPiece> Part(const Point& at)
{
  std::vector<DrawingPiece> pieces = { LinePiece(at, at + Point(2, 0)),
    LinePiece(at + Point(2, 0), at + Point(2, 2)),
    ArcPiece(at + Point(1, 2), 1.0, 0.0, 180.0, "the arc"), LinePiece(at + Point(0, 2), at),
    ArcPiece(at + Point(1, 1), 0.5, 0.0, 360.0, "the circle") };
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    pieces[i].origin = "piece " + std::to_string(i);
  }
  return pieces;
}

constexpr double PartArea = 4.0 + Pi / 4.0;

void Reverse(DrawingPiece& piece)
{
  std::swap(piece.first, piece.last);
  if (piece.curve.kind != PlaneCurve::Kind::Line)
  {
    std::swap(piece.begin, piece.end);
  }
}

Drawing Of(const std::vector<DrawingPiece>& pieces)
{
  Drawing drawing;
  drawing.pieces = pieces;
  return drawing;
}

TEST(PieceChains, AreIndependentOfOrderAndDirection)
{
  Random random(61);
  for (const double offset : { 0.0, 1e9 })
  {
    for (int trial = 0; trial < 20; ++trial)
    {
      std::vector<DrawingPiece> pieces = Part({ offset, -offset });
      random.Shuffle(pieces);
      for (DrawingPiece& piece : pieces)
      {
        if (random.Integer(0, 1) == 1)
        {
          Reverse(piece);
        }
      }
      const DrawingOutline outline = Trace(Of(pieces));
      ASSERT_EQ(outline.loops.size(), 2U);
      EXPECT_TRUE(outline.warnings.empty());
      // Relative to the offset, so that the products of the area formula lose no digits.
      DrawingOutline moved = outline;
      for (OutlineLoop& loop : moved.loops)
      {
        for (Point& point : loop.points)
        {
          point -= Point(offset, -offset);
        }
      }
      EXPECT_NEAR(AreaOf(moved), PartArea, 2e-3);
      EXPECT_LT(AreaOf(moved), PartArea + 1e-6 + 0.1);
    }
  }
}

TEST(PieceChains, CloseGapsWithinTheToleranceAndReportTheWidest)
{
  std::vector<DrawingPiece> pieces = Part({ 0, 0 });
  pieces[0].last.x() += 1e-5;
  pieces[3].last.y() += 2e-5;
  const PieceChains chains = ChainPieces(pieces, 1e-4);
  EXPECT_EQ(chains.chains.size(), 2U);
  EXPECT_NEAR(chains.largestGap, 2e-5, 1e-12);
  ASSERT_EQ(chains.warnings.size(), 1U);
  EXPECT_NE(chains.warnings[0].find("widest of 2, at (0, "), std::string::npos)
    << chains.warnings[0];
}

TEST(PieceChains, OfferAToleranceThatCloses)
{
  std::vector<DrawingPiece> pieces = Part({ 0, 0 });
  pieces[0].last.x() += 0.01;
  EXPECT_TRUE(Refuses(
    [&] { ChainPieces(pieces, 1e-4); }, { "open at (2", "piece 0", "join tolerance to 0.011" }));
  EXPECT_EQ(ChainPieces(pieces, 0.011).chains.size(), 2U);
}

TEST(PieceChains, ReportAMissingPieceWithoutAWrongRemedy)
{
  std::vector<DrawingPiece> pieces = Part({ 0, 0 });
  pieces.push_back(LinePiece({ 0.2, 0.2 }, { 0.4, 0.3 }));
  pieces.back().origin = "the stray line";
  try
  {
    ChainPieces(pieces, 1e-4);
    FAIL();
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("stray line"), std::string::npos) << message;
    EXPECT_EQ(message.find("tolerance"), std::string::npos) << message;
  }
}

TEST(PieceChains, ReportJunctions)
{
  std::vector<DrawingPiece> pieces = Part({ 0, 0 });
  pieces.push_back(LinePiece({ 0, 0 }, { 1, 1 }));
  pieces.back().origin = "the diagonal";
  EXPECT_TRUE(Refuses(
    [&] { ChainPieces(pieces, 1e-4); }, { "More than two", "(0, 0)", "piece 0", "piece 3" }));
  pieces.back() = LinePiece({ 0.3, 0 }, { 0.3, 0.4 });
  pieces.back().origin = "the stub";
  EXPECT_TRUE(
    Refuses([&] { ChainPieces(pieces, 1e-4); }, { "(0.3, 0)", "the stub ends on piece 0" }));
}

TEST(PieceChains, LeaveOutRepeatedPieces)
{
  std::vector<DrawingPiece> pieces = Part({ 0, 0 });
  for (std::size_t i = 0; i < 5; ++i)
  {
    pieces.push_back(pieces[i]);
    pieces.back().origin = "copy " + std::to_string(i);
    if (i % 2 == 0)
    {
      Reverse(pieces.back());
    }
  }
  const PieceChains chains = ChainPieces(pieces, 1e-4);
  EXPECT_EQ(chains.chains.size(), 2U);
  ASSERT_EQ(chains.warnings.size(), 1U);
  EXPECT_NE(chains.warnings[0].find("5 pieces"), std::string::npos);
  EXPECT_NE(chains.warnings[0].find("copy 0"), std::string::npos);
  // Two halves of a circle have the same ends but are no copies.
  const std::vector<DrawingPiece> halves = { ArcPiece({ 0, 0 }, 1, 0, 180, "a"),
    ArcPiece({ 0, 0 }, 1, 180, 360, "b") };
  EXPECT_EQ(ChainPieces(halves, 1e-4).chains.at(0).size(), 2U);
}

TEST(PieceChains, LeaveOutPiecesThatLieOnOthers)
{
  const std::vector<std::vector<DrawingPiece>> covers = {
    { LinePiece({ 0, 0 }, { 0.7, 0 }) },           // from a corner
    { LinePiece({ 1.3, 0 }, { 0.7, 0 }) },         // between corners
    { ArcPiece({ 1, 2 }, 1.0, 0.0, 60.0, "arc") }, // on an arc
    { ArcPiece({ 1, 1 }, 0.5, 0, 180, "a"), ArcPiece({ 1, 1 }, 0.5, 180, 360, "b") }, // on a circle
    { LinePiece({ 2, 0 }, { 3, 0 }), LinePiece({ 3, 0 }, { 4, 1 }), LinePiece({ 4, 1 }, { 3, 0 }),
      LinePiece({ 3, 0 }, { 2, 0 }) }, // there and back
  };
  Random random(62);
  for (const std::vector<DrawingPiece>& cover : covers)
  {
    std::vector<DrawingPiece> pieces = Part({ 0, 0 });
    pieces.insert(pieces.end(), cover.begin(), cover.end());
    for (int trial = 0; trial < 5; ++trial)
    {
      const DrawingOutline outline = Trace(Of(pieces));
      EXPECT_EQ(outline.loops.size(), 2U);
      EXPECT_NEAR(AreaOf(outline), PartArea, 3e-3);
      ASSERT_FALSE(outline.warnings.empty());
      EXPECT_NE(outline.warnings.back().find("lie"), std::string::npos);
      random.Shuffle(pieces);
    }
  }
  // A way there and back alone is no boundary.
  EXPECT_TRUE(Refuses(
    [] {
      ChainPieces({ LinePiece({ 0, 0 }, { 1, 0 }), LinePiece({ 1, 0 }, { 0, 0 }) }, 1e-4);
    },
    { "open at" }));
  // Squares that share a part of a side are no drawing of one part: nothing is left out.
  std::vector<DrawingPiece> pieces = Part({ 0, 0 });
  for (const auto& [first, last] :
    { std::pair(Point(2, 0), Point(3, 0)), std::pair(Point(3, 0), Point(3, 1)),
      std::pair(Point(3, 1), Point(2, 1)), std::pair(Point(2, 1), Point(2, 0)) })
  {
    pieces.push_back(LinePiece(first, last));
  }
  EXPECT_TRUE(Refuses([&] { ChainPieces(pieces, 1e-4); }, { "More than two", "(2, 0)" }));
}

TEST(PieceChains, KeepShortSegmentsThatJoinExactly)
{
  // A fine polygon: its segments are shorter than the tolerance.
  const Loop polygon = RegularPolygon(1000);
  std::vector<DrawingPiece> pieces;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    pieces.push_back(LinePiece(polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  const PieceChains chains = ChainPieces(pieces, 0.1);
  ASSERT_EQ(chains.chains.size(), 1U);
  EXPECT_EQ(chains.chains[0].size(), 1000U);
  EXPECT_TRUE(chains.warnings.empty());
}

TEST(PieceChains, LeaveOutTinyStrayPieces)
{
  std::vector<DrawingPiece> pieces = Part({ 0, 0 });
  pieces.push_back(LinePiece({ 0.2, 0.2 }, { 0.2, 0.20001 }));
  const PieceChains chains = ChainPieces(pieces, 1e-4);
  EXPECT_EQ(chains.chains.size(), 2U);
  EXPECT_EQ(chains.warnings.size(), 1U);
}

TEST(DrawingOutline, VertexOfAClosedGapIsOnTheCurve)
{
  std::vector<DrawingPiece> pieces = Part({ 0, 0 });
  pieces[1].last.x() += 1e-5; // a line that misses the arc
  const DrawingOutline outline = TraceOutline(Of(pieces), 1e-4, Pi / 36.0);
  int onArc = 0;
  for (const OutlineLoop& loop : outline.loops)
  {
    for (std::size_t i = 0; i < loop.points.size(); ++i)
    {
      const int curve = loop.segments[i].curve;
      ASSERT_GE(curve, 0);
      const PlaneCurve& known = outline.curves[static_cast<std::size_t>(curve)];
      if (known.kind == PlaneCurve::Kind::Circle)
      {
        ++onArc;
        const Point& next = loop.points[(i + 1) % loop.points.size()];
        EXPECT_NEAR((loop.points[i] - known.centre).norm(), known.axis.norm(), 1e-14);
        EXPECT_NEAR((next - known.centre).norm(), known.axis.norm(), 1e-14);
      }
    }
  }
  EXPECT_GT(onArc, 60);
}

TEST(DrawingOutline, DoesNotRecordACurveThatAVertexIsOff)
{
  std::vector<DrawingPiece> halves = { ArcPiece({ 0, 0 }, 1, 0, 180, "a"),
    ArcPiece({ 0, 1e-4 }, 1, 180, 360, "b") };
  const DrawingOutline outline = TraceOutline(Of(halves), 1e-3, Pi / 36.0);
  ASSERT_EQ(outline.curves.size(), 1U);
  EXPECT_EQ(outline.curves[0].centre, Point(0, 0));
}

TEST(DrawingOutline, AnArcWithItsChordEnclosesAnArea)
{
  const std::vector<DrawingPiece> segment = { BulgePiece({ 0, 0 }, { 1, 0 }, 0.01),
    LinePiece({ 0, 0 }, { 1, 0 }) };
  const DrawingOutline outline = Trace(Of(segment));
  ASSERT_EQ(outline.loops.size(), 1U);
  EXPECT_GE(outline.loops[0].points.size(), 3U);
  EXPECT_GT(AreaOf(outline), 0.0);
}

TEST(DrawingOutline, RefusesAnEmptyDrawing)
{
  EXPECT_TRUE(Refuses([] { Trace(Drawing()); }, { "no curves" }));
}
}
}
