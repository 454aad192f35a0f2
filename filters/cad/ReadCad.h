#ifndef ReadCad_h
#define ReadCad_h

#include "Drawing.h"

#include <string>

/** How a model is read. */
struct CadRequest
{
  bool allFaces = false; ///< All faces, not the largest planar one.
  double angle = 0.0;    ///< Largest turn of a face between the points of its triangles, radians.
};

/** Type of the function that the library for models exports. */
using ReadCadFunction = void(const std::string& file, const CadRequest& request,
  crossfield::Drawing& drawing, std::string& error);
/** Its name in the library. */
constexpr const char* ReadCadName = "crossfieldReadCad";

/**
 * Reads the largest planar face of a .step, .stp or .brep file. Its edges become pieces, in the plane
 * of the face: lines, circles, ellipses and NURBS curves; other curves are converted to NURBS. The
 * name of a side is the name of its edge in the .step file. Coordinates have the unit of the file. A
 * warning reports that there are further faces.
 *
 * All faces, if they are requested or none is planar, become triangles within 1e-3 of the diagonal (Drawing::surface).
 * Their regions are the names of faces, or `face1`, `face2`, ... in their order in the file, and lines are the edges
 * with a name.
 *
 * On failure `error` is one sentence and not empty: for a file that cannot be read, one without faces, and if several
 * faces that are not parallel have the largest area. No exception leaves the function.
 */
extern "C" ReadCadFunction crossfieldReadCad;

#endif
