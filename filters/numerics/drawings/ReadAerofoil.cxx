#include "ReadAerofoil.h"

#include "DxfText.h"
#include "Error.h"
#include "PlanarDomain.h"
#include "ThroughPoints.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace crossfield
{
namespace
{
/// Reads the two numbers of a line.
std::optional<Point> ReadPair(std::string_view line)
{
  const std::string_view pair = Trimmed(line);
  const std::size_t blank = pair.find_first_of(" \t");
  Point point = Point::Zero();
  const bool isPair = blank != std::string_view::npos &&
    ReadNumber(pair.substr(0, blank), point.x()) && ReadNumber(pair.substr(blank), point.y());
  return isPair ? std::optional<Point>(point) : std::nullopt;
}

/// Returns the points of all lines after the first; nothing if a line is not a point.
std::optional<std::vector<Point>> ReadPoints(std::string_view text)
{
  std::vector<Point> points;
  bool isFirst = true;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::optional<Point> point = ReadPair(line);
    if (point.has_value())
    {
      points.push_back(*point);
    }
    else if (!isFirst && !Trimmed(line).empty())
    {
      return std::nullopt;
    }
    isFirst = false;
  }
  return points;
}

/// Returns the points of Lednicer's format in Selig's order; nothing if the counts do not match.
std::optional<std::vector<Point>> FromLednicer(const std::vector<Point>& rows)
{
  const Point counts = rows.empty() ? Point(0.0, 0.0) : rows.front();
  if (!(counts.x() > 1.0 && counts.y() > 1.0) || counts.x() != std::floor(counts.x()) ||
    counts.x() + counts.y() != static_cast<double>(rows.size() - 1))
  {
    return std::nullopt;
  }
  const auto middle = rows.begin() + 1 + static_cast<long>(counts.x());
  std::vector<Point> points(rows.begin() + 1, middle);
  std::reverse(points.begin(), points.end());
  points.insert(points.end(), points.back() == *middle ? middle + 1 : middle, rows.end());
  return points;
}

/// Returns whether x decreases to its minimum and increases again, to about where it started.
bool IsAroundLeadingEdge(const std::vector<Point>& points)
{
  constexpr std::size_t Fewest = 10;
  if (points.size() < Fewest)
  {
    return false;
  }
  const auto isLeft = [](const Point& a, const Point& b) { return a.x() < b.x(); };
  const auto nose = std::min_element(points.begin(), points.end(), isLeft);
  const auto tail = std::max_element(points.begin(), points.end(), isLeft);
  const double chord = tail->x() - nose->x();
  // Points close to the nose may be on either side of it.
  const double slack = 0.01 * chord;
  const auto isRight = [slack](const Point& a, const Point& b) { return a.x() + slack < b.x(); };
  const bool falls = std::adjacent_find(points.begin(), nose, isRight) == nose;
  const bool rises =
    std::adjacent_find(nose, points.end(),
      [&isRight](const Point& a, const Point& b) { return isRight(b, a); }) == points.end();
  constexpr double Near = 0.05;
  constexpr double Thickest = 0.6; // a list of points of a circle is none
  const auto isBelow = [](const Point& a, const Point& b) { return a.y() < b.y(); };
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), isBelow);
  return falls && rises && chord > 0.0 && nose != points.begin() && nose + 1 != points.end() &&
    tail->x() - points.front().x() < Near * chord && tail->x() - points.back().x() < Near * chord &&
    (points.front() - points.back()).norm() < 2.0 * Near * chord &&
    highest->y() - lowest->y() < Thickest * chord;
}

/// Returns the points from the trailing edge around the profile; nothing if it is no aerofoil.
std::optional<std::vector<Point>> ProfileOf(std::string_view text)
{
  const bool hasTitle = !ReadPair(text.substr(0, text.find('\n'))).has_value();
  std::optional<std::vector<Point>> points = hasTitle ? ReadPoints(text) : std::nullopt;
  if (!points.has_value())
  {
    return std::nullopt;
  }
  if (const auto selig = FromLednicer(*points))
  {
    points = selig;
  }
  points->erase(std::unique(points->begin(), points->end()), points->end());
  return IsAroundLeadingEdge(*points) ? points : std::nullopt;
}
}

bool IsAerofoil(std::string_view text)
{
  return ProfileOf(text).has_value();
}

Drawing ReadAerofoil(std::string_view text, const std::string& file)
{
  std::optional<std::vector<Point>> points = ProfileOf(text);
  if (!points.has_value())
  {
    throw Error("The file '" + file +
      "' is no aerofoil in Selig's or Lednicer's format; list a name, then x and y of its points.");
  }
  const Point first = points->front();
  const Point last = points->back();
  const Point start = (*points)[1] - first;
  const Point stop = last - (*points)[points->size() - 2];
  const bool isSmooth = first == last && std::abs(AngleBetween(stop, start)) < DefaultCornerAngle;
  DrawingPiece profile = ThroughPoints(*points, isSmooth);
  profile.origin = "the profile";
  Drawing drawing;
  drawing.pieces.push_back(profile);
  double chord = 0.0;
  for (const Point& point : *points)
  {
    chord = std::max(chord, (point - first).norm());
  }
  constexpr double Sharp = 1e-5;
  if ((last - first).norm() > Sharp * chord)
  {
    DrawingPiece edge = LinePiece(last, first);
    edge.origin = "the trailing edge";
    drawing.pieces.push_back(edge);
  }
  return drawing;
}
}
