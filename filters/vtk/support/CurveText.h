#ifndef CurveText_h
#define CurveText_h

#include "BoundaryPieces.h"

#include <string>

/** Curves of sides in text form. */
namespace CurveText
{
/**
 * Reads entries NAME:circle, NAME:ellipse, NAME:spline, NAME:line and auto, separated by semicolons.
 * Throws crossfield::Error if an entry has another form.
 */
crossfield::CurveRequest Read(const std::string& text);
}

#endif
