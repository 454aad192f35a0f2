#ifndef ProposalConversion_h
#define ProposalConversion_h

#include "DomainPlane.h"
#include "ProposedConfiguration.h"

class vtkPolyData;
class vtkTable;

/** Conversion of proposed configurations to VTK data, in the plane of the domain. */
namespace ProposalConversion
{
/** One row per proposal; see vtkConfigurationProposal. */
void WriteTable(const std::vector<crossfield::ProposedConfiguration>& proposals, double coreRadius,
  vtkTable* output);

/** The singularities of all, and the corners of each that were chosen for it, as singularities there. */
void WritePoints(const std::vector<crossfield::ProposedConfiguration>& proposals,
  const crossfield::DomainPlane& plane, vtkPolyData* output);
}

#endif
