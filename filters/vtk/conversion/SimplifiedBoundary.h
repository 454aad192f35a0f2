#ifndef SimplifiedBoundary_h
#define SimplifiedBoundary_h

#include "BoundaryPieces.h"
#include "BoundarySides.h"
#include "DomainConversion.h"

#include <string>
#include <vector>

class vtkDataSet;

/** Writes boundaries that were simplified; see vtkBoundarySimplifier for the arrays. */
namespace SimplifiedBoundary
{
/** A part of a domain, with its sides and curves, before and after simplification. */
struct Part
{
  DomainConversion::Domain given;
  DomainConversion::Domain simple;
  crossfield::BoundarySides sides;
  crossfield::CurvedBoundary boundary;
  double moved = 0.0;

  bool IsChanged() const { return this->simple.domain.loops != this->given.domain.loops; }
};

/**
 * Writes the loops of all parts, one polyline per loop or per piece of a side or a curve, with the
 * arrays of the nearest points of the input, and the names of sides unless `array` is empty.
 */
void WriteLoops(
  const std::vector<Part>& parts, const std::string& array, vtkDataSet* input, vtkDataSet* output);

/**
 * Writes how far points moved, the numbers of points, and the positions of the corners that the new
 * boundary does not have. `cornerAngle` is in radians.
 */
void WriteChanges(const std::vector<Part>& parts, double cornerAngle, vtkDataSet* output);
}

#endif
