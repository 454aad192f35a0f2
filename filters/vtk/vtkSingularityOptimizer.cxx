#include "vtkSingularityOptimizer.h"

#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "EnergyConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "SizeConversion.h"

#include "vtkDataSet.h"
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
  return port == 1 ? FilterPorts::AcceptSingularities(info)
    : port == 0    ? FilterPorts::AcceptDomain(info)
                   : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkSingularityOptimizer::FillOutputPortInformation(int port, vtkInformation* info)
{
  return FilterPorts::Produce(info, port == 0 ? "vtkPolyData" : "vtkTable");
}

//------------------------------------------------------------------------------
int vtkSingularityOptimizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain, this);
      vtkDataSet* singularities =
        FilterPorts::RequireSingularities(inputVector[1], "Singularities");
      crossfield::OptimizerOptions options;
      options.meshSize = this->MeshSize;
      options.corners = CornerConversion::ReadCorners(corners, input.plane);
      options.maximumIterations = this->MaximumIterations;
      options.tolerance = this->Tolerance;
      options.clearance = this->Clearance;
      options.keepAll = this->KeepAll;
      options.pairs = this->Pairs;
      if (this->UniformSizes || this->Pairs > 0)
      {
        options.sizes.sizing = SizeConversion::ReadSizing(this->Sizing);
      }
      if (options.sizes.sizing == crossfield::Sizing::Field)
      {
        const crossfield::PrescribedSizes sizes =
          SizeConversion::ReadSizes(domain, this->SizeArray, input.plane);
        options.sizes.field =
          crossfield::ComputeRelativeSizes(sizes, input.domain, this->MeshSize).field;
      }
      const crossfield::OptimizerResult result = crossfield::OptimizeSingularities(input.domain,
        ConfigurationConversion::ReadConfiguration(singularities, input.plane), options, progress);
      if (!result.converged && !result.aborted)
      {
        const bool isAtLimit = result.iterations >= this->MaximumIterations;
        vtkWarningMacro(<< result.reason
                        << (isAtLimit ? " More steps (MaximumIterations, --iterations) may help."
                                      : ""));
      }
      vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
      ConfigurationConversion::WriteConfiguration(result.configuration, input.plane, output);
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
}

//------------------------------------------------------------------------------
void vtkSingularityOptimizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Clearance: " << this->Clearance << "\n";
  os << indent << "KeepAll: " << this->KeepAll << "\n";
  os << indent << "UniformSizes: " << this->UniformSizes << "\n";
  os << indent << "Sizing: " << this->Sizing << "\n";
  os << indent << "SizeArray: " << this->SizeArray << "\n";
  os << indent << "Pairs: " << this->Pairs << "\n";
}
