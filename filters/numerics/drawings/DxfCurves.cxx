#include "DxfCurves.h"

#include "CurvePieces.h"
#include "Error.h"
#include "ThroughPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// A vertex of a polyline with the bulge of the segment after it.
struct BulgeVertex
{
  Point place = Point::Zero();
  double bulge = 0.0;
};

std::vector<DrawingPiece> Polyline(const std::vector<BulgeVertex>& vertices, bool isClosed)
{
  std::vector<DrawingPiece> pieces;
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < vertices.size(); ++i)
  {
    const Point& next = vertices[(i + 1) % vertices.size()].place;
    if (vertices[i].place != next)
    {
      pieces.push_back(BulgePiece(vertices[i].place, next, vertices[i].bulge));
    }
  }
  return pieces;
}

std::vector<BulgeVertex> LightVertices(const DxfObject& entity)
{
  std::vector<BulgeVertex> vertices;
  for (const DxfGroup& group : entity.All())
  {
    if (group.code == 10)
    {
      vertices.emplace_back();
      vertices.back().place.x() = DxfObject::NumberOf(group);
    }
    else if (group.code == 20 && !vertices.empty())
    {
      vertices.back().place.y() = DxfObject::NumberOf(group);
    }
    else if (group.code == 42 && !vertices.empty())
    {
      vertices.back().bulge = DxfObject::NumberOf(group);
    }
  }
  return vertices;
}

std::vector<BulgeVertex> HeavyVertices(const std::vector<DxfObject>& objects)
{
  std::vector<BulgeVertex> vertices;
  for (const DxfObject& object : objects)
  {
    constexpr int ControlPointOfFrame = 16;
    if ((object.Integer(70) & ControlPointOfFrame) == 0)
    {
      vertices.push_back({ object.Place(10), object.Number(42) });
    }
  }
  return vertices;
}

/// Returns whether knots are at equal distances, up to the digits of a file.
bool AreEven(const std::vector<double>& knots)
{
  constexpr double Rounding = 1e-6;
  const double step = (knots.back() - knots.front()) / static_cast<double>(knots.size() - 1);
  for (std::size_t i = 1; i < knots.size(); ++i)
  {
    if (std::abs(knots[i] - knots[i - 1] - step) > Rounding * step)
    {
      return false;
    }
  }
  return true;
}

/// The bit of group 70 that says that a SPLINE is closed.
constexpr int Closed = 1;

std::vector<DrawingPiece> Spline(const DxfObject& entity)
{
  std::vector<Point> control = entity.Places(10);
  if (control.empty())
  {
    std::vector<Point> through = entity.Places(11);
    if (through.size() < 2)
    {
      throw Error("There are too few points in " + entity.Origin() + "; correct or remove it.");
    }
    const bool isPeriodic =
      (entity.Integer(70) & Closed) != 0 && !entity.Has(12) && !entity.Has(13);
    if ((entity.Integer(70) & Closed) != 0 && through.front() != through.back())
    {
      through.push_back(through.front());
    }
    EndTangents tangents;
    if (entity.Has(12))
    {
      tangents.first = entity.Place(12);
    }
    if (entity.Has(13))
    {
      tangents.last = entity.Place(13);
    }
    return { ThroughPoints(through, isPeriodic, tangents) };
  }
  std::vector<double> knots = entity.Numbers(40);
  std::vector<double> weights = entity.Numbers(41);
  const int degree = entity.Integer(71, 3);
  DrawingPiece piece = NurbsPiece(degree, knots, control, weights, entity.Origin());
  if ((entity.Integer(70) & Closed) != 0 && piece.first != piece.last && AreEven(knots))
  {
    // The first control points follow the last ones once more.
    const double step = (knots.back() - knots.front()) / static_cast<double>(knots.size() - 1);
    for (std::size_t i = 0; i < static_cast<std::size_t>(degree); ++i)
    {
      control.push_back(control[i]);
      knots.push_back(knots.back() + step);
      if (!weights.empty())
      {
        weights.push_back(weights[i]);
      }
    }
    piece =
      NurbsPiece(degree, std::move(knots), std::move(control), std::move(weights), entity.Origin());
    piece.last = piece.first;
  }
  return SplitAtKinks(piece);
}

void AddPieces(const DxfObject& entity, const std::vector<DxfObject>& vertices,
  std::vector<DrawingPiece>& pieces)
{
  const std::string_view type = entity.Type();
  const std::string origin = entity.Origin();
  if (type == "LINE")
  {
    const DrawingPiece line = LinePiece(entity.Place(10), entity.Place(11));
    if (line.first != line.last)
    {
      pieces.push_back(line);
    }
  }
  else if (type == "CIRCLE")
  {
    pieces.push_back(ArcPiece(entity.Place(10), entity.Number(40), 0.0, 360.0, origin));
  }
  else if (type == "ARC")
  {
    pieces.push_back(ArcPiece(
      entity.Place(10), entity.Number(40), entity.Number(50), entity.Number(51, 360.0), origin));
  }
  else if (type == "ELLIPSE")
  {
    const double begin = entity.Number(41, 0.0);
    double end = entity.Number(42, 2.0 * Pi);
    end = end <= begin ? end + 2.0 * Pi : end;
    pieces.push_back(
      EllipsePiece(entity.Place(10), entity.Place(11), entity.Number(40, 1.0), begin, end, origin));
  }
  else if (type == "SPLINE")
  {
    pieces = Spline(entity);
  }
  else
  {
    const bool isClosed = (entity.Integer(70) & 1) != 0;
    pieces =
      Polyline(type == "LWPOLYLINE" ? LightVertices(entity) : HeavyVertices(vertices), isClosed);
  }
}
}

bool IsDxfCurve(std::string_view type)
{
  constexpr std::array<std::string_view, 7> Curves = { "LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE",
    "LWPOLYLINE", "POLYLINE" };
  return std::find(Curves.begin(), Curves.end(), type) != Curves.end();
}

AffineMap DxfEntityMap(const DxfObject& entity)
{
  AffineMap map = IdentityMap();
  // Directions are written with few digits.
  constexpr double Rounding = 1e-6;
  const double x = entity.Number(210, 0.0);
  const double y = entity.Number(220, 0.0);
  const double given = entity.Number(230, 1.0);
  // The normal of a SPLINE is optional; some programs write 0, 0, 0.
  const double z = entity.Type() == "SPLINE" && given == 0.0 ? 1.0 : given;
  if (std::abs(x) > Rounding || std::abs(y) > Rounding || z == 0.0)
  {
    throw Error("The plane of " + entity.Origin() +
      " is not parallel to the plane z = 0 of the drawing; flatten the drawing.");
  }
  // The arbitrary axis algorithm of DXF yields the axes (−1, 0) and (0, 1) for −z.
  map(0, 0) = z < 0.0 ? -1.0 : 1.0;
  return map;
}

std::vector<DrawingPiece> DxfCurves(const DxfObject& entity, const std::vector<DxfObject>& vertices)
{
  std::vector<DrawingPiece> pieces;
  AddPieces(entity, vertices, pieces);
  const std::string_view type = entity.Type();
  const AffineMap map = DxfEntityMap(entity);
  const bool isMirrored = map(0, 0) < 0.0;
  const bool isOpenAgainstFlag = type == "SPLINE" && !pieces.empty() &&
    (entity.Integer(70) & Closed) != 0 && pieces.front().first != pieces.back().last;
  for (DrawingPiece& piece : pieces)
  {
    piece.origin = entity.Origin() +
      (isOpenAgainstFlag ? " (whose flag says that it is closed, although its ends differ)" : "");
    if (isMirrored && type == "ELLIPSE")
    {
      // Centre and axis are those of the drawing; seen from below, parameters run clockwise.
      piece = EllipsePiece(piece.curve.centre, piece.curve.axis, piece.curve.ratio, -piece.begin,
        -piece.end, piece.origin);
    }
    else if (isMirrored && type != "LINE" && type != "SPLINE")
    {
      Transform(map, piece);
    }
  }
  return pieces;
}
}
