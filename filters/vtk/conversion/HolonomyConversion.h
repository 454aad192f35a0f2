#ifndef HolonomyConversion_h
#define HolonomyConversion_h

#include "DomainPlane.h"
#include "FlatteningReport.h"
#include "HolonomyRepair.h"

#include <optional>

class vtkFieldData;

/** Conversion of reports on holonomy to VTK data. */
namespace HolonomyConversion
{
/**
 * Adds `RepairDistance`, the largest distance that a singularity was moved by, `RepairedPositions`
 * (3), the positions of all singularities in their order, and `DefectBefore`, the holonomy defects
 * before the repair.
 */
void WriteRepair(const crossfield::HolonomyRepair& repair, const crossfield::DomainPlane& plane,
  vtkFieldData* field);

/**
 * Adds `PredictedStretch` (FlatteningReport::PredictedStretch) and `StretchReason`, a sentence, if
 * inner loops had to be turned for the map.
 */
void WriteStretch(const std::optional<crossfield::FlatteningReport>& report, vtkFieldData* field);
}

#endif
