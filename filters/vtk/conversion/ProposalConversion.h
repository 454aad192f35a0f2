#ifndef ProposalConversion_h
#define ProposalConversion_h

#include "DomainPlane.h"
#include "ProposedConfiguration.h"

class vtkPolyData;
class vtkTable;

/** Conversion of proposed configurations to VTK data in space. */
namespace ProposalConversion
{
/** Writes one row per proposal; see vtkConfigurationProposal. */
void WriteTable(const std::vector<crossfield::ProposedConfiguration>& proposals, double coreRadius,
  vtkTable* output);

/**
 * Writes the singularities of all proposals, and the corners chosen for each as singularities on
 * the boundary.
 */
void WritePoints(const std::vector<crossfield::ProposedConfiguration>& proposals,
  const crossfield::DomainPlane& plane, vtkPolyData* output);
}

#endif
