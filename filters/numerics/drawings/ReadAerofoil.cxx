#include "ReadAerofoil.h"

#include "DxfText.h"
#include "Error.h"
#include "PlanarDomain.h"
#include "ThroughPoints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace crossfield
{
namespace
{
/// Divides the points of a profile where the polygon turns by more than 100° at the end of a
/// straight side, as at a sharp leading edge: a spline through this point would leave the straight
/// side. A round nose of few points turns by as much, but also at the points next to it.
std::vector<std::vector<Point>> DivideAtCorners(const std::vector<Point>& points)
{
  constexpr double LargestTurn = 100.0 * Pi / 180.0;
  constexpr double Straight = Pi / 180.0;
  const auto turnAt = [&](std::size_t i)
  { return std::abs(AngleBetween(points[i] - points[i - 1], points[i + 1] - points[i])); };
  std::vector<std::vector<Point>> parts = { { points.front() } };
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    parts.back().push_back(points[i]);
    const bool isInside = i > 1 && i + 2 < points.size();
    if (isInside && turnAt(i) > LargestTurn &&
      (turnAt(i - 1) < Straight || turnAt(i + 1) < Straight))
    {
      parts.push_back({ points[i] });
    }
  }
  return parts;
}

/// Returns the numbers that a line consists of, separated by blanks or commas; none if it has a
/// text.
std::vector<double> NumbersOf(std::string_view line)
{
  constexpr std::string_view Separators = " \t\r,;";
  std::vector<double> numbers;
  while (true)
  {
    line.remove_prefix(std::min(line.find_first_not_of(Separators), line.size()));
    if (line.empty())
    {
      return numbers;
    }
    const std::size_t end = std::min(line.find_first_of(Separators), line.size());
    double number = 0.0;
    if (!ReadNumber(line.substr(0, end), number))
    {
      return {};
    }
    numbers.push_back(number);
    line.remove_prefix(end);
  }
}

/// The rows of numbers of a file, and how many lines are left out.
struct Rows
{
  std::vector<Point> points;   ///< The first two numbers of each row.
  std::size_t texts = 0;       ///< Lines of text after the first line.
  std::size_t otherRows = 0;   ///< Rows with another number of columns, such as the bounds of MSES.
  std::size_t moreColumns = 0; ///< Columns after x and y.
};

/// Reads the lines after the first, which is a name; nothing if rows are divided by texts.
std::optional<Rows> ReadRows(std::string_view text)
{
  std::vector<std::vector<double>> rows;
  std::map<std::size_t, std::size_t> countOf; // rows by their number of columns
  Rows result;
  bool isFirst = true;
  bool isEnded = false;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = Trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    std::vector<double> numbers = NumbersOf(line);
    if (isFirst || line.empty())
    {
      isFirst = false;
    }
    else if (numbers.size() < 2)
    {
      ++result.texts;
      isEnded = !rows.empty();
    }
    else if (isEnded)
    {
      return std::nullopt;
    }
    else
    {
      ++countOf[numbers.size()];
      rows.push_back(std::move(numbers));
    }
  }
  const auto most = std::max_element(countOf.begin(), countOf.end(),
    [](const auto& a, const auto& b) { return a.second < b.second; });
  for (const std::vector<double>& row : rows)
  {
    if (row.size() == most->first)
    {
      result.points.emplace_back(row[0], row[1]);
    }
  }
  result.otherRows = rows.size() - result.points.size();
  result.moreColumns = most == countOf.end() ? 0 : most->first - 2;
  return result;
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

/// Reads a file; its points lead from the trailing edge around the profile. Nothing if it is no
/// aerofoil.
std::optional<Rows> ReadProfile(std::string_view text)
{
  const bool hasTitle = NumbersOf(text.substr(0, text.find('\n'))).size() < 2;
  std::optional<Rows> rows = hasTitle ? ReadRows(text) : std::nullopt;
  if (!rows)
  {
    return std::nullopt;
  }
  std::vector<Point>& points = rows->points;
  if (const auto selig = FromLednicer(points))
  {
    points = *selig;
  }
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return IsAroundLeadingEdge(points) ? rows : std::nullopt;
}

/// Returns a sentence about the parts of a file that are left out; empty if there are none.
std::string DescribeLeftOut(const Rows& rows, const std::string& file)
{
  std::string parts;
  const auto add = [&parts](std::size_t count, const std::string& what)
  {
    if (count > 0)
    {
      parts += (parts.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    }
  };
  add(rows.texts, rows.texts == 1 ? "line of text" : "lines of text");
  add(rows.otherRows,
    rows.otherRows == 1 ? "row with another number of columns"
                        : "rows with another number of columns");
  add(rows.moreColumns, rows.moreColumns == 1 ? "column after x and y" : "columns after x and y");
  return parts.empty() ? "" : "Of the profile '" + file + "' were left out: " + parts + ".";
}
}

bool IsAerofoil(std::string_view text)
{
  return ReadProfile(text).has_value();
}

Drawing ReadAerofoil(std::string_view text, const std::string& file)
{
  const std::optional<Rows> rows = ReadProfile(text);
  if (!rows)
  {
    throw Error("The file '" + file +
      "' is no aerofoil in Selig's or Lednicer's format; list a name, then x and y of its points.");
  }
  const std::vector<Point>& points = rows->points;
  const Point first = points.front();
  const Point last = points.back();
  const Point start = points[1] - first;
  const Point stop = last - points[points.size() - 2];
  const bool isSmooth = first == last && std::abs(AngleBetween(stop, start)) < DefaultCornerAngle;
  Drawing drawing;
  const std::string leftOut = DescribeLeftOut(*rows, file);
  if (!leftOut.empty())
  {
    drawing.warnings.push_back(leftOut);
  }
  for (const std::vector<Point>& part :
    isSmooth ? std::vector<std::vector<Point>>{ points } : DivideAtCorners(points))
  {
    drawing.pieces.push_back(ThroughPoints(part, isSmooth));
    drawing.pieces.back().origin = "the profile";
  }
  double chord = 0.0;
  for (const Point& point : points)
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
