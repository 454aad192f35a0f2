#pragma once

#include "DomainPlane.h"
#include "PlaneCurve.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace crossfield
{
/// One curve of a drawing with its ends.
struct DrawingPiece
{
  /// A line leads from `first` to `last`; other curves from parameter `begin` to `end`, in either
  /// direction. The point at t is centre + cos t · axis + sin t · ratio · (axis turned by 90°) on a
  /// circle or an ellipse; a NURBS curve has the parameter of its knots.
  PlaneCurve curve;
  double begin = 0.0;
  double end = 1.0;
  Point first = Point::Zero(); ///< As given in the file; the curve passes within rounding errors.
  Point last = Point::Zero();
  /// Whether a line is the boundary itself. Not set on lines of a mesh or of a polygon that may be
  /// chords of an unknown curve.
  bool isExact = true;
  std::string name;   ///< Name of the side; empty if it has none.
  std::string origin; ///< What the piece is in its file, for messages: "the ARC of line 12".
};

/// A polygon of a mesh with its material.
struct DrawingFace
{
  std::vector<Point> points;
  std::string material;
};

/// A named line along edges of a surface.
struct SurfaceLine
{
  std::vector<int> points;
  std::string name;
};

/// Polygons of a mesh that is a surface in space.
struct DrawingSurface
{
  std::vector<SpacePoint> points;
  std::vector<std::vector<int>> polygons; ///< Indices of points.
  std::vector<std::string> regions;       ///< Per polygon; empty if there is one region.
  std::vector<SurfaceLine> lines;
};

/// Contents of a drawing that a boundary can consist of.
struct Drawing
{
  DrawingSurface surface; ///< If it has polygons, the drawing has nothing else.
  std::vector<DrawingPiece> pieces;
  /// The faces of a mesh, if they have several materials; `pieces` then has its lines inside as well.
  std::vector<DrawingFace> faces;
  std::string unit; ///< Unit of the coordinates, such as "mm"; empty if the file has none.
  std::vector<std::string> warnings; ///< One sentence each.
  DomainPlane plane;                 ///< Of the coordinates.

  /// Sets the plane, that of points, with a warning if it flattens them. Throws Error as
  /// DomainPlane::Find does.
  void FindPlane(const Eigen::Matrix3Xd& points);
};

/// Returns a piece that is a straight line.
DrawingPiece LinePiece(const Point& first, const Point& last);

/// Returns the point at a parameter; at `begin` and `end`, exactly the ends of the piece.
Point PointAt(const DrawingPiece& piece, double parameter);

/// Returns the parameters from `begin` to `end` between which the curve is smooth: its ends, the
/// knots of a NURBS curve, and the vertices of an ellipse.
std::vector<double> SmoothParts(const DrawingPiece& piece);

/// Returns the piece without its ends, whose curve must be complete: `first` and `last` are set to
/// the points of the curve.
DrawingPiece CurvePiece(const PlaneCurve& curve, double begin, double end);

/// An affine map: the columns are the images of the axes and of the origin.
using AffineMap = Eigen::Matrix<double, 2, 3>;

/// Returns the identity.
AffineMap IdentityMap();
/// Returns the map that applies `inner` first.
AffineMap Compose(const AffineMap& outer, const AffineMap& inner);
/// Returns the image of a point.
Point Apply(const AffineMap& map, const Point& point);

/// Maps a piece exactly: circles may become ellipses, a reflected arc has the opposite direction.
/// Throws Error if the map flattens the piece.
void Transform(const AffineMap& map, DrawingPiece& piece);
}
