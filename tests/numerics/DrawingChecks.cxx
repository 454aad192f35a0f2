#include "DrawingChecks.h"

#include "CurvePieces.h"
#include "Support.h"

#include <cmath>
#include <sstream>

namespace crossfield::test
{
std::string DxfGroups(const std::vector<std::string>& entities)
{
  std::string text;
  for (const std::string& entity : entities)
  {
    std::istringstream words(entity);
    std::string word;
    words >> word;
    text += "  0\n" + word + "\n";
    while (words >> word)
    {
      text += word + "\n";
    }
  }
  return text;
}

std::string DxfText(const std::vector<std::string>& entities,
  const std::vector<std::string>& blocks, const std::string& header)
{
  std::string text;
  if (!header.empty())
  {
    text += header;
  }
  if (!blocks.empty())
  {
    text += "  0\nSECTION\n  2\nBLOCKS\n" + DxfGroups(blocks) + "  0\nENDSEC\n";
  }
  return text + "  0\nSECTION\n  2\nENTITIES\n" + DxfGroups(entities) + "  0\nENDSEC\n  0\nEOF\n";
}

std::vector<Loop> LoopsOf(const DrawingOutline& outline)
{
  std::vector<Loop> loops;
  for (const OutlineLoop& loop : outline.loops)
  {
    loops.push_back(loop.points);
  }
  return loops;
}

double AreaOf(const DrawingOutline& outline)
{
  double largest = 0.0;
  double sum = 0.0;
  for (const OutlineLoop& loop : outline.loops)
  {
    const double area = std::abs(SignedArea(loop.points));
    largest = std::max(largest, area);
    sum += area;
  }
  return 2.0 * largest - sum;
}

DrawingOutline Trace(const Drawing& drawing)
{
  return TraceOutline(drawing, 0.0, Pi / 36.0);
}

std::vector<Point> PointsOf(const DrawingPiece& piece, int count)
{
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(PointAt(piece,
      i + 1 == count ? piece.end : piece.begin + (piece.end - piece.begin) * i / (count - 1)));
  }
  return points;
}

DrawingPiece RandomPiece(Random& random, int kind)
{
  const auto point = [&random] { return Point(random.Uniform(-2, 2), random.Uniform(-2, 2)); };
  switch (kind)
  {
  case 0:
    return ArcPiece(
      point(), random.Uniform(0.1, 2), random.Uniform(-400, 400), random.Uniform(-400, 400), "arc");
  case 1:
    return EllipsePiece(point(), point(), random.Uniform(0.05, 3), random.Uniform(-6, 6),
      random.Uniform(-6, 6), "ellipse");
  case 2:
    return LinePiece(point(), point());
  default:
  {
    const int degree = random.Integer(1, 5);
    const int count = degree + random.Integer(1, 6);
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    std::vector<Point> points;
    std::vector<double> weights;
    for (int i = 0; i < count; ++i)
    {
      points.push_back(point());
      weights.push_back(random.Uniform(0.3, 3));
      if (i > degree)
      {
        knots.push_back(knots.back() + random.Uniform(0.1, 1));
      }
    }
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, knots.back() + 0.5);
    return NurbsPiece(degree, knots, points, weights, "spline");
  }
  }
}
}
