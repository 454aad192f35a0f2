#ifndef DomainConversion_h
#define DomainConversion_h

#include "DomainPlane.h"
#include "PlanarDomain.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSet;
class vtkObject;
class vtkPolyData;

/**
 * Conversion of domains between VTK data and numerics. Every function throws crossfield::Error.
 * Data of a plane in space are converted to coordinates in that plane and back here
 * (DomainPlane.h).
 */
namespace DomainConversion
{
/** Domain and its plane in space. */
struct Domain
{
  crossfield::PlanarDomain domain;
  crossfield::DomainPlane plane;
};

/** Boundary loops in any order and orientation, and their plane in space. */
struct Boundary
{
  std::vector<crossfield::Loop> loops;
  crossfield::DomainPlane plane;
};

/** Reads loops from lines, or from the boundary of surface cells, whose points are merged as in ReadDomain. */
Boundary ReadLoops(vtkDataSet* input);

/** Returns the plane of the points that the lines and surface cells of a data set use. */
crossfield::DomainPlane FindPlane(vtkDataSet* input);

/**
 * Reads a domain from lines along its boundary, or from surface cells, which must cover it exactly
 * once. Points closer than 1e-9 of the diagonal of the bounding box are merged. If the domain is
 * flattened (DomainPlane::FlatteningWarning), `self`, unless it is null, prints the warning.
 */
Domain ReadDomain(vtkDataSet* input, vtkObject* self);

/** Reads the parts of a domain (DomainParts.h), one or several, as ReadDomain does. */
std::vector<Domain> ReadParts(vtkDataSet* input, vtkObject* self);

/**
 * Returns the surface cells of a data set as polygons, whose points are merged as in ReadDomain, with the cell array
 * `vtkOriginalCellIds`. Of cells of three dimensions these are their outer sides. Throws crossfield::Error if it has none.
 */
vtkSmartPointer<vtkPolyData> ReadSurface(vtkDataSet* input);

/** Writes one closed polyline per loop in the plane z = 0. */
void WriteLoops(const std::vector<crossfield::Loop>& loops, vtkPolyData* output);
}

#endif
