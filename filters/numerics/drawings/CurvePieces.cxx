#include "CurvePieces.h"

#include "CurveFrame.h"
#include "Error.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the unit vector of an angle in degrees, exact at multiples of 90°.
Point Direction(double degrees)
{
  const double turned = std::remainder(degrees, 360.0);
  if (turned == 0.0 || std::abs(turned) == 180.0)
  {
    return { turned == 0.0 ? 1.0 : -1.0, 0.0 };
  }
  if (std::abs(turned) == 90.0)
  {
    return { 0.0, turned > 0.0 ? 1.0 : -1.0 };
  }
  return { std::cos(turned * Pi / 180.0), std::sin(turned * Pi / 180.0) };
}

void Require(bool isValid, const std::string& origin, const std::string& problem)
{
  if (!isValid)
  {
    throw Error("A curve of the drawing, " + origin + ", " + problem + "; correct or remove it.");
  }
}
}

DrawingPiece ArcPiece(const Point& centre, double radius, double beginDegrees, double endDegrees,
  const std::string& origin)
{
  Require(radius > 0.0, origin, "has a radius that is not positive");
  DrawingPiece piece;
  piece.curve.kind = PlaneCurve::Kind::Circle;
  piece.curve.centre = centre;
  piece.curve.axis = Point(radius, 0.0);
  const double begin = std::remainder(beginDegrees, 360.0);
  double sweep = std::remainder(endDegrees - beginDegrees, 360.0);
  sweep = sweep <= 0.0 ? sweep + 360.0 : sweep;
  piece.begin = begin * Pi / 180.0;
  piece.end = (begin + sweep) * Pi / 180.0;
  piece.first = centre + radius * Direction(beginDegrees);
  piece.last = sweep == 360.0 ? piece.first : Point(centre + radius * Direction(endDegrees));
  piece.origin = origin;
  return piece;
}

DrawingPiece BulgePiece(const Point& first, const Point& last, double bulge)
{
  // The sagitta is half the bulge times the chord: below rounding errors.
  constexpr double Straight = 1e-12;
  if (std::abs(bulge) < Straight || first == last)
  {
    return LinePiece(first, last);
  }
  const Point chord = last - first;
  const Point left(-chord.y(), chord.x());
  DrawingPiece piece;
  piece.curve.kind = PlaneCurve::Kind::Circle;
  piece.curve.centre = first + 0.5 * chord + (1.0 - bulge * bulge) / (4.0 * bulge) * left;
  piece.curve.axis = (bulge * bulge - 1.0) / (4.0 * bulge) * left - 0.5 * chord;
  piece.begin = 0.0;
  piece.end = 4.0 * std::atan(bulge);
  piece.first = first;
  piece.last = last;
  return piece;
}

DrawingPiece EllipsePiece(const Point& centre, const Point& axis, double ratio, double begin,
  double end, const std::string& origin)
{
  constexpr double LargestParameter = 1000.0;
  Require(axis.norm() > 0.0 && ratio > 0.0, origin, "has an axis that is not positive");
  Require(std::abs(begin) <= LargestParameter && std::abs(end) <= LargestParameter, origin,
    "has a parameter beyond 1000 radians");
  PlaneCurve curve;
  // A ratio of 1 within rounding errors is a circle.
  curve.kind = std::abs(ratio - 1.0) < 1e-12 ? PlaneCurve::Kind::Circle : PlaneCurve::Kind::Ellipse;
  curve.centre = centre;
  curve.axis = axis;
  curve.ratio = curve.kind == PlaneCurve::Kind::Circle ? 1.0 : ratio;
  const double sweep = std::clamp(end - begin, -2.0 * Pi, 2.0 * Pi);
  Require(sweep != 0.0, origin, "has length zero");
  DrawingPiece piece = CurvePiece(curve, begin, begin + sweep);
  // Parameters are written with ten digits or more.
  constexpr double Rounding = 1e-9;
  if (std::abs(std::abs(sweep) - 2.0 * Pi) < Rounding)
  {
    piece.end = begin + std::copysign(2.0 * Pi, sweep);
    piece.last = piece.first;
  }
  piece.origin = origin;
  return piece;
}

DrawingPiece NurbsPiece(int degree, std::vector<double> knots, std::vector<Point> points,
  std::vector<double> weights, const std::string& origin)
{
  Require(degree >= 1 && degree <= MaximumDegree, origin, "has a degree that is not 1 to 25");
  const auto order = static_cast<std::size_t>(degree) + 1;
  Require(points.size() >= order, origin, "has too few control points");
  Require(knots.size() == points.size() + order, origin,
    "has " + std::to_string(knots.size()) + " knots instead of " +
      std::to_string(points.size() + order));
  Require(std::is_sorted(knots.begin(), knots.end()), origin, "has knots that decrease");
  if (weights.empty())
  {
    weights.assign(points.size(), 1.0);
  }
  Require(weights.size() == points.size() &&
      std::all_of(weights.begin(), weights.end(), [](double weight) { return weight > 0.0; }),
    origin, "needs one positive weight for each control point");
  const double begin = knots[order - 1];
  const double end = knots[points.size()];
  Require(begin < end, origin, "has an empty range of knots");
  PlaneCurve curve;
  curve.kind = PlaneCurve::Kind::Nurbs;
  curve.degree = degree;
  curve.knots = std::move(knots);
  curve.points = std::move(points);
  curve.weights = std::move(weights);
  DrawingPiece piece = CurvePiece(curve, begin, end);
  piece.origin = origin;
  // The ends of a curve with repeated end knots are control points.
  const bool startsAtPoint = curve.knots[0] == begin;
  const bool endsAtPoint = curve.knots.back() == end;
  piece.first = startsAtPoint ? curve.points.front() : piece.first;
  piece.last = endsAtPoint ? curve.points.back() : piece.last;
  return piece;
}

std::vector<DrawingPiece> SplitAtKinks(const DrawingPiece& piece)
{
  // Knots that differ by less are one knot.
  constexpr double SameKnot = 1e-9;
  // Directions that differ by less are those of a smooth curve with rounded control points.
  constexpr double SmallestTurn = 1e-3;
  const PlaneCurve& curve = piece.curve;
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t count = curve.points.size();
  const double tolerance = SameKnot * (curve.knots[count] - curve.knots[degree]);
  std::vector<DrawingPiece> parts;
  std::vector<double> knots(
    curve.knots.begin(), curve.knots.begin() + static_cast<std::ptrdiff_t>(degree) + 1);
  std::size_t firstPoint = 0;
  const auto add = [&](std::size_t endPoint)
  {
    const auto slice = [&](const auto& values)
    {
      using Values = std::decay_t<decltype(values)>;
      return Values(values.begin() + static_cast<std::ptrdiff_t>(firstPoint),
        values.begin() + static_cast<std::ptrdiff_t>(endPoint));
    };
    std::vector<Point> points = slice(curve.points);
    if (degree > 1)
    {
      parts.push_back(
        NurbsPiece(curve.degree, knots, std::move(points), slice(curve.weights), piece.origin));
    }
    else if (points.front() != points.back())
    {
      parts.push_back(LinePiece(points.front(), points.back()));
      parts.back().origin = piece.origin;
    }
  };
  for (std::size_t i = degree + 1; i < count;)
  {
    const double knot = curve.knots[i];
    std::size_t end = i;
    while (end < count && curve.knots[end] - knot <= tolerance)
    {
      ++end;
    }
    // The curve passes through a control point at a knot of full multiplicity.
    const bool isFull = end - i >= degree && knot - curve.knots[degree] > tolerance &&
      curve.knots[count] - knot > tolerance;
    const std::size_t next = end - degree - 1;
    const bool turns = isFull &&
      (degree == 1 || next == i ||
        std::abs(AngleBetween(curve.points[i - 1] - curve.points[i - 2],
          curve.points[next + 1] - curve.points[next])) > SmallestTurn);
    if (turns)
    {
      knots.insert(knots.end(), degree + 1, knot);
      add(i);
      knots.assign(degree + 1, knot);
      firstPoint = next;
    }
    else
    {
      knots.insert(knots.end(), curve.knots.begin() + static_cast<std::ptrdiff_t>(i),
        curve.knots.begin() + static_cast<std::ptrdiff_t>(end));
    }
    i = end;
  }
  if (parts.empty() && degree > 1)
  {
    return { piece };
  }
  knots.insert(
    knots.end(), curve.knots.begin() + static_cast<std::ptrdiff_t>(count), curve.knots.end());
  add(count);
  return parts;
}

DrawingPiece BezierPiece(std::vector<Point> points)
{
  std::vector<double> knots(points.size(), 0.0);
  knots.resize(2 * points.size(), 1.0);
  const int degree = static_cast<int>(points.size()) - 1;
  return NurbsPiece(degree, std::move(knots), std::move(points), {}, "a Bézier curve");
}
}
