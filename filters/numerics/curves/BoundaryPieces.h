#pragma once

#include "BoundarySides.h"
#include "PlaneCurve.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Indices of the curves of a domain's segments: per loop, of the segment after each vertex, −1 if it
/// has none.
using SegmentCurves = std::vector<std::vector<int>>;

/// The curves that the boundary of a domain samples.
struct CurvesOfSegments
{
  std::vector<PlaneCurve> curves; ///< No lines.
  SegmentCurves ofSegment;        ///< Empty: no segment has a curve.
};

/// The point where the boundary begins to follow a curve, or −1, the polyline. As a SideStart it is
/// valid for every polyline with a vertex there.
struct CurveStart
{
  Point place = Point::Zero();
  int curve = -1;
  int loop = -1; ///< As in SideStart.
};

/// Curves and where the boundary follows them.
struct CurvedBoundary
{
  std::vector<PlaneCurve> curves;
  std::vector<CurveStart> starts; ///< Loop after loop; none on loops without curves.

  bool IsEmpty() const { return this->starts.empty(); }
};

/// What a side is declared to be.
struct CurveDeclaration
{
  enum class Kind
  {
    Line, ///< The polyline itself.
    Circle,
    Ellipse,
    Spline
  };
  std::string side;
  Kind kind = Kind::Line;
};

/// Curves of a domain that a user requests.
struct CurveRequest
{
  std::vector<CurveDeclaration> declared;
  bool findsArcs = false; ///< Recognises arcs of circles on all other sides.

  bool IsEmpty() const { return this->declared.empty() && !this->findsArcs; }
};

/// Distance, relative to the diagonal, that the points of a domain may have from a curve declared or
/// given for them.
constexpr double CurveReach = 1e-6;

/// Returns the curves of a domain (docs/method.md §17.2): those declared for sides, on other segments
/// those given, on other segments arcs that are recognised, if that is requested.
///
/// A declared circle or ellipse is fitted to each piece of the side; if that misses a point, to each
/// part of it between corners. It leads through the ends of the part. A spline is fitted between
/// corners. Throws Error if a side does not exist or is declared twice, a piece has too few points, or
/// a curve misses a point by more than CurveReach times the diagonal.
CurvesOfSegments FindCurves(const PlanarDomain& domain, const BoundarySides& sides,
  const CurveRequest& request, const CurvesOfSegments& given = {});

/// Returns where the boundary of a domain begins to follow its curves.
CurvedBoundary PiecesOf(const PlanarDomain& domain, const CurvesOfSegments& curves);

/// Finds the curve at positions along loops.
class CurvesAlong
{
public:
  CurvesAlong(const CurvedBoundary& boundary, const std::vector<LoopArc>& loops);

  /// Returns the index of the curve at an arc length; at a start, of the one that starts there. −1
  /// if there is none.
  int At(std::size_t loop, double at) const { return this->Along.At(loop, at); }
  /// Returns the arc lengths of the starts on a loop.
  std::vector<double> StartsOn(std::size_t loop) const;

private:
  SidesAlong Along;
};
}
