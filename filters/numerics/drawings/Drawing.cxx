#include "Drawing.h"

#include "CurveFrame.h"
#include "Error.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Maps a circle or an ellipse. The images of its axes are conjugate semi-diameters u and v; the
/// axes of the image are at the parameter t0 with tan 2 t0 = 2 u·v / (u² − v²).
void TransformConic(const AffineMap& map, DrawingPiece& piece)
{
  const Eigen::Matrix2d linear = map.leftCols<2>();
  const Point u = linear * piece.curve.axis;
  const Point v = linear * (piece.curve.ratio * TurnedLeft(piece.curve.axis));
  // Rounding errors of a similarity.
  constexpr double Rounding = 1e-12;
  const double size = std::max(u.squaredNorm(), v.squaredNorm());
  const bool isCircle = std::abs(u.squaredNorm() - v.squaredNorm()) <= Rounding * size &&
    std::abs(u.dot(v)) <= Rounding * size;
  const double start =
    isCircle ? 0.0 : 0.5 * std::atan2(2.0 * u.dot(v), u.squaredNorm() - v.squaredNorm());
  const Point axis = std::cos(start) * u + std::sin(start) * v;
  const Point other = std::cos(start) * v - std::sin(start) * u;
  if (!(std::abs(Cross(u, v)) > Rounding * size))
  {
    throw Error("A scale of zero flattens " + piece.origin + "; remove it from the drawing.");
  }
  const double direction = Cross(axis, other) > 0.0 ? 1.0 : -1.0;
  piece.curve.kind = isCircle ? PlaneCurve::Kind::Circle : PlaneCurve::Kind::Ellipse;
  piece.curve.centre = Apply(map, piece.curve.centre);
  piece.curve.axis = axis;
  piece.curve.ratio = isCircle ? 1.0 : other.norm() / axis.norm();
  piece.begin = direction * (piece.begin - start);
  piece.end = direction * (piece.end - start);
}
}

void Drawing::FindPlane(const Eigen::Matrix3Xd& points)
{
  this->plane = DomainPlane::Find(points);
  const std::string warning = this->plane.FlatteningWarning();
  if (!warning.empty())
  {
    this->warnings.push_back(warning);
  }
}

DrawingPiece LinePiece(const Point& first, const Point& last)
{
  DrawingPiece piece;
  piece.first = first;
  piece.last = last;
  return piece;
}

Point PointAt(const DrawingPiece& piece, double parameter)
{
  if (parameter == piece.begin || parameter == piece.end)
  {
    return parameter == piece.begin ? piece.first : piece.last;
  }
  if (piece.curve.kind == PlaneCurve::Kind::Line)
  {
    return piece.first +
      (parameter - piece.begin) / (piece.end - piece.begin) * (piece.last - piece.first);
  }
  return FrameOf(piece.curve, parameter).place;
}

std::vector<double> SmoothParts(const DrawingPiece& piece)
{
  std::vector<double> parts = { piece.begin };
  const double low = std::min(piece.begin, piece.end);
  const double high = std::max(piece.begin, piece.end);
  // Parts that are not only rounding errors.
  const double shortest = 1e-9 * (high - low);
  std::vector<double> inner;
  if (piece.curve.kind == PlaneCurve::Kind::Nurbs)
  {
    inner = piece.curve.knots;
  }
  else if (piece.curve.kind == PlaneCurve::Kind::Ellipse)
  {
    for (double at = std::ceil(low / (Pi / 2.0)); at * (Pi / 2.0) < high; at += 1.0)
    {
      inner.push_back(at * (Pi / 2.0));
    }
  }
  if (piece.end < piece.begin)
  {
    std::reverse(inner.begin(), inner.end());
  }
  for (const double at : inner)
  {
    if (at - low > shortest && high - at > shortest && std::abs(at - parts.back()) > shortest)
    {
      parts.push_back(at);
    }
  }
  parts.push_back(piece.end);
  return parts;
}

DrawingPiece CurvePiece(const PlaneCurve& curve, double begin, double end)
{
  DrawingPiece piece;
  piece.curve = curve;
  piece.begin = begin;
  piece.end = end;
  piece.first = FrameOf(curve, begin).place;
  piece.last = FrameOf(curve, end).place;
  return piece;
}

AffineMap IdentityMap()
{
  return AffineMap::Identity();
}

AffineMap Compose(const AffineMap& outer, const AffineMap& inner)
{
  AffineMap result;
  result.leftCols<2>() = outer.leftCols<2>() * inner.leftCols<2>();
  result.col(2) = Apply(outer, inner.col(2));
  return result;
}

Point Apply(const AffineMap& map, const Point& point)
{
  return map.leftCols<2>() * point + map.col(2);
}

void Transform(const AffineMap& map, DrawingPiece& piece)
{
  const bool isConic =
    piece.curve.kind == PlaneCurve::Kind::Circle || piece.curve.kind == PlaneCurve::Kind::Ellipse;
  if (isConic)
  {
    TransformConic(map, piece);
  }
  for (Point& point : piece.curve.points)
  {
    point = Apply(map, point);
  }
  piece.first = Apply(map, piece.first);
  piece.last = Apply(map, piece.last);
}
}
