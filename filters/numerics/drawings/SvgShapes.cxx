#include "SvgShapes.h"

#include "CurvePieces.h"
#include "Error.h"
#include "SvgPath.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace crossfield
{
namespace
{
/// A length and its unit.
struct Length
{
  double value = 0.0;
  std::string unit;
};

/// Splits a length; returns false if it does not start with a finite number.
bool Split(const std::string& text, Length& length)
{
  constexpr const char* Blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(Blanks);
  if (first == std::string::npos)
  {
    return false;
  }
  const char* start = text.data() + first + (text[first] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(start, end, length.value);
  if (result.ec != std::errc() || !std::isfinite(length.value))
  {
    return false;
  }
  length.unit = std::string(result.ptr, end);
  length.unit.erase(length.unit.find_last_not_of(Blanks) + 1);
  return true;
}

constexpr double MillimetresPerInch = 25.4;

/// Returns the millimetres of a unit, 0 if it is not absolute.
double MillimetresOf(const std::string& unit)
{
  const std::map<std::string, double> units = { { "mm", 1.0 }, { "cm", 10.0 }, { "Q", 0.25 },
    { "in", MillimetresPerInch }, { "pt", MillimetresPerInch / 72.0 },
    { "pc", MillimetresPerInch / 6.0 } };
  const auto found = units.find(unit);
  return found == units.end() ? 0.0 : found->second;
}

std::vector<DrawingPiece> Polygon(const std::vector<Point>& points, bool isClosed)
{
  std::vector<DrawingPiece> pieces;
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < points.size(); ++i)
  {
    const Point& next = points[(i + 1) % points.size()];
    if (points[i] != next)
    {
      pieces.push_back(LinePiece(points[i], next));
    }
  }
  return pieces;
}

std::vector<Point> Points(const SvgAttributes& attributes)
{
  const auto text = attributes.find("points");
  const std::vector<double> numbers =
    text == attributes.end() ? std::vector<double>() : SvgNumbers(text->second);
  if (numbers.size() % 2 != 0)
  {
    throw Error("A polygon of the drawing has an odd number of coordinates; correct it.");
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < numbers.size(); i += 2)
  {
    points.emplace_back(numbers[i], numbers[i + 1]);
  }
  return points;
}

std::vector<DrawingPiece> Rectangle(const SvgAttributes& attributes)
{
  const Point corner(SvgLength(attributes, "x"), SvgLength(attributes, "y"));
  const Point size(SvgLength(attributes, "width"), SvgLength(attributes, "height"));
  if (!(size.x() > 0.0 && size.y() > 0.0))
  {
    return {};
  }
  double rx = SvgLength(attributes, "rx", -1.0);
  double ry = SvgLength(attributes, "ry", -1.0);
  rx = rx < 0.0 ? std::max(ry, 0.0) : rx;
  ry = ry < 0.0 ? rx : ry;
  rx = std::min(rx, 0.5 * size.x());
  ry = std::min(ry, 0.5 * size.y());
  if (rx == 0.0 || ry == 0.0)
  {
    return Polygon(
      { corner, corner + Point(size.x(), 0.0), corner + size, corner + Point(0.0, size.y()) },
      true);
  }
  // Points where each side starts and stops, in the direction of positive angles.
  const Point end = corner + size;
  const std::array<Point, 8> points = { Point(corner.x() + rx, corner.y()),
    Point(end.x() - rx, corner.y()), Point(end.x(), corner.y() + ry), Point(end.x(), end.y() - ry),
    Point(end.x() - rx, end.y()), Point(corner.x() + rx, end.y()), Point(corner.x(), end.y() - ry),
    Point(corner.x(), corner.y() + ry) };
  std::vector<DrawingPiece> pieces;
  for (std::size_t i = 0; i < points.size(); i += 2)
  {
    if (points[i] != points[i + 1])
    {
      pieces.push_back(LinePiece(points[i], points[i + 1]));
    }
    pieces.push_back(
      SvgArc(points[i + 1], points[(i + 2) % points.size()], { rx, ry }, 0.0, false, true));
  }
  return pieces;
}

std::vector<DrawingPiece> RoundShape(const SvgAttributes& attributes, bool isCircle)
{
  const Point centre(SvgLength(attributes, "cx"), SvgLength(attributes, "cy"));
  const double rx = SvgLength(attributes, isCircle ? "r" : "rx");
  const double ry = isCircle ? rx : SvgLength(attributes, "ry");
  if (!(rx > 0.0 && ry > 0.0))
  {
    return {};
  }
  return { isCircle ? ArcPiece(centre, rx, 0.0, 360.0, "a circle")
                    : EllipsePiece(centre, { rx, 0.0 }, ry / rx, 0.0, 2.0 * Pi, "an ellipse") };
}

/// Returns the map of one function of a `transform`.
AffineMap TransformOf(const std::string& name, const std::vector<double>& values)
{
  const auto value = [&values](std::size_t i, double fallback)
  { return i < values.size() ? values[i] : fallback; };
  AffineMap map = IdentityMap();
  if (name == "matrix" && values.size() == 6)
  {
    map << values[0], values[2], values[4], values[1], values[3], values[5];
  }
  else if (name == "translate" && (values.size() == 1 || values.size() == 2))
  {
    map.col(2) = Point(values[0], value(1, 0.0));
  }
  else if (name == "scale" && (values.size() == 1 || values.size() == 2))
  {
    map(0, 0) = values[0];
    map(1, 1) = value(1, values[0]);
  }
  else if (name == "rotate" && (values.size() == 1 || values.size() == 3))
  {
    const double angle = values[0] * Pi / 180.0;
    map.leftCols<2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Point centre(value(1, 0.0), value(2, 0.0));
    map.col(2) = centre - map.leftCols<2>() * centre;
  }
  else if ((name == "skewX" || name == "skewY") && values.size() == 1)
  {
    map(name == "skewX" ? 0 : 1, name == "skewX" ? 1 : 0) = std::tan(values[0] * Pi / 180.0);
  }
  else
  {
    throw Error("The drawing has the transform '" + name + "' with " +
      std::to_string(values.size()) + " numbers, which is not valid; correct it.");
  }
  return map;
}
}

bool IsSvgShape(const std::string& element)
{
  constexpr std::array<std::string_view, 7> Shapes = { "path", "rect", "circle", "ellipse", "line",
    "polyline", "polygon" };
  return std::find(Shapes.begin(), Shapes.end(), element) != Shapes.end();
}

std::vector<DrawingPiece> SvgShape(const std::string& element, const SvgAttributes& attributes)
{
  if (element == "path")
  {
    const auto data = attributes.find("d");
    return data == attributes.end() ? std::vector<DrawingPiece>() : SvgPath(data->second);
  }
  if (element == "rect")
  {
    return Rectangle(attributes);
  }
  if (element == "line")
  {
    return Polygon({ Point(SvgLength(attributes, "x1"), SvgLength(attributes, "y1")),
                     Point(SvgLength(attributes, "x2"), SvgLength(attributes, "y2")) },
      false);
  }
  if (element == "polyline" || element == "polygon")
  {
    return Polygon(Points(attributes), element == "polygon");
  }
  return RoundShape(attributes, element == "circle");
}

double SvgLength(const SvgAttributes& attributes, const std::string& name, double fallback)
{
  const auto text = attributes.find(name);
  if (text == attributes.end() || text->second == "auto")
  {
    return fallback;
  }
  Length length;
  if (Split(text->second, length))
  {
    constexpr double UnitsPerInch = 96.0;
    if (length.unit.empty() || length.unit == "px")
    {
      return length.value;
    }
    const double millimetres = MillimetresOf(length.unit);
    if (millimetres > 0.0)
    {
      return length.value * millimetres * (UnitsPerInch / MillimetresPerInch);
    }
  }
  throw Error("The length " + name + "=\"" + text->second +
    "\" of the drawing is not a number with an absolute unit; correct it.");
}

double SvgMillimetres(const std::string& text)
{
  Length length;
  return Split(text, length) ? length.value * MillimetresOf(length.unit) : 0.0;
}

AffineMap SvgTransform(const std::string& text)
{
  AffineMap map = IdentityMap();
  constexpr const char* Separators = " \t\r\n,";
  for (std::size_t at = text.find_first_not_of(Separators); at != std::string::npos;
       at = text.find_first_not_of(Separators, at))
  {
    const std::size_t open = text.find('(', at);
    const std::size_t close = text.find(')', at);
    if (open == std::string::npos || close == std::string::npos || close < open)
    {
      throw Error("The transform '" + text + "' of the drawing is not valid; correct it.");
    }
    std::string name = text.substr(at, open - at);
    name.erase(name.find_last_not_of(Separators) + 1);
    const std::string_view values = std::string_view(text).substr(open + 1, close - open - 1);
    map = Compose(map, TransformOf(name, SvgNumbers(values)));
    at = close + 1;
  }
  return map;
}
}
