#ifndef CurveConversion_h
#define CurveConversion_h

#include "PlaneCurve.h"

#include <vector>

class vtkDataSet;

/**
 * Conversion of the curves that the lines of a domain sample. Coordinates are those of the
 * domain's plane (DomainPlane.h): x and y for z = const.
 *
 * - cell array `Curve` (int): index of the curve of a line; −1 on lines without a curve.
 * - field data `CurveKind` (strings, one per curve): line, circle, ellipse or nurbs.
 * - field data `CurveValues` (doubles) and `CurveOffset` (one more than curves): curve i has the
 *   values from CurveOffset[i] to CurveOffset[i + 1]. A line has none. A circle has the
 *   coordinates of its centre and of an axis, the vector from the centre to a point of the curve;
 *   an ellipse has the same and the ratio of the other semi-axis to this one. A NURBS curve has its
 *   degree, the number of control points, the knots, then x, y and the weight of each control point.
 */
namespace CurveConversion
{
/** Curves, and for each cell of the domain the index of its curve or −1. */
struct CellCurves
{
  std::vector<crossfield::PlaneCurve> curves;
  std::vector<int> ofCell; ///< Empty if the domain has no curves.
};

/** Adds the arrays to a domain. `ofCell` has one index for each cell. */
void AddCurves(const CellCurves& curves, vtkDataSet* domain);

/**
 * Reads the arrays of a domain; without the array `Curve` there are no curves. Throws
 * crossfield::Error if the arrays do not match or a curve is not valid.
 */
CellCurves ReadCurves(vtkDataSet* domain);
}

#endif
