#ifndef HolonomyConversion_h
#define HolonomyConversion_h

#include "CornerClassification.h"
#include "DomainConversion.h"
#include "Progress.h"

class vtkFieldData;

/** Repair of holonomy defects in filters; every function throws crossfield::Error. */
namespace HolonomyConversion
{
struct Options
{
  std::vector<crossfield::CornerChoice> corners;
  bool capCorners = false;
  double meshSize = 0.0;
};

/**
 * The singularities, moved the least way to where no inner loop has a defect. Adds to the field data
 * `RepairDistance`, the longest way of one, `RepairedPositions` (3), the places of all in their order, and
 * `DefectBefore`.
 */
crossfield::Configuration Repair(const DomainConversion::Domain& domain,
  const crossfield::Configuration& configuration, const Options& options, vtkFieldData* field,
  const crossfield::Progress& progress);
}

#endif
