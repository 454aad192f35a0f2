#include "vtkCrossFieldSolver.h"

#include "CrossFieldArrays.h"
#include "DrilledMeshConversion.h"
#include "FilterRun.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkUnstructuredGrid.h"

//------------------------------------------------------------------------------
int vtkCrossFieldSolver::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  return FilterRun::Run(
    this, this->ErrorCode, input,
    [&](const crossfield::Progress& progress)
    {
      this->Compute(
        DrilledMeshConversion::ReadDrilledMesh(input), inputVector, progress, outputVector);
    },
    [&](const char* sentence) { this->ReportFailure(sentence, outputVector); });
}

//------------------------------------------------------------------------------
void vtkCrossFieldSolver::Publish(const DrilledMeshConversion::DrilledMesh& cells,
  const crossfield::SolvedField& field, const char* advice, vtkUnstructuredGrid* input,
  vtkUnstructuredGrid* output)
{
  if (!field.converged)
  {
    vtkWarningMacro("The iteration stopped after "
      << field.iterations << " steps with a relative residual of " << field.residual << "; "
      << advice);
  }
  output->ShallowCopy(input);
  CrossFieldArrays::AddField(cells, field, this->Arrays, output);
  CrossFieldArrays::AddReport(field, output);
  this->StageSeconds[0] = field.seconds.assemble;
  this->StageSeconds[1] = field.seconds.factor;
  this->StageSeconds[2] = field.seconds.solve;
}

//------------------------------------------------------------------------------
void vtkCrossFieldSolver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Arrays: " << this->Arrays << "\n";
  os << indent << "StageSeconds: " << this->StageSeconds[0] << " " << this->StageSeconds[1] << " "
     << this->StageSeconds[2] << "\n";
}
