#include "HolonomyConversion.h"

#include "ColumnWriting.h"
#include "vtkCrossFieldArrayNames.h"

namespace names = vtkCrossFieldArrayNames;

namespace HolonomyConversion
{
//------------------------------------------------------------------------------
void WriteRepair(const crossfield::HolonomyRepair& repair, const crossfield::DomainPlane& plane,
  vtkFieldData* field)
{
  ColumnWriting::AddNumbers(field, names::RepairDistance, { repair.largestMove });
  ColumnWriting::AddNumbers(field, names::DefectBefore, repair.before);
  vtkNew<vtkDoubleArray> positions;
  positions->SetName(names::RepairedPositions);
  positions->SetNumberOfComponents(3);
  for (const crossfield::Singularity& singularity : repair.singularities)
  {
    positions->InsertNextTuple(plane.ToSpace(singularity.position).data());
  }
  field->AddArray(positions);
}

//------------------------------------------------------------------------------
void WriteStretch(const std::optional<crossfield::FlatteningReport>& report, vtkFieldData* field)
{
  const std::string reason = report ? crossfield::DescribeStretch(*report) : std::string();
  if (!reason.empty())
  {
    ColumnWriting::AddNumbers(field, names::PredictedStretch, { report->PredictedStretch() });
    ColumnWriting::AddText(field, names::StretchReason, reason);
  }
}
}
