#ifndef SingularityRecord_h
#define SingularityRecord_h

#include "DomainPlane.h"
#include "Singularity.h"

class vtkFieldData;

/**
 * Configurations in field data: one tuple (x, y, z, quarter index) per singularity, without radii.
 */
namespace SingularityRecord
{
/** Writes a configuration; replaces an array of the same name. */
void Write(const char* name, const crossfield::Configuration& configuration,
  const crossfield::DomainPlane& plane, vtkFieldData* data);

/**
 * Reads a configuration. Returns none if there is no such array or it does not have 4 components.
 * Throws crossfield::Error if a quarter index is not an integer that a mesh can resolve.
 */
crossfield::Configuration Read(
  const char* name, const crossfield::DomainPlane& plane, vtkFieldData* data);
}

#endif
