#ifndef SingularityRecord_h
#define SingularityRecord_h

#include "DomainPlane.h"
#include "Singularity.h"

class vtkFieldData;

/** A configuration in field data: one tuple (x, y, z, quarter index) for each singularity, without radii. */
namespace SingularityRecord
{
/** Replaces an array of this name. */
void Write(const char* name, const crossfield::Configuration& configuration,
  const crossfield::DomainPlane& plane, vtkFieldData* data);

/**
 * Nothing where there is no such array or it does not have 4 components. Throws crossfield::Error when a
 * quarter index is not an integer that a mesh can resolve.
 */
crossfield::Configuration Read(
  const char* name, const crossfield::DomainPlane& plane, vtkFieldData* data);
}

#endif
