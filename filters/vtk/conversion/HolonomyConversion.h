#ifndef HolonomyConversion_h
#define HolonomyConversion_h

#include "DomainPlane.h"
#include "HolonomyRepair.h"

class vtkFieldData;

/** Conversion of the report of a holonomy repair to VTK data. */
namespace HolonomyConversion
{
/**
 * Adds `RepairDistance`, the largest distance that a singularity was moved by, `RepairedPositions`
 * (3), the positions of all singularities in their order, and `DefectBefore`, the holonomy defects
 * before the repair.
 */
void WriteRepair(const crossfield::HolonomyRepair& repair, const crossfield::DomainPlane& plane,
  vtkFieldData* field);
}

#endif
