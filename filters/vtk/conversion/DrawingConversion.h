#ifndef DrawingConversion_h
#define DrawingConversion_h

#include "DrawingOutline.h"

class vtkPolyData;

/** Conversion of drawings. */
namespace DrawingConversion
{
/**
 * Writes the loops of a drawing as line cells in its plane, with their names, curves, unit and
 * largest gap (see vtkDrawingReader).
 */
void WriteOutline(const crossfield::Drawing& drawing, const crossfield::DrawingOutline& outline,
  vtkPolyData* output);

/**
 * Writes the faces of a drawing of several materials as polygons with the cell array `Material` (string), and its
 * lines with the array `Side`, in its plane.
 */
void WriteFaces(const crossfield::Drawing& drawing, vtkPolyData* output);
}

#endif
