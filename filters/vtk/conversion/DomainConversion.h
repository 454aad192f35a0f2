#ifndef DomainConversion_h
#define DomainConversion_h

#include "DomainPlane.h"
#include "PlanarDomain.h"

#include <vector>

class vtkDataSet;
class vtkPolyData;

/**
 * Conversion of domains between VTK data and numerics; every function throws crossfield::Error. This is where
 * data of a plane in space become coordinates of that plane, and back (DomainPlane.h).
 */
namespace DomainConversion
{
/** A domain, and the plane in space that it lies in. */
struct Domain
{
  crossfield::PlanarDomain domain;
  crossfield::DomainPlane plane;
};

/** The plane of the points of a data set that its lines and surface cells use. */
crossfield::DomainPlane FindPlane(vtkDataSet* input);

/**
 * Reads a domain from lines along its boundary, or from surface cells, which have to cover it once.
 * Points closer than 1e-9 of the bounding box's diagonal are one point.
 */
Domain ReadDomain(vtkDataSet* input);

/** One closed polyline per loop in the plane z = 0. */
void WriteLoops(const std::vector<crossfield::Loop>& loops, vtkPolyData* output);
}

#endif
