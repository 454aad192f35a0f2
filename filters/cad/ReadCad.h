#ifndef ReadCad_h
#define ReadCad_h

#include "Drawing.h"

#include <string>

/** Type of the function that the library for models exports. */
using ReadCadFunction = void(
  const std::string& file, crossfield::Drawing& drawing, std::string& error);
/** Its name in the library. */
constexpr const char* ReadCadName = "crossfieldReadCad";

/**
 * Reads the largest planar face of a .step, .stp or .brep file. Its edges become pieces, in the plane
 * of the face: lines, circles, ellipses and NURBS curves; other curves are converted to NURBS. The
 * name of a side is the name of its edge in the .step file. Coordinates have the unit of the file. A
 * warning reports that there are further faces. On failure `error` is one sentence and not empty:
 * for a file that cannot be read, one without planar faces, and if several faces that are not
 * parallel have the largest area. No exception leaves the function.
 */
extern "C" ReadCadFunction crossfieldReadCad;

#endif
