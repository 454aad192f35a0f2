#include "HolonomyConversion.h"

#include "ColumnWriting.h"
#include "HolonomyRepair.h"
#include "PoincareHopf.h"
#include "vtkCrossFieldArrayNames.h"

namespace names = vtkCrossFieldArrayNames;

namespace HolonomyConversion
{
//------------------------------------------------------------------------------
crossfield::Configuration Repair(const DomainConversion::Domain& domain,
  const crossfield::Configuration& configuration, const Options& options, vtkFieldData* field,
  const crossfield::Progress& progress)
{
  std::vector<crossfield::CornerChoice> corners = options.corners;
  if (options.capCorners)
  {
    const auto count =
      crossfield::CountQuarters(domain.domain.loops, 0, crossfield::DefaultCornerAngle, corners);
    corners = crossfield::CapCorners(count, corners);
  }
  const crossfield::HolonomyRepair repair =
    crossfield::RepairHolonomy(domain.domain, configuration, corners, options.meshSize, progress);
  ColumnWriting::AddNumbers(field, names::RepairDistance, { repair.largestMove });
  ColumnWriting::AddNumbers(field, names::DefectBefore, repair.before);
  vtkNew<vtkDoubleArray> places;
  places->SetName(names::RepairedPositions);
  places->SetNumberOfComponents(3);
  for (const crossfield::Singularity& singularity : repair.singularities)
  {
    places->InsertNextTuple(domain.plane.ToSpace(singularity.position).data());
  }
  field->AddArray(places);
  return repair.singularities;
}
}
