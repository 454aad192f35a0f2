#include "HolonomyConversion.h"

#include "ColumnWriting.h"
#include "FlatMapSolve.h"
#include "HolonomyRepair.h"
#include "MeshForPoints.h"
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
    const crossfield::SharedTopology topology = crossfield::ShareTopology(
      crossfield::MeshForPoints(domain.domain, {}, options.meshSize, progress.Part(0.0, 0.2)));
    corners = crossfield::CapCorners(*topology, corners);
  }
  const crossfield::HolonomyRepair repair = crossfield::RepairHolonomy(
    domain.domain, configuration, corners, options.meshSize, progress.Part(0.2, 1.0));
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
