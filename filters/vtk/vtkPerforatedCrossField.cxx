#include "vtkPerforatedCrossField.h"

#include "CornerConversion.h"
#include "DrilledMeshConversion.h"
#include "FilterPorts.h"
#include "PerforatedSolve.h"
#include "SingularityRecord.h"
#include "ViewText.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkPerforatedCrossField);

static_assert(static_cast<int>(crossfield::PerforatedMethod::UnitNorm) ==
    vtkPerforatedCrossField::MethodUnitNorm,
  "methods are numbered as in the numerics");
static_assert(
  static_cast<int>(crossfield::PerforatedStart::UnitNorm) == vtkPerforatedCrossField::StartUnitNorm,
  "starts are numbered as in the numerics");

namespace
{
/** Returns the text of the summary of a field. */
std::string Describe(const crossfield::SolvedField& field)
{
  if (field.unwantedSingularities == 0)
  {
    return "No unwanted singularities.";
  }
  return std::to_string(field.unwantedSingularities) +
    (field.unwantedSingularities == 1 ? " unwanted singularity" : " unwanted singularities") +
    ", counted by quarter index: " +
    (field.count.Consistent()
        ? "the norm vanishes there. Use the method Unit Norm, which has none."
        : "the given singularities do not have the sum that the domain needs.");
}

void WriteSummary(const std::string& text, bool isAlarm, vtkInformationVector* outputVector)
{
  ViewText::Write(vtkCrossFieldArrayNames::Summary, ViewText::WrapLines(text), isAlarm,
    vtkTable::GetData(outputVector, 1));
}
}

//------------------------------------------------------------------------------
vtkPerforatedCrossField::vtkPerforatedCrossField()
  : vtkCrossFieldSolver(100)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkPerforatedCrossField::AddUnitHole(int row)
{
  this->UnitHoleRows.push_back(row);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPerforatedCrossField::RemoveAllUnitHoles()
{
  if (!this->UnitHoleRows.empty())
  {
    this->UnitHoleRows.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkPerforatedCrossField::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptMesh(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkPerforatedCrossField::FillOutputPortInformation(int port, vtkInformation* info)
{
  return FilterPorts::Produce(info, port == 0 ? "vtkUnstructuredGrid" : "vtkTable");
}

//------------------------------------------------------------------------------
void vtkPerforatedCrossField::ReportFailure(
  const char* sentence, vtkInformationVector* outputVector)
{
  WriteSummary(sentence, true, outputVector);
}

//------------------------------------------------------------------------------
void vtkPerforatedCrossField::Compute(const DrilledMeshConversion::DrilledMesh& cells,
  vtkInformationVector** inputVector, const crossfield::Progress& progress,
  vtkInformationVector* outputVector)
{
  crossfield::PerforatedOptions options;
  options.method = static_cast<crossfield::PerforatedMethod>(this->Method);
  options.start = static_cast<crossfield::PerforatedStart>(this->Start);
  options.unitHoles = this->UnitHoles;
  options.unitHoleRows = this->UnitHoleRows;
  options.globalConstraint = this->GlobalConstraint;
  options.epsilon = this->Epsilon;
  options.reduced.maximumIterations = this->GetMaximumIterations();
  options.reduced.tolerance = this->GetTolerance();
  options.corners = CornerConversion::ReadCorners(vtkDataSet::GetData(inputVector[1]), cells.plane);
  for (const crossfield::Singularity& singularity :
    SingularityRecord::Read(vtkCrossFieldArrayNames::BoundarySingularities, cells.plane,
      vtkUnstructuredGrid::GetData(inputVector[0])->GetFieldData()))
  {
    options.corners.push_back({ singularity.position, singularity.quarterIndex });
  }
  const crossfield::SolvedField field =
    crossfield::SolvePerforated(cells.topology, options, progress);
  // If the given sum is inconsistent, other singularities are unavoidable.
  if (options.method == crossfield::PerforatedMethod::Constrained && field.count.Consistent() &&
    field.unwantedSingularities > 0)
  {
    vtkWarningMacro("The field has "
      << field.unwantedSingularities
      << " unwanted singularities, counted by quarter index, where its "
         "norm vanishes. Use the method Unit Norm, which has none.");
  }
  this->Publish(cells, field,
    "the field does not solve the problem. Make the holes larger or move them.",
    vtkUnstructuredGrid::GetData(inputVector[0]), vtkUnstructuredGrid::GetData(outputVector));
  WriteSummary(Describe(field), field.unwantedSingularities > 0, outputVector);
}

//------------------------------------------------------------------------------
void vtkPerforatedCrossField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == MethodUnitNorm ? "UnitNorm" : "Constrained")
     << "\n";
  os << indent << "Start: " << this->Start << "\n";
  os << indent << "UnitHoles: " << (this->UnitHoles ? "on" : "off") << "\n";
  os << indent << "UnitHoleRows: ";
  for (const int row : this->UnitHoleRows)
  {
    os << row << " ";
  }
  os << "\n";
  os << indent << "GlobalConstraint: " << (this->GlobalConstraint ? "on" : "off") << "\n";
  os << indent << "Epsilon: " << this->Epsilon << "\n";
}
