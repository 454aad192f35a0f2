#include "vtkPerforatedCrossField.h"

#include "CornerConversion.h"
#include "CrossFieldArrays.h"
#include "DomainConversion.h"
#include "FilterRun.h"
#include "PerforatedSolve.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkPerforatedCrossField);

static_assert(static_cast<int>(crossfield::PerforatedMethod::UnitNorm) ==
    vtkPerforatedCrossField::MethodUnitNorm,
  "methods are numbered as in the numerics");
static_assert(static_cast<int>(crossfield::PerforatedStart::UnitNorm) ==
    vtkPerforatedCrossField::StartUnitNorm,
  "starts are numbered as in the numerics");
static_assert(FilterRun::Inconsistent == vtkPerforatedCrossField::InconsistentError,
  "the code that FilterRun returns is the one that the header promises");

//------------------------------------------------------------------------------
vtkPerforatedCrossField::vtkPerforatedCrossField()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkPerforatedCrossField::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPerforatedCrossField::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  this->ErrorCode = FilterRun::Run(this,
    [&](const crossfield::Progress& progress)
    {
      if (input->GetNumberOfCells() == 0)
      {
        return;
      }
      const DomainConversion::DrilledMesh cells = DomainConversion::ReadDrilledMesh(input);
      crossfield::PerforatedOptions options;
      options.method = static_cast<crossfield::PerforatedMethod>(this->Method);
      options.start = static_cast<crossfield::PerforatedStart>(this->Start);
      options.unitHoles = this->UnitHoles;
      options.reduced.maximumIterations = this->MaximumIterations;
      options.reduced.tolerance = this->Tolerance;
      options.corners =
        CornerConversion::ReadChoices(vtkDataSet::GetData(inputVector[1]), cells.plane);
      const crossfield::CrossField field =
        crossfield::SolvePerforated(cells.mesh, options, progress);
      if (!field.converged)
      {
        vtkWarningMacro("The iteration stopped after "
          << field.iterations << " steps with a relative residual of " << field.residual
          << "; the field does not solve the problem. Make the holes larger or move them.");
      }
      output->ShallowCopy(input);
      CrossFieldArrays::AddField(cells, field, output);
      CrossFieldArrays::AddReport(field, output);
      this->StageSeconds[0] = field.seconds.assemble;
      this->StageSeconds[1] = field.seconds.factor;
      this->StageSeconds[2] = field.seconds.solve;
    });
  return this->ErrorCode == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkPerforatedCrossField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == MethodUnitNorm ? "UnitNorm" : "Constrained")
     << "\n";
  os << indent << "Start: " << this->Start << "\n";
  os << indent << "UnitHoles: " << (this->UnitHoles ? "on" : "off") << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "StageSeconds: " << this->StageSeconds[0] << " " << this->StageSeconds[1] << " "
     << this->StageSeconds[2] << "\n";
}
