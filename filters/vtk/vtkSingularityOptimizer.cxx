#include "vtkSingularityOptimizer.h"

#include "CornerConversion.h"
#include "DomainConversion.h"
#include "EnergyConversion.h"
#include "FilterRun.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkSingularityOptimizer);

//------------------------------------------------------------------------------
vtkSingularityOptimizer::vtkSingularityOptimizer()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkSingularityOptimizer::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSingularityOptimizer::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSingularityOptimizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* singularities = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  this->ErrorCode = FilterRun::Run(this,
    [&](const crossfield::Progress& progress)
    {
      if (domain->GetNumberOfCells() == 0)
      {
        return;
      }
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain);
      crossfield::OptimizerOptions options;
      options.meshSize = this->MeshSize;
      options.corners = CornerConversion::ReadChoices(corners, input.plane);
      options.maximumIterations = this->MaximumIterations;
      options.tolerance = this->Tolerance;
      const crossfield::OptimizerResult result = crossfield::OptimizeSingularities(input.domain,
        DomainConversion::ReadConfiguration(singularities, input.plane), options, progress);
      if (!result.converged && !result.aborted)
      {
        vtkWarningMacro(<< result.reason);
      }
      vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
      CornerConversion::WriteConfiguration(result.configuration, input.plane, output);
      EnergyConversion::WriteOptimizerReport(result, output);
      EnergyConversion::WriteHistory(result, vtkTable::GetData(outputVector, 1));
      if (result.aborted)
      {
        FilterRun::KeepAbortedOutput(this, 0);
      }
      else
      {
        progress.Report(1.0);
      }
    });
  return this->ErrorCode == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkSingularityOptimizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
