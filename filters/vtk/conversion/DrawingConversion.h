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
}

#endif
