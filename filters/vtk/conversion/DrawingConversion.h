#ifndef DrawingConversion_h
#define DrawingConversion_h

#include "DrawingOutline.h"
#include "LineNetwork.h"

class vtkPolyData;

/** Conversion of drawings. */
namespace DrawingConversion
{
/**
 * Writes the loops of a drawing as line cells in its plane, with their names, curves, unit and
 * largest gap, and the lines inside with their names (see vtkDrawingReader).
 */
void WriteOutline(const crossfield::Drawing& drawing, const crossfield::DrawingOutline& outline,
  const std::vector<crossfield::DrawnLine>& inner, vtkPolyData* output);

/**
 * Writes the faces of a drawing of several materials as polygons with the cell array `Material` (string), and its
 * lines with the array `Side`, in its plane, and the lines inside.
 */
void WriteFaces(const crossfield::Drawing& drawing, const std::vector<crossfield::DrawnLine>& inner,
  vtkPolyData* output);

/**
 * Writes the polygons of a surface in space, with the cell array `Material` (string) if it has several regions, and
 * its lines with the array `Side` (string) if it has any, and the unit.
 */
void WriteSurface(const crossfield::Drawing& drawing, vtkPolyData* output);
}

#endif
